/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "stressDose.H"

namespace Foam
{
namespace damageModels
{
    defineTypeNameAndDebug(stressDose, 0);
    addToRunTimeSelectionTable(damageModel, stressDose, dictionary);
}
}


Foam::damageModels::stressDose::stressDose(const dictionary& dict)
:
    threshold_(getPositiveOrDefault(dict, "threshold", 3.5))
{
    checkEntries(dict, {"type", "threshold", "limit"});
}
