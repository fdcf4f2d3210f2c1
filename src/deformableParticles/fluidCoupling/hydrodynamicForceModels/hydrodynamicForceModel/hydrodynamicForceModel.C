/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "hydrodynamicForceModel.H"

namespace Foam
{
    defineTypeNameAndDebug(hydrodynamicForceModel, 0);
    defineRunTimeSelectionTable(hydrodynamicForceModel, dictionary);
}
