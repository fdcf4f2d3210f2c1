/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneEquilibrium.H"
#include "membraneFactors.H"

Foam::membraneEquilibrium::membraneEquilibrium
(
    const clumpType& type,
    const dictionary& dict
)
:
    mechanics_(type, dict),
    minimiser_(type, mechanics_.rings())
{}


bool Foam::membraneEquilibrium::find
(
    const vectorField& forces,
    pointField& x
) const
{
    const clumpType& type = mechanics_.type();
    const scalar R = type.halfWidth();
    const scalar k = 1e-5*mechanics_.shearStiffness()/(x.size()*sqr(R));
    membraneFactors factors(minimiser_.tangent());

    pointField last;
    const auto potential = [&]
    (
        const vectorField& y, vectorField& gradient, membraneTangent* tangent
    )
    {
        const vectorField moved(y - last);
        gradient = k*moved - forces;
        if (tangent)
        {
            forAll(y, i)
            {
                tangent->add(i, i, k*Eigen::Matrix3d::Identity());
            }
        }
        return
            sum((0.5*k*moved - forces) & moved)
          + mechanics_.add(y, gradient, tangent);
    };

    for (label n = 0; n < 200; ++n)
    {
        last = x;
        if (!minimiser_.minimise(potential, factors, x))
        {
            return false;
        }
        if (max(mag(x - last)) < 1e-5*R)
        {
            return true;
        }
    }
    return false;
}
