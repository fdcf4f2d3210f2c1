/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "noConservation.H"

namespace Foam
{
namespace conservationModels
{
    defineTypeNameAndDebug(noConservation, 0);
    addToRunTimeSelectionTable(conservationModel, noConservation, dictionary);
}
}
