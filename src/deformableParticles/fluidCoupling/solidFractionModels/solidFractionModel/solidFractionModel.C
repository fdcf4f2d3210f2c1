/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "solidFractionModel.H"

namespace Foam
{
    defineTypeNameAndDebug(solidFractionModel, 0);
    defineRunTimeSelectionTable(solidFractionModel, dictionary);
}
