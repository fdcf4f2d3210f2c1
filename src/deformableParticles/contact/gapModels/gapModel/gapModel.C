/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gapModel.H"

namespace Foam
{
    defineTypeNameAndDebug(gapModel, 0);
    defineRunTimeSelectionTable(gapModel, dictionary);
}
