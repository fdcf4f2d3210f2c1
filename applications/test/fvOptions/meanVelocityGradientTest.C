/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "meanVelocityGradient.H"
#include "fixedValueFvPatchFields.H"
#include "wallFvPatch.H"
#include "zeroGradientFvPatchFields.H"
#include "volFields.H"

using namespace Foam;

namespace
{

//- Velocity of the box: zero at the walls, or free there
volVectorField velocity(const bool walls)
{
    const fvMesh& mesh = testMesh();
    wordList types(mesh.boundary().size(), zeroGradientFvPatchVectorField::typeName);
    forAll(types, patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (patch.coupled())
        {
            types[patchi] = patch.type();
        }
        else if (walls && isA<wallFvPatch>(patch))
        {
            types[patchi] = fixedValueFvPatchVectorField::typeName;
        }
    }
    return volVectorField
    (
        IOobject("U", testTime().timeName(), mesh),
        mesh, dimensionedVector(dimVelocity, Zero), types
    );
}


autoPtr<fv::meanVelocityGradient> drive(const string& entries)
{
    return autoPtr<fv::meanVelocityGradient>
    (
        new fv::meanVelocityGradient
        (
            "testDrive", "meanVelocityGradient",
            dictOf("type meanVelocityGradient; " + entries), testMesh()
        )
    );
}


//- Projects onto the directions that are held
tensor held(const string& entries)
{
    tensor result(Zero);
    for (const vector& d : drive(entries)->heldDirections())
    {
        result += d*d;
    }
    return result;
}

}


TEST_CASE("mean velocity: the directions in which it is held", "[fvOptions]")
{
    const tensor xx(1, 0, 0, 0, 0, 0, 0, 0, 0);
    const tensor zz(0, 0, 0, 0, 0, 0, 0, 0, 1);
    const string along("Ubar (1e-3 0 0); ");
    {
        // Walls in y; x and z are periodic
        const volVectorField U(velocity(true));
        CHECK(mag(held(along) - xx - zz) < 1e-12);
        CHECK(mag(held(along + "free (z);") - xx) < 1e-12);
        CHECK(mag(held("Ubar (0 0 0);") - xx - zz) < 1e-12);
        CHECK_THROWS(held("Ubar (0 1e-3 0);"));
        CHECK_THROWS(held("Ubar (0 0 0); free (x z);"));
    }
    {
        // The fluid may flow through the patches in y
        const volVectorField U(velocity(false));
        CHECK(mag(held(along) - xx) < 1e-12);
    }
}


TEST_CASE("mean velocity: that of the end of the step, forth and back", "[fvOptions]")
{
    // The largest value is at an unknown time; before and at the turning point, Ubar is zero
    const string there("Ubar table ((0 (0 0 0)) (0.25 (0 0 0)) (0.5 (3e-3 0 ");
    const string back(")) (0.75 (-3e-3 0 "), end(")) (1 (0 0 0)));");
    const tensor xx(1, 0, 0, 0, 0, 0, 0, 0, 0);
    const tensor zz(0, 0, 0, 0, 0, 0, 0, 0, 1);
    Time& time = testTime();
    const scalar before = time.value();
    const label index = time.timeIndex();
    const auto at = [&](const scalar t) { time.setTime(t, index); };
    {
        // The fluid may flow through the patches in y: one direction is held, with a sign
        // that does not matter
        const volVectorField U(velocity(false));
        const string oblique(there + "1e-3" + back + "-1e-3" + end);
        autoPtr<fv::meanVelocityGradient> source(drive(oblique));
        const vector d(source->heldDirections()[0]);
        CHECK(mag(d ^ vector(3, 0, 1)) < 1e-12);
        for (const scalar t : {0.1, 0.5, 0.6249, 0.625, 0.75, 1.0, 2.0})
        {
            at(t);
            const List<vector> now(source->heldDirections());
            REQUIRE(now.size() == 1);
            CHECK(now[0] == d);
        }
        at(0.625 - 1e-3);
        CHECK(mag(source->Ubar() - vector(24e-6, 0, 8e-6)) < 1e-15);
        at(0);

        // One that turns is refused, except where all directions are held
        const string turning(there + "1e-3" + back + "1e-3" + end);
        CHECK_THROWS(drive(turning));
    }
    {
        const volVectorField U(velocity(true));
        CHECK(mag(held(there + "1e-3" + back + "1e-3" + end) - xx - zz) < 1e-12);
        CHECK(mag(held(there + "0" + back + "0" + end + "free (z);") - xx) < 1e-12);
        CHECK_THROWS(drive(there + "0" + back + "1e-3" + end + "free (z);"));
        CHECK_THROWS(drive("Ubar table ((0 (1e-3 0 0)) (1 (1e-3 1e-4 0)));"));
        CHECK_THROWS(drive("Ubar { type pulse; }"));
        CHECK(mag(held("Ubar { type sine; frequency 1; amplitude 1; scale (1e-3 0 0); level"
            " (0 0 0); }") - xx - zz) < 1e-12);
    }
    time.setTime(before, index);
}


TEST_CASE("mean velocity: a repeated step begins with the same gradient", "[fvOptions]")
{
    const volVectorField U(velocity(true));
    autoPtr<fv::meanVelocityGradient> source(drive("Ubar (1e-3 0 0);"));
    const vector first(3, 0, -1);

    Time& time = testTime();
    const label index = time.timeIndex();
    source->beginStep();
    source->change(first);
    time.setTime(time.value(), index + 1);
    source->beginStep();
    source->change(vector(5, 0, 0));
    source->beginStep();
    CHECK(source->gradient() == first);
    time.setTime(time.value(), index);
}


TEST_CASE("mean velocity: other solvers than rbcIbFoam are refused", "[fvOptions]")
{
    volVectorField U(velocity(true));
    CHECK_THROWS(drive("Ubar (1e-3 0 0);")->correct(U));
}
