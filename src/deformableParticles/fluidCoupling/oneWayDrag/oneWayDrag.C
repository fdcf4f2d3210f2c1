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


template<class Action>
void Foam::oneWayDrag::visit
(
    const volVectorField& U,
    UList<clumpImage>& images,
    const Action& action
) const
{
    const volVectorField& C = U.mesh().C();
    const volTensorField& gradient = *gradient_;

    for (clumpImage& image : images)
    {
        image.fluid.reset(image.x.size());
        forAll(image.x, i)
        {
            const point& x = image.x[i];
            const label celli = U.mesh().findCell(x);
            if (celli >= 0)
            {
                action
                (
                    image, i,
                    U[celli] + ((x - C[celli]) & gradient[celli])
                );
            }
        }
    }
}


void Foam::oneWayDrag::sampleVelocity
(
    const volVectorField& U,
    UList<clumpImage>& images
)
{
    gradient_.reset(fvc::grad(U).ptr());
    visit
    (
        U, images,
        [](clumpImage& image, const label i, const vector& u)
        {
            image.fluid.f[i] = u;
            image.fluid.t[i] = vector::one;
        }
    );
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
    visit
    (
        U, images,
        [](clumpImage& image, const label i, const vector& u)
        {
            image.fluid.f[i] = u - image.u[i];
        }
    );
    for (clumpImage& image : images)
    {
        image.fluid.f *= resistance(types_[image.typeId], mu);
    }
}
