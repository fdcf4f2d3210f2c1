/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "forcingModel.H"

namespace Foam
{
    defineTypeNameAndDebug(forcingModel, 0);
    defineRunTimeSelectionTable(forcingModel, dictionary);
}
