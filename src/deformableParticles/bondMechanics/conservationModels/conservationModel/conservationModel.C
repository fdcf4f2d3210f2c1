/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "conservationModel.H"

namespace Foam
{
    defineTypeNameAndDebug(conservationModel, 0);
    defineRunTimeSelectionTable(conservationModel, dictionary);
}
