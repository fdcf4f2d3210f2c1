/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    The rotational pressure correction beside a patch that fixes p, and what the
    watchdog knows of the flow.
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "fixedValueFvPatchFields.H"
#include "flowDriving.H"
#include "flowGrowth.H"
#include "flowReversal.H"
#include "rotationalCorrection.H"

using namespace Foam;

namespace
{

//- A field on the mesh of the box; the type is that on the walls
template<class Type>
GeometricField<Type, fvPatchField, volMesh> field
(
    const word& name,
    const dimensioned<Type>& value,
    const word& onWalls
)
{
    const fvMesh& mesh = testMesh();
    wordList types(mesh.boundary().size());
    forAll(types, patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        types[patchi] = patch.coupled() ? patch.type() : onWalls;
    }
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject(name, testTime().timeName(), mesh), mesh, value, types
    );
}

const dimensionedScalar nuValue("nu", dimViscosity, 1.2e-6);

}

TEST_CASE("rotationalCorrection: nu inside, bounded beside an open patch")
{
    const fvMesh& mesh = testMesh();
    const scalar h = 1e-6;
    const volScalarField nu(field<scalar>("nu", nuValue, "zeroGradient"));

    // Large steps: A is the sum of the coefficients of the six faces
    const volScalarField rAU
    (
        field<scalar>
        (
            "rAU",
            dimensionedScalar("", dimTime, sqr(h)/(6*nuValue.value())),
            "zeroGradient"
        )
    );
    const dimensionedVector rest("", dimVelocity, Zero);
    const dimensionedScalar none("", sqr(dimVelocity), 0);
    const volVectorField wallU(field<vector>("U", rest, "fixedValue"));
    const volVectorField freeU(field<vector>("U", rest, "zeroGradient"));
    volScalarField closed(field<scalar>("p", none, "zeroGradient"));
    volScalarField open(field<scalar>("p", none, "fixedValue"));

    CHECK(closed.needReference());
    CHECK
    (
        gMin
        (
            rotationalCorrection::coefficient(nu, rAU, wallU, closed)()
           .primitiveField()
        ) == nuValue.value()
    );

    // Five faces and, with half the distance, the open one: nu G = (5 + 2)/6
    const scalarField c
    (
        rotationalCorrection::coefficient(nu, rAU, freeU, open)()
       .primitiveField()/nuValue.value()
    );
    scalar error = 0;
    forAll(c, i)
    {
        const scalar y = mesh.C()[i].y();
        const bool beside = min(y, 20e-6 - y) < h;
        error = max(error, mag(c[i] - (beside ? 6.0/7.0 : 1)));
    }
    CHECK(returnReduce(error, maxOp<scalar>()) < 1e-6);

    // The walls face one direction, and are closed where U is fixed
    CHECK(!rotationalCorrection::facesSeveral(freeU, open));
    CHECK(!rotationalCorrection::facesSeveral(wallU, open));
}

TEST_CASE("flowGrowth: power laws pass, exponentials do not", "[serial]")
{
    const scalar dt = 1e-4;
    for (const scalar power : {0.5, 1.0, 2.0, 3.0})
    {
        flowGrowth growth(0, 0);
        scalar most = 0;
        for (label n = 1; n <= 2000; ++n)
        {
            most = max(most, growth.add(n*dt, Foam::pow(n*dt, power), 0));
        }
        INFO("power " << power);

        // The third step is compared with the first; entries are a hundredth apart
        CHECK(most < 1.01*Foam::pow(3.0, power));
    }

    // A hundredth more in every step, in a flow that was there before
    flowGrowth growth(0, 0);
    label n = 0;
    scalar last = 0;
    while (n < 5000 && last < 10)
    {
        ++n;
        last = growth.add(n*dt, 1 + 1e-9*Foam::exp(0.01*n), 0);
    }
    CHECK(n > 2000);
    CHECK(n < 2600);
}

