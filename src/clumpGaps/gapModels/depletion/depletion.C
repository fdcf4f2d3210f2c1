/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "depletion.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace gapModels
{
    defineTypeNameAndDebug(depletion, 0);
    addToRunTimeSelectionTable(gapModel, depletion, dictionary);
}
}


Foam::gapModels::depletion::shape::shape(const scalar x)
:
    f(sqr(1 - x)*(1 + 2*x)),
    rest(0.5 - x*(1 - sqr(x)*(1 - 0.5*x))),
    slope(-6*x*(1 - x)),
    curvature(12*x - 6)
{
    if (x <= 0)
    {
        f = 1;
        rest = 0.5 - x;
        slope = 0;
        curvature = 0;
    }
    else if (x >= 1)
    {
        f = rest = slope = curvature = 0;
    }
}


Foam::gapModels::depletion::depletion(const dictionary& dict)
:
    energy_(getPositive(dict, "energy")),
    cells_(getBetweenOrDefault(dict, "range", 0.5, 0.05, 2))
{
    checkEntries(dict, {"type", "energy", "range"});
}


Foam::contactModel::increment Foam::gapModels::depletion::step
(
    const scalar gap,
    const scalar,
    const scalar,
    const radii& R,
    const medium& between
) const
{
    const scalar r = range(between.cellWidth, between.atWall);
    const shape s(gap/r);
    const scalar factor =
        2*constant::mathematical::pi*Foam::sqrt(R.first*R.second)*energy_;

    // The force grows as the gap closes: a negative stiffness, which the step leaves out
    return {-factor*r*s.rest, -factor*s.f, 0};
}


Foam::contactModel::pressure Foam::gapModels::depletion::surfacePressure
(
    const scalar gap,
    const scalar,
    const scalar,
    const scalar,
    const layer& between
) const
{
    const shape s(gap/between.limit);
    return
    {
        -energy_*s.f,
        energy_/between.limit*s.slope,
        -energy_/sqr(between.limit)*s.curvature
    };
}
