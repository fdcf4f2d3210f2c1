/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "dampingModel.H"

namespace Foam
{
    defineTypeNameAndDebug(dampingModel, 0);
    defineRunTimeSelectionTable(dampingModel, dictionary);
}
