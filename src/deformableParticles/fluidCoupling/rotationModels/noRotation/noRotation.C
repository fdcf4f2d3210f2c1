/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "noRotation.H"

namespace Foam
{
namespace rotationModels
{
    defineTypeNameAndDebug(noRotation, 0);
    addToRunTimeSelectionTable(rotationModel, noRotation, dictionary);
}
}


Foam::vectorField Foam::rotationModels::noRotation::angularVelocities
(
    const clumpType& type,
    const clumpState&
) const
{
    return vectorField(type.size(), Zero);
}


void Foam::rotationModels::noRotation::transpose
(
    const clumpType&,
    const clumpState&,
    const vectorField&,
    vectorField&,
    vectorField&
) const
{}
