/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "morse.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace gapModels
{
    defineTypeNameAndDebug(morse, 0);
    addToRunTimeSelectionTable(gapModel, morse, dictionary);
}
}


Foam::gapModels::morse::morse(const dictionary& dict)
:
    energy_(getPositive(dict, "surfaceEnergy")),
    length_(getPositive(dict, "length")),
    rest_(getNonNegativeOrDefault(dict, "restingGap", 0))
{
    checkEntries(dict, {"type", "surfaceEnergy", "length", "restingGap"});
}


Foam::contactModel::increment Foam::gapModels::morse::step
(
    const scalar gap,
    const scalar,
    const scalar,
    const radii& R,
    const medium&
) const
{
    // All lengths over l
    const scalar end = 6;
    const scalar x = max((gap - rest_)/length_, scalar(0));
    if (x >= end)
    {
        return {0, 0, 0};
    }
    const scalar Fm =
        2*constant::mathematical::pi*Foam::sqrt(R.first*R.second)*energy_;
    const scalar last = Foam::exp(-end);
    const scalar a = Foam::exp(-x) - last;
    const scalar left = end - x;
    const scalar scale = 1/(1 - last);
    const scalar e = a*scale;

    // Integrals of e and of its square from x to the end
    const scalar I1 = scale*(a - last*left);
    const scalar I2 =
        sqr(scale)*(0.5*a*(a + 2*last) - 2*last*a + sqr(last)*left);

    const bool acts = gap >= rest_;
    return
    {
        -4*Fm*length_*(I1 - I2),
        acts ? -4*Fm*(e - sqr(e)) : 0,
        acts ? max(4*Fm/length_*scale*(a + last)*(2*e - 1), scalar(0)) : 0
    };
}
