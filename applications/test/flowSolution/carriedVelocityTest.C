/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "carriedVelocity.H"
#include "fvcFlux.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

using constant::mathematical::twoPi;

const scalar L = 20e-6;     // of the box
const scalar D = 4e-6;      // of a clump

volVectorField blank(const word& name, const dimensionSet& dimensions)
{
    return volVectorField
    (
        IOobject(name, testTime().timeName(), testMesh()),
        testMesh(), dimensionedVector(dimensions, Zero)
    );
}

volVectorField displacement(const vector& d)
{
    volVectorField result(blank("d", dimLength));
    result == dimensionedVector("", dimLength, d);
    return result;
}

//- Waves along x and z, moved by d
void setWaves(volVectorField& U, const label n, const vector& d)
{
    forAll(U, i)
    {
        const vector x(twoPi*n/L*(U.mesh().C()[i] - d));
        U[i] = 1e-3*vector(Foam::sin(x.x()), Foam::cos(x.z()), Foam::sin(x.x() - x.z()));
    }
    U.correctBoundaryConditions();
}

//- With this viscosity the Reynolds number of D, carried by d in a step, is 1
scalar nuOf(const vector& d)
{
    return D*mag(d)/testTime().deltaTValue();
}

scalar norm(const vectorField& f) { return Foam::sqrt(gSumProd(f, f)); }

//- Error over the change, for n waves in the box carried by d
scalar shiftError(const label n, const vector& d)
{
    volVectorField U(blank("U", dimVelocity));
    setWaves(U, n, Zero);
    U.oldTime();
    carriedVelocity carried(U);
    carried.carry(displacement(d), D, nuOf(d));
    REQUIRE(carried.active());

    volVectorField moved(blank("moved", dimVelocity));
    setWaves(moved, n, d);
    const vectorField expected
    (
        (U.primitiveField() - moved.primitiveField())/testTime().deltaTValue()
    );
    return norm(carried.rate().primitiveField() - expected)/norm(expected);
}

}

TEST_CASE("carriedVelocity: a uniform displacement shifts the pattern")
{
    const vector d(0.3e-6, 0, 0);
    const scalar coarse = shiftError(2, d);
    const scalar fine = shiftError(1, d);
    CHECK(fine < 1e-3);

    // Fourth order in the mesh width over the wave length, third in the displacement
    CHECK(coarse/fine > 8);
    CHECK(coarse/fine < 17);

    // Across the mesh, and by more than a mesh cell
    CHECK(shiftError(1, vector(0.6e-6, 0, -0.2e-6)) < 1e-3);
    CHECK(shiftError(1, vector(2.3e-6, 0, 0)) < 2e-3);
}


TEST_CASE("carriedVelocity: a uniform velocity is carried to itself")
{
    volVectorField U(blank("U", dimVelocity));
    U == dimensionedVector("", dimVelocity, vector(1e-3, 0, 2e-3));
    U.oldTime();

    // Not uniform, and with a component towards the walls
    volVectorField d(blank("d", dimLength));
    setWaves(d, 2, Zero);
    d.primitiveFieldRef() *= 1e-3;
    d.correctBoundaryConditions();
    carriedVelocity carried(U);
    carried.carry(d, D, nuOf(vector(1e-6, 0, 0)));
    REQUIRE(carried.active());
    CHECK
    (
        norm(carried.rate().primitiveField())*testTime().deltaTValue()
      < 1e-12*norm(U.primitiveField())
    );
}


TEST_CASE("carriedVelocity: nothing is carried where inertia does not matter")
{
    volVectorField U(blank("U", dimVelocity));
    setWaves(U, 1, Zero);
    U.oldTime();
    carriedVelocity carried(U);
    const vector d(0.3e-6, 0, 0);
    carried.carry(displacement(d), D, nuOf(d));
    CHECK(carried.active());
    carried.carry(displacement(d), D, 25*nuOf(d));
    CHECK_FALSE(carried.active());
    carried.carry(displacement(Zero), D, nuOf(d));
    CHECK_FALSE(carried.active());
}


TEST_CASE("carriedVelocity: the flux is that of the motion inside, none on walls")
{
    volVectorField U(blank("U", dimVelocity));
    U.oldTime();
    carriedVelocity carried(U);
    const vector d(0.3e-6, 0.2e-6, -0.1e-6);
    carried.carry(displacement(d), D, nuOf(d));

    const surfaceScalarField flux(carried.flux());
    const vector w(d/testTime().deltaTValue());
    const surfaceVectorField& S = testMesh().Sf();
    const scalar most = mag(w)*gMax(mag(S)().primitiveField());
    CHECK
    (
        gMax(mag(flux.primitiveField() - (w & S.primitiveField()))())
      < 1e-12*most
    );
    forAll(flux.boundaryField(), i)
    {
        const bool coupled = testMesh().boundary()[i].coupled();
        const scalarField expected
        (
            (coupled ? w : vector::zero) & S.boundaryField()[i]
        );
        forAll(expected, k)
        {
            CHECK(mag(flux.boundaryField()[i][k] - expected[k]) < 1e-12*most);
        }
    }
}
