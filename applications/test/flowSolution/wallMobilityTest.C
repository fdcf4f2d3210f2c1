/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "wallMobility.H"

using namespace Foam;

namespace
{

const scalar H = 20e-6;     // between the walls [m]

volVectorField velocity(const word& onWalls)
{
    const fvMesh& mesh = testMesh();
    wordList types(mesh.boundary().size());
    forAll(types, i)
    {
        const fvPatch& patch = mesh.boundary()[i];
        types[i] = patch.coupled() ? patch.type() : onWalls;
    }
    return volVectorField
    (
        IOobject("U", testTime().timeName(), mesh),
        mesh, dimensionedVector(dimVelocity, Zero), types
    );
}

volScalarField viscosity(const scalar nu)
{
    return volScalarField
    (
        IOobject("nu", testTime().timeName(), testMesh()),
        testMesh(), dimensionedScalar("nu", dimViscosity, nu)
    );
}

}


TEST_CASE("A pressure gradient moves the fluid of a channel by its mobility")
{
    // The velocity in a channel of height H, and 1/dt - nu laplacian of it: one
    const volVectorField U(velocity("fixedValue"));
    wallMobility mobility(U);
    const scalar dt = testTime().deltaTValue();

    for (const scalar viscousNumber : {1e-3, 0.1, 10.0, 1e4})
    {
        const volScalarField nu(viscosity(viscousNumber*sqr(H)/dt));
        const volScalarField resistance(mobility.resistance(nu));
        const scalar k = 1/Foam::sqrt(nu[0]*dt);
        scalar worst = 0;
        forAll(resistance, i)
        {
            const scalar y = testMesh().C()[i].y() - H/2;
            if (mag(y) > H/2 - 1.5*H/20)
            {
                continue;           // a wall beside the mesh cell holds it back too
            }
            const scalar exact =
                dt*(1 - Foam::cosh(k*y)/Foam::cosh(k*H/2));
            worst = max(worst, mag(1/(resistance[i] + 1/dt)/exact - 1));
        }
        INFO("viscous number " << viscousNumber);
        CHECK(returnReduce(worst, maxOp<scalar>()) < 0.02);
    }
}


TEST_CASE("Without walls the mobility of the fluid is the time step")
{
    const volVectorField U(velocity("zeroGradient"));
    wallMobility mobility(U);
    const volScalarField nu(viscosity(1e-6));
    const volScalarField resistance(mobility.resistance(nu));
    CHECK
    (
        gMax(mag(resistance.primitiveField())())*testTime().deltaTValue() < 1e-4
    );
}


TEST_CASE("The mobility stays positive when the viscosity at a wall falls")
{
    const volVectorField U(velocity("fixedValue"));
    wallMobility mobility(U);
    const scalar dt = testTime().deltaTValue();
    volScalarField nu(viscosity(10*sqr(H)/dt));
    const scalar before = nu[0];
    mobility.resistance(nu);

    // Beside the walls only; the mean changes by less than a tenth
    const scalar dy = H/20;
    forAll(nu, i)
    {
        if (mag(testMesh().C()[i].y() - H/2) > H/2 - dy)
        {
            nu[i] = 0.1*before;
        }
    }
    nu.boundaryFieldRef() == 0.1*before;
    const volScalarField resistance(mobility.resistance(nu));

    // With the friction of half a mesh cell and 1/dt the inverse of the mobility
    scalar least = GREAT;
    forAll(nu, i)
    {
        const bool beside = nu[i] < 0.5*before;
        const scalar friction = beside ? 2*nu[i]/sqr(dy) : 0;
        least = min(least, resistance[i] + 1/dt + friction);
    }
    CHECK(returnReduce(least, minOp<scalar>()) > 0);
}
