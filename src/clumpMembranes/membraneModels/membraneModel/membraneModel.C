/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneModel.H"

namespace Foam
{
    defineTypeNameAndDebug(membraneModel, 0);
    defineRunTimeSelectionTable(membraneModel, dictionary);
}
