/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "powerLaw.H"

namespace Foam
{
namespace damageModels
{
    defineTypeNameAndDebug(powerLaw, 0);
    addToRunTimeSelectionTable(damageModel, powerLaw, dictionary);
}
}

namespace
{

using namespace Foam;

//- C, a and b for the share of the haemoglobin
const HashTable<vector>& published()
{
    static const HashTable<vector> constants
    ({
        {"giersiepen", {3.62e-7, 2.416, 0.785}},
        {"heuserOpitz", {1.8e-8, 1.991, 0.765}},
        {"zhang", {1.228e-7, 1.9918, 0.6606}},
        {"dingHuman", {3.458e-8, 2.0639, 0.2777}},
        {"dingPorcine", {6.701e-6, 1.0981, 0.2778}},
        {"dingBovine", {9.772e-7, 1.4445, 0.2076}}
    });
    return constants;
}

}


Foam::damageModels::powerLaw::powerLaw(const dictionary& dict)
{
    checkEntries
    (
        dict,
        {
            "type", "constants", "coefficient", "stressExponent", "timeExponent",
            "limit"
        }
    );
    const word name(dict.getOrDefault<word>("constants", "none"));
    if (name == "none")
    {
        coefficient_ = getPositive(dict, "coefficient");
        stressExponent_ = getPositive(dict, "stressExponent");
        timeExponent_ = getPositive(dict, "timeExponent");
        return;
    }
    for (const char* key : {"coefficient", "stressExponent", "timeExponent"})
    {
        if (dict.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << key << "' is one of the constants " << name
                << ". Give either 'constants' or the three numbers."
                << exit(FatalIOError);
        }
    }
    if (!published().found(name))
    {
        FatalIOErrorInLookup(dict, "constants", name, published()) << exit(FatalIOError);
    }
    const vector& constants = published()[name];
    coefficient_ = constants.x();
    stressExponent_ = constants.y();
    timeExponent_ = constants.z();
}


Foam::scalar Foam::damageModels::powerLaw::advance
(
    const scalar before,
    const load& l,
    const scalar dt
) const
{
    return before + dt*std::pow(l.stress, stressExponent_/timeExponent_);
}


Foam::scalar Foam::damageModels::powerLaw::damage(const scalar history) const
{
    return coefficient_*std::pow(history, timeExponent_);
}
