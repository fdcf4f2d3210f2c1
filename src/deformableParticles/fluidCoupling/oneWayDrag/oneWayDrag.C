/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "oneWayDrag.H"
#include "fieldAtSpheres.H"
#include "fvcGrad.H"
#include "mathematicalConstants.H"

Foam::scalarField Foam::oneWayDrag::resistance
(
    const clumpType& type,
    const scalar mu
)
{
    using constant::mathematical::pi;

    const scalarField& r = type.radii();
    const scalar screening = cbrt(0.75*type.volume()/pi)/sum(r);
    return screening*6*pi*mu*r;
}


void Foam::oneWayDrag::integrate
(
    const volVectorField& U,
    const scalar mu,
    const bool steady,
    UList<clumpImage>& images
)
{
    if (!steady || !gradient_.valid())
    {
        gradient_.reset(fvc::grad(U).ptr());
    }
    setFieldAtSpheres(U, *gradient_, images);
    for (clumpImage& image : images)
    {
        // Only spheres in this processor's mesh cells, where the torque is 1
        image.fluid.f -= cmptMultiply(image.fluid.t, image.u);
        image.fluid.f *= resistance(types_[image.typeId], mu);
        image.fluid.t = Zero;
    }
}
