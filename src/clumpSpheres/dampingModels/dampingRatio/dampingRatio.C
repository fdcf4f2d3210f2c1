/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "dampingRatio.H"

namespace Foam
{
namespace dampingModels
{
    defineTypeNameAndDebug(dampingRatio, 0);
    addToRunTimeSelectionTable(dampingModel, dampingRatio, dictionary);
}
}


Foam::dampingModels::dampingRatio::dampingRatio(const dictionary& dict)
:
    beta_(getNonNegative(dict, "beta"))
{
    checkEntries(dict, {"type", "beta"});
}


Foam::bondCoefficients Foam::dampingModels::dampingRatio::coefficients
(
    const bondCoefficients& k,
    const scalar mass,
    const scalar inertia
) const
{
    return
    {
        2*beta_*Foam::sqrt(mass*k.normal),
        2*beta_*Foam::sqrt(mass*k.tangential),
        2*beta_*Foam::sqrt(inertia*k.bending),
        2*beta_*Foam::sqrt(inertia*k.torsional)
    };
}
