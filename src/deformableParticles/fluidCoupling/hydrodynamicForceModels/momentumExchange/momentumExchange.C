/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "momentumExchange.H"

namespace Foam
{
namespace hydrodynamicForceModels
{
    defineTypeNameAndDebug(momentumExchange, 0);
    addToRunTimeSelectionTable(hydrodynamicForceModel, momentumExchange, dictionary);
}
}
