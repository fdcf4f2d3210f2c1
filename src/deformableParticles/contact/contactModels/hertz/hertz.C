/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "hertz.H"

namespace Foam
{
namespace contactModels
{
    defineTypeNameAndDebug(hertz, 0);
    addToRunTimeSelectionTable(contactModel, hertz, dictionary);
}
}
