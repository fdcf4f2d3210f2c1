/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "rotationModel.H"

namespace Foam
{
    defineTypeNameAndDebug(rotationModel, 0);
    defineRunTimeSelectionTable(rotationModel, dictionary);
}
