/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "peakStrain.H"

namespace Foam
{
namespace damageModels
{
    defineTypeNameAndDebug(peakStrain, 0);
    addToRunTimeSelectionTable(damageModel, peakStrain, dictionary);
}
}


Foam::damageModels::peakStrain::peakStrain(const dictionary& dict)
:
    lysisStrain_(getPositive(dict, "lysisStrain"))
{
    checkEntries(dict, {"type", "lysisStrain", "limit"});
}
