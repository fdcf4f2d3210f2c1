/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wholeClump.H"
#include "clumpPieces.H"
#include "UIndirectList.H"

namespace Foam
{
namespace rotationModels
{
    defineTypeNameAndDebug(wholeClump, 0);
    addToRunTimeSelectionTable(rotationModel, wholeClump, dictionary);
}
}


namespace
{

using namespace Foam;

//- A piece of a clump as a rigid body, about its own centre of mass
struct rigidPiece
{
    point centre = Zero;
    tensor inertia = Zero;      // over scale, so that its inverse does not underflow
    scalar scale = 0;

    rigidPiece
    (
        const clumpType& type, const clumpState& s, const labelUList& spheres
    )
    {
        scalar mass = 0;
        for (const label i : spheres)
        {
            mass += type.masses()[i];
            centre += type.masses()[i]*s.x[i];
        }
        centre /= mass;
        for (const label i : spheres)
        {
            const vector r(s.x[i] - centre);
            inertia +=
                (type.masses()[i]*magSqr(r) + type.inertias()[i])*tensor::I
              - type.masses()[i]*(r*r);
        }
        scale = tr(inertia);
        inertia /= scale;
    }

    //- Angular velocity, or acceleration, that an angular momentum, or torque, gives it
    vector turned(const vector& L) const { return inv(inertia) & (L/scale); }
};

}


Foam::vectorField Foam::rotationModels::wholeClump::angularVelocities
(
    const clumpType& type,
    const clumpState& s
) const
{
    if (s.broken.empty())
    {
        return vectorField(type.size(), s.angularVelocity(type));
    }
    vectorField result(type.size());
    const clumpPieces pieces(type, s);
    for (label n = 0; n < pieces.size(); ++n)
    {
        const rigidPiece piece(type, s, pieces[n]);
        vector L(Zero);
        for (const label i : pieces[n])
        {
            L +=
                ((s.x[i] - piece.centre) ^ (type.masses()[i]*s.u[i]))
              + type.inertias()[i]*s.w[i];
        }
        UIndirectList<vector>(result, pieces[n]) = piece.turned(L);
    }
    return result;
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
    // The torque accelerates each piece as a rigid body does
    const clumpPieces pieces(type, s);
    for (label n = 0; n < pieces.size(); ++n)
    {
        const rigidPiece piece(type, s, pieces[n]);
        vector torque(Zero);
        for (const label i : pieces[n])
        {
            torque += fluidTorques[i];
        }
        const vector alpha(piece.turned(torque));
        for (const label i : pieces[n])
        {
            forces[i] += type.masses()[i]*(alpha ^ (s.x[i] - piece.centre));
            torques[i] += type.inertias()[i]*alpha;
        }
    }
}
