/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "load.H"

namespace Foam
{
    defineTypeNameAndDebug(load, 0);
    defineRunTimeSelectionTable(load, dictionary);
}
