/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "perSphere.H"

namespace Foam
{
namespace rotationModels
{
    defineTypeNameAndDebug(perSphere, 0);
    addToRunTimeSelectionTable(rotationModel, perSphere, dictionary);
}
}


Foam::vectorField Foam::rotationModels::perSphere::angularVelocities
(
    const clumpType& type,
    const clumpState& s
) const
{
    const point centre(s.centre(type));
    const vector velocity(s.velocity(type));
    vectorField result(type.size(), Zero);

    forAll(result, i)
    {
        const vector r(s.x[i] - centre);
        if (mag(r) > 1e-6*type.radii()[i])
        {
            result[i] = (r ^ (s.u[i] - velocity))/magSqr(r);
        }
    }
    return result;
}


void Foam::rotationModels::perSphere::transpose
(
    const clumpType& type,
    const clumpState& s,
    const vectorField& fluidTorques,
    vectorField& forces,
    vectorField&
) const
{
    const point centre(s.centre(type));
    vector total(Zero);

    forAll(fluidTorques, i)
    {
        const vector r(s.x[i] - centre);
        if (mag(r) > 1e-6*type.radii()[i])
        {
            const vector f((fluidTorques[i] ^ r)/magSqr(r));
            forces[i] += f;
            total += f;
        }
    }

    // u_cm is a mean over the spheres
    forces -= total*type.masses()/type.mass();
}
