/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "clumpMotion.H"
#include "testCloud.H"

using namespace Foam;

namespace
{

//- Three spheres of different sizes without a fluid, and forces on the first one
autoPtr<openCloud> chain(const string& hold, const string& integration)
{
    const string text =
        "types { chain { shape { type fromFile;"
        " centres ((0 0 0) (1.5e-6 0 0) (2.4e-6 0.8e-6 0));"
        " radii (1e-6 0.7e-6 0.5e-6); bonds ((0 1) (1 2)); }"
        " density 1000; massModel union; motion free;"
        " bondModel { type elastic; rigidities { normal 1e-12; tangential 1e-12;"
        " bending 1e-24; torsional 1e-24; } } dampingModel { type none; } } }"
        "placement { type list; clumps ({ type chain; position (9e-6 10e-6 10e-6);"
        " velocity (1e-3 0 0); }); }"
        "integrator { " + integration + " }"
        "contactModel { type none; } wallContactModel { type none; }"
        "rotation { type wholeClump; } couplingScheme { type robin; coefficient 1; }"
        "immersedBoundary { solidFraction { type tetClipping; } forcing { type sharp; }"
        " hydrodynamicForce { type momentumExchange; } interiorDilation yes; }"
        "loads { push { type pointForces; clumpType chain; spheres (0);"
        " forces ((2e-13 3e-13 -1e-13)); torques ((0 0 0)); factor 1; } "
      + hold + " } effects { fluid off; }";
    return autoPtr<openCloud>(new openCloud(testMesh(), dictOf(text)));
}


//- The centre of the clump and its spheres around it, after some steps; on the
//  processor that has it
List<vector> run(openCloud& cloud, const label nSteps)
{
    for (label step = 0; step < nSteps; ++step)
    {
        cloud.evolve();
        cloud.accept();
        cloud.moveParcels();
    }
    List<vector> result;
    for (const clumpParcel& p : cloud)
    {
        const point centre(p.unwrappedCentre(cloud.type(p)));
        result.append(centre);
        for (const point& x : p.unwrappedCentres())
        {
            result.append(x - centre);
        }
    }
    Pstream::combineGather
    (
        result,
        [](List<vector>& a, const List<vector>& b) { a.append(b); }
    );
    Pstream::scatter(result);
    return result;
}

}


TEST_CASE("hold: across it stays, along it and in rotation it is free", "[cloud][hold]")
{
    const string integration = GENERATE
    (
        "type implicitEuler; tolerance 1e-9; maxIterations 100;",
        "type velocityVerlet; stepFraction 0.2;"
    );
    const label nSteps = 100;
    const List<vector> free(run(*chain("", integration), nSteps));
    const List<vector> held
    (
        run
        (
            *chain
            (
                "across { type hold; clumpType chain; directions ((0 2 0)); }",
                integration
            ),
            nSteps
        )
    );
    REQUIRE(free.size() == 4);
    REQUIRE(held.size() == 4);

    // The free one has moved
    CHECK(free[0].y() - 10e-6 > 1e-8);
    CHECK(mag(held[0].y() - 10e-6) < 1e-17);
    CHECK(mag(held[0].x() - free[0].x()) < 1e-12);
    CHECK(mag(held[0].z() - free[0].z()) < 1e-12);

    // The force of the hold has no moment and does not deform
    const scalar turned =
        mag(free[1] - run(*chain("", integration), 0)[1]);
    CHECK(turned > 1e-8);
    for (label i = 1; i < 4; ++i)
    {
        CHECK(mag(held[i] - free[i]) < 1e-5*turned);
    }
}


