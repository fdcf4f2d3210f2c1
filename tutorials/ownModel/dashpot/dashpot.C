/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "dashpot.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntries.H"

namespace Foam
{
namespace dampingModels
{
    defineTypeNameAndDebug(dashpot, 0);
    addToRunTimeSelectionTable(dampingModel, dashpot, dictionary);
}
}


Foam::dampingModels::dashpot::dashpot(const dictionary& dict)
{
    // Misspelt entries are errors, and so are values that make no sense
    checkEntries(dict, {"type", "translation", "rotation"});
    translation_ = getPositive(dict, "translation");
    rotation_ = getPositive(dict, "rotation");
}


Foam::bondCoefficients Foam::dampingModels::dashpot::coefficients
(
    const bondCoefficients&,
    const scalar,
    const scalar
) const
{
    return {translation_, translation_, rotation_, rotation_};
}
