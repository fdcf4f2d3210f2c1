/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bell.H"

namespace
{
    //- k_B [J/K], exact in the SI
    constexpr Foam::scalar boltzmann = 1.380649e-23;
}

namespace Foam
{
namespace gapModels
{
    defineTypeNameAndDebug(bell, 0);
    addToRunTimeSelectionTable(gapModel, bell, dictionary);
}
}


Foam::gapModels::bell::bell(const dictionary& dict)
{
    checkEntries
    (
        dict,
        {
            "type", "density", "reach", "onRate", "offRate", "compliance", "stiffness",
            "restLength", "temperature", "seed"
        }
    );
    values_.density = getPositive(dict, "density");
    values_.reach = getPositive(dict, "reach");
    values_.onRate = getNonNegative(dict, "onRate");
    values_.stiffness = getPositive(dict, "stiffness");
    values_.restLength =
        getNonNegativeOrDefault(dict, "restLength", values_.reach);
    values_.seed = getNumberOrDefault(dict, "seed", 1, 0, labelMax);
    offRate_ = getNonNegative(dict, "offRate");
    exponent_ =
        getFinite<scalar>(dict, "compliance")
       /(boltzmann*getPositiveOrDefault(dict, "temperature", 310));
}


Foam::scalar Foam::gapModels::bell::offRate(const scalar tension) const
{
    // No step is so short that a bond with so large a rate survives it
    return offRate_*Foam::exp(min(tension*exponent_, scalar(200)));
}