TEST_CASE("hold: in all directions nothing but a rotation remains", "[cloud][hold]")
{
    autoPtr<openCloud> cloud
    (
        chain
        (
            "all { type hold; clumpType chain;"
            " directions ((1 1 0) (0 0 1) (1 -1 0)); }",
            "type implicitEuler; tolerance 1e-9; maxIterations 100;"
        )
    );
    const List<vector> held(run(*cloud, 50));
    REQUIRE(held.size() == 4);
    CHECK(mag(held[0] - vector(9e-6, 10e-6, 10e-6)) < 1e-17);
    CHECK(mag(cloud->motion().held() - symmTensor(I)) < 1e-9);
    for (const clumpParcel& p : *cloud)
    {
        CHECK(mag(p.state().velocity(cloud->type(p))) < 1e-15);
        CHECK(mag(p.state().angularVelocity(cloud->type(p))) > 1);
    }
}


TEST_CASE("hold: a sphere that is pressed by another one is as a fixed one", "[cloud][hold]")
{
    // A load presses the pusher onto the anvil, with and without friction
    const string law = GENERATE
    (
        "type hertz; reducedModulus 1000; restitution 0.5;",
        "type hertz; reducedModulus 1000; restitution 0.5; friction 0.3;"
    );
    const auto distance = [&](const string& motion, const string& hold)
    {
        const string body =
            " { shape { type chain; nSpheres 1; sphereRadius 1e-6; } density 1000;"
            " bondModel { type elastic; rigidities { normal 1e-12; tangential 1e-12;"
            " bending 1e-24; torsional 1e-24; } } dampingModel { type none; } motion ";
        openCloud cloud
        (
            testMesh(),
            dictOf
            (
                "types { anvil" + body + motion + "; } pusher" + body + "free; } }"
                "placement { type list; clumps"
                " ({ type anvil; position (9e-6 10e-6 10e-6); velocity (0 0 0); }"
                " { type pusher; position (11.001e-6 10e-6 10e-6); velocity (0 0 0); }); }"
                "integrator { type implicitEuler; tolerance 1e-10; maxIterations 100; }"
                "contactModel { " + law + " } wallContactModel { type none; }"
                "rotation { type wholeClump; } couplingScheme { type robin; coefficient 1; }"
                "immersedBoundary { solidFraction { type tetClipping; }"
                " forcing { type sharp; } hydrodynamicForce { type momentumExchange; }"
                " interiorDilation yes; }"
                "loads { push { type pointForces; clumpType pusher; spheres (0);"
                " forces ((-1e-9 0 0)); torques ((0 0 0)); factor 1; } "
              + hold + " } effects { fluid off; }"
            )
        );
        vector apart(Zero);
        for (label step = 0; step < 200; ++step)
        {
            cloud.evolve();
            cloud.accept();
            cloud.moveParcels();
        }
        for (const clumpParcel& p : cloud)
        {
            const point centre(p.unwrappedCentre(cloud.type(p)));
            const bool anvil = cloud.type(p).name() == "anvil";
            apart += anvil ? vector(-centre) : vector(centre);
            if (anvil)
            {
                CHECK(mag(centre - point(9e-6, 10e-6, 10e-6)) < 1e-17);
            }
        }
        reduce(apart, sumOp<vector>());
        return apart;
    };
    const vector fixed(distance("fixed", ""));
    const vector held
    (
        distance
        (
            "free",
            "all { type hold; clumpType anvil; directions ((1 0 0) (0 1 0) (0 0 1)); }"
        )
    );
    CHECK(fixed.x() < 2e-6 - 1e-9);
    CHECK(mag(held - fixed) < 1e-4*(2e-6 - fixed.x()));
}


TEST_CASE("hold: entries that are refused", "[cloud][hold]")
{
    const string integration =
        "type implicitEuler; tolerance 1e-9; maxIterations 100;";
    const string begin = "a { type hold; clumpType chain; directions ";
    CHECK_NOTHROW(chain(begin + "((0 1 0)); }", integration));
    CHECK_THROWS(chain(begin + "(); }", integration));
    CHECK_THROWS(chain(begin + "((0 0 0)); }", integration));
    CHECK_THROWS(chain(begin + "((0 1 0) (0 1 0.1)); }", integration));
    CHECK_THROWS
    (
        chain
        (
            begin + "((0 1 0)); } b { type hold; clumpType chain;"
            " directions ((0 0 1)); }",
            integration
        )
    );
}
