/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "perSphere.H"

namespace
{

using namespace Foam;

//- 1/|r|^2 of Eq. 13, bounded in a sphere of the radius a around the centre
scalar inverseSquare(const vector& r, const scalar a)
{
    const scalar s = magSqr(r)/sqr(a);
    return (s < 1 ? 3 - 3*s + sqr(s) : 1/s)/sqr(a);
}

}

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
        result[i] =
            inverseSquare(r, type.radii()[i])*(r ^ (s.u[i] - velocity));
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
        const vector f
        (
            inverseSquare(r, type.radii()[i])*(fluidTorques[i] ^ r)
        );
        forces[i] += f;
        total += f;
    }

    // u_cm is a mean over the spheres
    forces -= total*type.masses()/type.mass();
}
