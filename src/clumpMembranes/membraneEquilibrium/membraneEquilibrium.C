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
    minimiser_(type, mechanics_.neighbourOrder(), mechanics_.neighbours())
{
    if (mechanics_.shearStiffness() <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'membrane' has no model that resists shear, such as skalak:"
            << " there is no equilibrium under forces." << exit(FatalIOError);
    }
}


bool Foam::membraneEquilibrium::find
(
    const vectorField& forces,
    pointField& x,
    const membraneMinimiser::potential& touched
) const
{
    const clumpType& type = mechanics_.type();
    const scalar R = type.halfWidth();
    const scalar stiffness = mechanics_.shearStiffness()/(x.size()*sqr(R));
    constexpr scalar least = 1e-5;
    scalar part = 1000*least;
    membraneFactors factors(minimiser_.tangent());

    pointField last;
    const auto potential = [&]
    (
        const vectorField& y, vectorField& gradient, membraneTangent* tangent
    )
    {
        const scalar k = part*stiffness;
        const vectorField moved(y - last);
        gradient = k*moved - forces;
        if (tangent)
        {
            forAll(y, i)
            {
                tangent->add(i, i, k*Eigen::Matrix3d::Identity());
            }
        }
        const scalar own =
            sum((0.5*k*moved - forces) & moved)
          + mechanics_.add(y, gradient, tangent);
        return touched ? own + touched(y, gradient, tangent) : own;
    };

    for (label n = 0; n < 300 && part < 1e4; ++n)
    {
        last = x;
        if (!minimiser_.minimise(potential, factors, x, 1e-2))
        {
            x = last;
            factors.forget();
            part *= 10;
        }
        else if (part > least)
        {
            part = max(least, 0.1*part);
        }
        else if (max(mag(x - last)) < 1e-5*R)
        {
            return true;
        }
    }
    return false;
}
