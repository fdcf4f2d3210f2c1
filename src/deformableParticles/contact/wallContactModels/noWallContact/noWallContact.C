/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "noWallContact.H"

namespace Foam
{
namespace wallContactModels
{
    defineTypeNameAndDebug(noWallContact, 0);
    addToRunTimeSelectionTable(wallContactModel, noWallContact, dictionary);
}
}
