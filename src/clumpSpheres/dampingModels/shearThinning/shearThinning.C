/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "shearThinning.H"

namespace Foam
{
namespace dampingModels
{
    defineTypeNameAndDebug(shearThinning, 0);
    addToRunTimeSelectionTable(dampingModel, shearThinning, dictionary);
}
}


Foam::dampingModels::shearThinning::shearThinning(const dictionary& dict)
:
    lowRate_(selectModel<dampingModel>(getDict(dict, "lowRate"))),
    thinning_
    (
        getBetween(dict, "highRateFraction", smallestEntry, 1),
        getPositive(dict, "transitionRate"),
        getBetween(dict, "exponent", 0, 1)
    )
{
    checkEntries
    (
        dict,
        {"type", "lowRate", "highRateFraction", "transitionRate", "exponent"}
    );

    if (lowRate_->thinning().active())
    {
        FatalIOErrorInFunction(getDict(dict, "lowRate"))
            << "Entry 'lowRate': the coefficients of the model '"
            << lowRate_->type() << "' depend on the rate themselves."
            << exit(FatalIOError);
    }
}


Foam::bondCoefficients Foam::dampingModels::shearThinning::coefficients
(
    const bondCoefficients& k,
    const scalar mass,
    const scalar inertia
) const
{
    return lowRate_->coefficients(k, mass, inertia);
}
