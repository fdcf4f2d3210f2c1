/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "hertzContact.H"

namespace Foam
{
namespace contactModels
{
    defineTypeNameAndDebug(hertzContact, 0);
    addToRunTimeSelectionTable(contactModel, hertzContact, dictionary);
}
}
