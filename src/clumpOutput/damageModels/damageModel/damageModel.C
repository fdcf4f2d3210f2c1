/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "damageModel.H"

namespace Foam
{
    defineTypeNameAndDebug(damageModel, 0);
    defineRunTimeSelectionTable(damageModel, dictionary);
}
