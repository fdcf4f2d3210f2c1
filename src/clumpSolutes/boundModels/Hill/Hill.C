/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "Hill.H"

namespace Foam
{
namespace boundModels
{
    defineTypeNameAndDebug(Hill, 0);
    addToRunTimeSelectionTable(boundModel, Hill, dictionary);
}
}


Foam::boundModels::Hill::Hill(const dictionary& dict)
:
    capacity_(getPositive(dict, "capacity")),
    halfConcentration_(getPositive(dict, "halfConcentration")),
    exponent_(getBetween(dict, "exponent", 1, 10))
{
    checkEntries(dict, {"type", "capacity", "halfConcentration", "exponent"});
}


Foam::scalar Foam::boundModels::Hill::bound(const scalar c) const
{
    // The smaller of the two powers does not overflow
    const scalar x = c/halfConcentration_;
    if (x < 1)
    {
        const scalar q = std::pow(x, exponent_);
        return capacity_*q/(1 + q);
    }
    return capacity_/(1 + std::pow(x, -exponent_));
}


Foam::scalar Foam::boundModels::Hill::capacity(const scalar c) const
{
    const scalar x = c/halfConcentration_;
    const scalar power = x < 1 ? std::pow(x, exponent_ - 1) : std::pow(x, -exponent_ - 1);
    const scalar q = x < 1 ? x*power : std::pow(x, -exponent_);
    return capacity_/halfConcentration_*exponent_*power/sqr(1 + q);
}
