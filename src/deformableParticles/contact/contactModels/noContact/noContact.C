/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "noContact.H"

namespace Foam
{
namespace contactModels
{
    defineTypeNameAndDebug(noContact, 0);
    addToRunTimeSelectionTable(contactModel, noContact, dictionary);
}
}
