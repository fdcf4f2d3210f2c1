/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "elastic.H"

namespace Foam
{
namespace bondModels
{
    defineTypeNameAndDebug(elastic, 0);
    addToRunTimeSelectionTable(bondModel, elastic, dictionary);
}
}
