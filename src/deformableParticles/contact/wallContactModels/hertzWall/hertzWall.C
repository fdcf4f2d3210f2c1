/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "hertzWall.H"

namespace Foam
{
namespace wallContactModels
{
    defineTypeNameAndDebug(hertzWall, 0);
    addToRunTimeSelectionTable(wallContactModel, hertzWall, dictionary);
}
}