TEST_CASE("flowGrowth: what drives the flow accounts for it", "[serial]")
{
    flowGrowth growth(0, 0);
    for (label n = 1; n < 100; ++n)
    {
        CHECK(growth.add(n, 1, 0) <= 1);
    }
    CHECK(growth.add(100, 50, 50) == Approx(1));
    CHECK(growth.add(101, 50, 0) == Approx(50));
}

TEST_CASE("flowDriving: velocities and pressures that are prescribed")
{
    const dimensionedVector u("", dimVelocity, vector(3, 4, 0));
    const dimensionedScalar p2("", sqr(dimVelocity), 2);
    const surfaceScalarField phi
    (
        IOobject("phi", testTime().timeName(), testMesh()),
        testMesh(),
        dimensionedScalar("", dimVelocity*dimArea, -1)
    );
    volVectorField fixedU(field<vector>("U", u, "fixedValue"));
    fixedU.boundaryFieldRef() == vector(3, 4, 0);
    volVectorField freeU(field<vector>("U", u, "zeroGradient"));
    freeU.boundaryFieldRef() == vector(3, 4, 0);
    volScalarField p(field<scalar>("p", p2, "fixedValue"));

    CHECK(flowDriving::speed(fixedU, p, phi) == Approx(5));
    CHECK(flowDriving::speed(freeU, p, phi) == 0);

    // The same pressure everywhere drives nothing; 8 m2/s2 more at the top: 4 m/s
    forAll(p.boundaryField(), patchi)
    {
        fvPatchScalarField& pp = p.boundaryFieldRef()[patchi];
        if (!pp.coupled())
        {
            pp == 8*pos(pp.patch().Cf().component(vector::Y) - 10e-6);
        }
    }
    CHECK(flowDriving::speed(freeU, p, phi) == Approx(4));
}

TEST_CASE("flowDriving: the patches beside a mesh cell", "[serial]")
{
    const volVectorField U
    (
        field<vector>("U", dimensionedVector(dimVelocity, Zero), "zeroGradient")
    );
    const volScalarField p
    (
        field<scalar>("p", dimensionedScalar(sqr(dimVelocity), Zero), "fixedValue")
    );
    const label atWall = testMesh().findCell(point(10.5e-6, 0.5e-6, 10.5e-6));
    const label inside = testMesh().findCell(point(10.5e-6, 9.5e-6, 10.5e-6));

    CHECK
    (
        flowDriving::patches(atWall, U, p)
     == ", beside patch walls (U zeroGradient, p fixedValue)"
    );
    CHECK(flowDriving::patches(inside, U, p).empty());
}

TEST_CASE("flowReversal: the part of the velocity that reverses", "[serial]")
{
    const scalarField area(2, 3.0);
    const vectorField cellU(2, vector(2, 0, 0));
    const vectorField U0(2, vector(2, 0, 0));
    const vectorField U(2, Zero);
    scalarField flux0(2, 1.0);
    scalarField flux(2, 1.0);

    CHECK(flowReversal::part(flux0, flux, U0, U, cellU, area) == 0);
    flux[0] = -1e-9;
    CHECK(flowReversal::part(flux0, flux, U0, U, cellU, area) == Approx(0.5));
    CHECK(flowReversal::part(flux0, flux, U0, U0, cellU, area) == 0);
}


TEST_CASE("flowGrowth: a restart has the history of the run", "[serial]")
{
    // Exponential growth, whose factor depends on all of the past
    flowGrowth whole(0, 0.1);
    autoPtr<flowGrowth> parts(new flowGrowth(0, 0.1));
    for (label i = 1; i < 60; ++i)
    {
        const scalar speed = std::exp(0.2*i)/3;
        if (i % 7 == 0)
        {
            dictionary state;
            parts->write(state);
            parts.reset(new flowGrowth(state));
        }
        CHECK(parts->add(i/3.0, speed, 0) == whole.add(i/3.0, speed, 0));
    }

    dictionary broken;
    whole.write(broken);
    broken.set("past", 1000);
    CHECK_THROWS(flowGrowth(broken));
}
