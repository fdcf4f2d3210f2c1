/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "oneWayDrag.H"
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
    const volTensorField& gradient = *gradient_;
    const volVectorField& C = U.mesh().C();

    for (clumpImage& image : images)
    {
        const scalarField zeta(resistance(types_[image.typeId], mu));
        image.fluid.reset(image.x.size());

        forAll(image.x, i)
        {
            const point& x = image.x[i];
            const label celli = U.mesh().findCell(x);
            if (celli >= 0)
            {
                const vector u
                (
                    U[celli] + ((x - C[celli]) & gradient[celli])
                );
                image.fluid.f[i] = zeta[i]*(u - image.u[i]);
            }
        }
    }
}
