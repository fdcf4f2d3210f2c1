/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "integrator.H"

namespace Foam
{
    defineTypeNameAndDebug(integrator, 0);
    defineRunTimeSelectionTable(integrator, dictionary);
}
