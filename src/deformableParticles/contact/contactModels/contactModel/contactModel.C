/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactModel.H"

namespace Foam
{
    defineTypeNameAndDebug(contactModel, 0);
    defineRunTimeSelectionTable(contactModel, dictionary);
}
