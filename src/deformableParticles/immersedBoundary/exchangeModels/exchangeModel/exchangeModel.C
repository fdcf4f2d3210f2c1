/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "exchangeModel.H"

namespace Foam
{
    defineTypeNameAndDebug(exchangeModel, 0);
    defineRunTimeSelectionTable(exchangeModel, dictionary);
}
