/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fixedValueFvPatchFields.H"
#include "fluidMobility.H"
#include "testCatch.H"
#include "testCase.H"

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

volScalarField uniform(const word& name, const dimensionSet& dims, const scalar value)
{
    return volScalarField
    (
        IOobject(name, testTime().timeName(), testMesh()),
        testMesh(), dimensionedScalar(name, dims, value)
    );
}


volScalarField viscosity(const scalar nu)
{
    return uniform("nu", dimViscosity, nu);
}


//- The diagonal less the coefficients of the neighbours [1/s]: of the time derivative and of
//  the friction at walls, which is that over half a mesh cell
volScalarField diagonal(const volVectorField& U, const volScalarField& nu)
{
    const fvMesh& mesh = testMesh();
    volScalarField A
    (
        uniform("A", dimless/dimTime, 1/testTime().deltaTValue())
    );
    forAll(U.boundaryField(), patchi)
    {
        if (isA<fixedValueFvPatchVectorField>(U.boundaryField()[patchi]))
        {
            const fvPatch& patch = mesh.boundary()[patchi];
            const labelUList& cells = patch.faceCells();
            forAll(cells, facei)
            {
                A[cells[facei]] +=
                    nu.boundaryField()[patchi][facei]*patch.magSf()[facei]
                   *patch.deltaCoeffs()[facei]/mesh.V()[cells[facei]];
            }
        }
    }
    return A;
}


//- Largest deviation from the mobility of the channel, exact(y), more than one and a half mesh
//  cells from the walls
template<class Exact>
scalar deviation(const volScalarField& m, const Exact& exact)
{
    scalar worst = 0;
    forAll(m, i)
    {
        const scalar y = testMesh().C()[i].y() - H/2;
        if (mag(y) < H/2 - 1.5*H/20)
        {
            worst = max(worst, mag(m[i]/exact(y) - 1));
        }
    }
    return returnReduce(worst, maxOp<scalar>());
}

}


TEST_CASE("A pressure gradient moves the fluid of a channel by its mobility")
{
    // The velocity in a channel of height H, and 1/dt - nu laplacian of it: one
    const volVectorField U(velocity("fixedValue"));
    fluidMobility mobility(U);
    const scalar dt = testTime().deltaTValue();

    for (const scalar viscousNumber : {1e-3, 0.1, 10.0, 1e4})
    {
        const volScalarField nu(viscosity(viscousNumber*sqr(H)/dt));
        const scalar k = 1/Foam::sqrt(nu[0]*dt);
        INFO("viscous number " << viscousNumber);
        CHECK
        (
            deviation(mobility.value(diagonal(U, nu), nu), [&](const scalar y)
            {
                return dt*(1 - Foam::cosh(k*y)/Foam::cosh(k*H/2));
            }) < 0.02
        );
    }
}


TEST_CASE("Between walls and in a medium with drag, the drag limits the mobility")
{
    // The velocity in a porous channel (Brinkman), with the permeability nu/S
    const volVectorField U(velocity("fixedValue"));
    fluidMobility mobility(U);
    const scalar dt = testTime().deltaTValue();
    const volScalarField nu(viscosity(100*sqr(H)/dt));

    for (const scalar S : {1/dt, 1e2/dt, 1e3/dt})
    {
        volScalarField A(diagonal(U, nu));
        A.primitiveFieldRef() += S;
        const scalar a = S + 1/dt;
        const scalar k = Foam::sqrt(a/nu[0]);
        INFO("strength of the drag times the step " << S*dt);
        CHECK
        (
            deviation(mobility.value(A, nu), [&](const scalar y)
            {
                return (1 - Foam::cosh(k*y)/Foam::cosh(k*H/2))/a;
            }) < 0.02
        );
    }
}


TEST_CASE("Without walls the mobility of the fluid is the time step")
{
    const volVectorField U(velocity("zeroGradient"));
    fluidMobility mobility(U);
    const volScalarField nu(viscosity(1e-6));
    const scalar dt = testTime().deltaTValue();
    const volScalarField& m = mobility.value(diagonal(U, nu), nu);
    CHECK(gMax(mag(m.primitiveField()/dt - 1)()) < 1e-4);
}


TEST_CASE("The mobility stays positive when the viscosity at a wall falls")
{
    const volVectorField U(velocity("fixedValue"));
    fluidMobility mobility(U);
    const scalar dt = testTime().deltaTValue();
    volScalarField nu(viscosity(10*sqr(H)/dt));
    const scalar before = nu[0];
    mobility.value(diagonal(U, nu), nu);

    // Beside the walls only
    const scalar dy = H/20;
    forAll(nu, i)
    {
        if (mag(testMesh().C()[i].y() - H/2) > H/2 - dy)
        {
            nu[i] = 0.1*before;
        }
    }
    nu.boundaryFieldRef() == 0.1*before;
    const volScalarField& m = mobility.value(diagonal(U, nu), nu);
    CHECK(gMin(m.primitiveField()) > 0);
    CHECK(gMax(m.primitiveField()) < dt);
}
