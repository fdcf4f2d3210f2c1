/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallContactModel.H"

namespace Foam
{
    defineTypeNameAndDebug(wallContactModel, 0);
    defineRunTimeSelectionTable(wallContactModel, dictionary);
}
