/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "stressDivergence.H"

namespace Foam
{
namespace hydrodynamicForceModels
{
    defineTypeNameAndDebug(stressDivergence, 0);
    addToRunTimeSelectionTable(hydrodynamicForceModel, stressDivergence, dictionary);
}
}
