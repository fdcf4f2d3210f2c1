/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "linearElastic.H"

namespace Foam
{
namespace bondModels
{
    defineTypeNameAndDebug(linearElastic, 0);
    addToRunTimeSelectionTable(bondModel, linearElastic, dictionary);
}
}
