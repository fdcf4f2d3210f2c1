/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wholeClump.H"

namespace Foam
{
namespace rotationModels
{
    defineTypeNameAndDebug(wholeClump, 0);
    addToRunTimeSelectionTable(rotationModel, wholeClump, dictionary);
}
}


Foam::vectorField Foam::rotationModels::wholeClump::angularVelocities
(
    const clumpType& type,
    const clumpState& s
) const
{
    return vectorField(type.size(), s.angularVelocity(type));
}


void Foam::rotationModels::wholeClump::transpose
(
    const clumpType& type,
    const clumpState& s,
    const vectorField& fluidTorques,
    vectorField& forces,
    vectorField& torques
) const
{
    // The torque accelerates the clump as a rigid body does
    const tensor I(s.inertia(type));
    const scalar scale = tr(I);
    const vector alpha(inv(I/scale) & (sum(fluidTorques)/scale));
    const point centre(s.centre(type));

    forAll(forces, i)
    {
        forces[i] += type.masses()[i]*(alpha ^ (s.x[i] - centre));
        torques[i] += type.inertias()[i]*alpha;
    }
}
