/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "foldLocking.H"
#include "surfaceFold.H"

Foam::foldLocking::foldLocking
(
    const closedSurface& surface,
    const pointField& x,
    const scalar shearStiffness
)
:
    surface_(surface),
    stiffness_(10*shearStiffness/surface.nNodes()),
    from_(surface.hinges().size())
{
    forAll(from_, e)
    {
        from_[e] =
            max(scalar(2), mag(surfaceFold(surface.hinges()[e], x).angle));
    }
}


Foam::scalar Foam::foldLocking::add
(
    const pointField& x,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    scalar energy = 0;
    forAll(from_, e)
    {
        const closedSurface::hinge& h = surface_.hinges()[e];
        if (surfaceFold::isOpen(h, x))
        {
            continue;
        }
        const surfaceFold f(h, x);
        const scalar beyond = mag(f.angle) - from_[e];
        if (beyond <= 0)
        {
            continue;
        }
        energy += stiffness_*pow3(beyond);

        const scalar moment = 3*stiffness_*sqr(beyond)*sign(f.angle);
        const FixedList<label, 4> nodes(surfaceFold::nodes(h));
        forAll(nodes, k)
        {
            gradient[nodes[k]] += moment*f.gradient[k];
        }
        if (tangent)
        {
            vectorField g(x.size(), Zero);
            forAll(nodes, k)
            {
                g[nodes[k]] = f.gradient[k];
            }
            tangent->addProduct(6*stiffness_*beyond, g);
        }
    }
    return energy;
}
