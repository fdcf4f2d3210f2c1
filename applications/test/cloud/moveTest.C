/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "bondFrame.H"
#include "clumpMotion.H"
#include "mathematicalConstants.H"
#include "testCloud.H"
#include <cmath>

using namespace Foam;

namespace
{

const point start(9e-6, 10e-6, 10e-6);
const scalar step = 1e-6;
const vector push(2e-13, 3e-13, -1e-13);


//- Clumps of three spheres of different sizes without a fluid, with a force on each
autoPtr<openCloud> chain(const string& loads)
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
        "integrator { type implicitEuler; tolerance 1e-9; maxIterations 100; }"
        "contactModel { type none; } wallContactModel { type none; }"
        "rotation { type wholeClump; } couplingScheme { type robin; coefficient 1; }"
        "immersedBoundary { solidFraction { type tetClipping; } forcing { type sharp; }"
        " hydrodynamicForce { type momentumExchange; } interiorDilation yes; }"
        "loads { push { type pointForces; clumpType chain; spheres (0);"
        " forces ((2e-13 3e-13 -1e-13)); torques ((0 0 0)); factor 1; } "
      + loads + " } effects { fluid off; }";
    return autoPtr<openCloud>(new openCloud(testMesh(), dictOf(text)));
}


//- What is known of a clump, on the processor that has it
struct place
{
    point centre;
    pointField arms;
    vector velocity;
    vector momentum;    // angular, about the centre

    place(const openCloud& cloud, const clumpParcel& p)
    :
        centre(p.unwrappedCentre(cloud.type(p))),
        arms(p.unwrappedCentres() - centre),
        velocity(p.state().velocity(cloud.type(p))),
        momentum(p.state().angularMomentum(cloud.type(p)))
    {}
};


//- Advance a cloud; afterStep is called with the time and each clump of this processor
void run
(
    openCloud& cloud,
    const label nSteps,
    const std::function<void(const scalar, const place&)>& afterStep
)
{
    const label index = testTime().timeIndex();
    const scalar dt = testTime().deltaTValue();
    for (label n = 1; n <= nSteps; ++n)
    {
        testTime().setTime(n*step, index + n);
        testTime().setDeltaT(step, false);
        cloud.evolve();
        cloud.accept();
        cloud.moveParcels();
        for (const clumpParcel& p : cloud)
        {
            afterStep(n*step, place(cloud, p));
        }
    }
    testTime().setTime(0, index);
    testTime().setDeltaT(dt, false);
}


const string sine =
    "{ type sine; frequency 1e4; amplitude 1; scale (1e-6 2e-6 0); level (0 0 0); t0 0; }";

}


TEST_CASE("move: the centre is where the path has it, the rest is free", "[cloud][move][serial]")
{
    // The same with a uniform force of the constraint, which neither turns nor deforms
    std::vector<place> free;
    autoPtr<openCloud> unmoved(chain(""));
    run(*unmoved, 100, [&](const scalar, const place& p) { free.push_back(p); });

    autoPtr<openCloud> cloud
    (
        chain
        (
            "path { type move; clumpType chain; displacement " + sine
          + " directions ((1 0 0) (0 1 0)); }"
        )
    );
    CHECK(mag(cloud->motion().held() - symmTensor(1, 0, 0, 1, 0, 0)) < 1e-12);
    std::size_t n = 0;
    run
    (
        *cloud, 100,
        [&](const scalar t, const place& p)
        {
            const scalar s = std::sin(constant::mathematical::twoPi*1e4*t);
            CHECK(mag(p.centre.x() - start.x() - 1e-6*s) < 1e-18);
            CHECK(mag(p.centre.y() - start.y() - 2e-6*s) < 1e-18);
            REQUIRE(n < free.size());
            const place& other = free[n++];
            CHECK(mag(p.centre.z() - other.centre.z()) < 1e-12);
            CHECK(max(mag(p.arms - other.arms)) < 1e-12);
        }
    );
    CHECK(n == free.size());
}


TEST_CASE("move: velocity and displacement, rate and angle agree", "[cloud][move][serial]")
{
    // Gauss's rule integrates these polynomials exactly
    const auto end = [](const string& entries)
    {
        List<vector> result;
        autoPtr<openCloud> cloud
        (
            chain("path { type move; clumpType chain; axis (1 2 2); " + entries + " }")
        );
        run
        (
            *cloud, 20,
            [&](const scalar t, const place& p)
            {
                if (t > 19.5*step)
                {
                    result.append(p.centre);
                    result.append(p.arms);
                }
            }
        );
        return result;
    };
    const List<vector> byValue
    (
        end
        (
            "displacement polynomial (((0 1e5 0) (0 3 0)) ((0.05 0 0) (1 0 0)));"
            " angle polynomial ((1e12 3)(1e4 1));"
        )
    );
    const List<vector> byRate
    (
        end
        (
            "velocity polynomial (((0 3e5 0) (0 2 0)) ((0.05 0 0) (0 0 0)));"
            " angularVelocity polynomial ((3e12 2)(1e4 0));"
        )
    );
    REQUIRE(byValue.size() == byRate.size());
    forAll(byValue, i)
    {
        CHECK(mag(byValue[i] - byRate[i]) < 1e-17);
    }
}


TEST_CASE("move: a clump that is turned is rigid and may drift", "[cloud][move]")
{
    const vector axis(1, 2, 2);
    const scalar rate = 5e4;
    autoPtr<openCloud> cloud
    (
        chain
        (
            "path { type move; clumpType chain; angularVelocity 5e4; axis (1 2 2); }"
        )
    );
    CHECK(mag(cloud->motion().held()) == 0);
    pointField arms;
    scalar mass = 0;
    for (const clumpParcel& p : *cloud)
    {
        arms = place(*cloud, p).arms;
        mass = cloud->type(p).mass();
    }
    run
    (
        *cloud, 100,
        [&](const scalar t, const place& p)
        {
            if (arms.size())
            {
                const tensor R(rotation(rate*t/3*axis).R());
                CHECK(max(mag(p.arms - (R & arms))) < 1e-17);
                CHECK(mag(p.velocity - vector(1e-3, 0, 0) - t/mass*push) < 1e-9);
            }
        }
    );
}


TEST_CASE("move: force and torque balance what they change", "[cloud][move][serial]")
{
    autoPtr<openCloud> cloud
    (
        chain
        (
            "path { type move; clumpType chain; displacement " + sine
          + " angle { type sine; frequency 3e4; amplitude 0.3; scale 1; level 0; t0 0; }"
            " axis (0 1 1); }"
        )
    );
    vector impulse(Zero), turn(Zero), before(Zero), momentum(Zero);
    scalar mass = 0;
    for (const clumpParcel& p : *cloud)
    {
        before = place(*cloud, p).velocity;
        momentum = place(*cloud, p).momentum;
        mass = cloud->type(p).mass();
    }
    run
    (
        *cloud, 50,
        [&](const scalar, const place& p)
        {
            REQUIRE(cloud->motion().constraints().size() == 1);
            const clumpMotion::constraint& c = cloud->motion().constraints()[0];
            impulse += step*(c.force + push);
            turn += step*(c.torque + (p.arms[0] ^ push));
            CHECK(mag(impulse - mass*(p.velocity - before)) < 1e-9*mass*1e-1);
            CHECK(mag(turn - (p.momentum - momentum)) < 1e-9*mass*1e-6*1e-1);
            CHECK(mag(c.centre - p.centre) < 1e-18);
            CHECK(mag(c.velocity - p.velocity) < 1e-12);
        }
    );
}


TEST_CASE("move: others feel a body that does not give way", "[cloud][move][serial]")
{
    // A bead is struck by one that moves, with a mass like its own or not
    const string density = GENERATE("1000", "1e6");
    const string loads =
        "loads { path { type move; clumpType mover; velocity (0.1 0 0); } }";
    const string body =
        " { shape { type chain; nSpheres 1; sphereRadius 1e-6; } bondModel { type elastic;"
        " rigidities { normal 1e-12; tangential 1e-12; bending 1e-24; torsional 1e-24; } }"
        " dampingModel { type none; } motion free; density ";
    openCloud cloud
    (
        testMesh(),
        dictOf
        (
            "types { mover" + body + density + "; } bead" + body + "1000; } }"
            "placement { type list; clumps"
            " ({ type mover; position (9e-6 10e-6 10e-6); velocity (0.1 0 0); }"
            " { type bead; position (11.05e-6 10e-6 10e-6); velocity (0 0 0); }); }"
            "integrator { type implicitEuler; tolerance 1e-10; maxIterations 100; }"
            "contactModel { type hertz; reducedModulus 1e6; restitution 0.5; }"
            "wallContactModel { type none; }"
            "rotation { type wholeClump; } couplingScheme { type robin; coefficient 1; }"
            "immersedBoundary { solidFraction { type tetClipping; }"
            " forcing { type sharp; } hydrodynamicForce { type momentumExchange; }"
            " interiorDilation yes; }" + loads + " effects { fluid off; }"
        )
    );
    vector impulse(Zero);
    scalar speed = 0, mass = 0;
    run
    (
        cloud, 20,
        [&](const scalar t, const place& p)
        {
            if (p.centre.x() - 0.1*t < start.x() + 1e-6)
            {
                CHECK(mag(p.centre - start - vector(0.1*t, 0, 0)) < 1e-18);
                for (const clumpMotion::constraint& c : cloud.motion().constraints())
                {
                    impulse += step*c.force;
                }
            }
            else
            {
                speed = p.velocity.x();
            }
        }
    );
    for (const clumpParcel& p : cloud)
    {
        if (cloud.type(p).name() == "bead")
        {
            mass = cloud.type(p).mass();
        }
    }
    reduce(impulse, sumOp<vector>());
    reduce(speed, maxOp<scalar>());
    reduce(mass, maxOp<scalar>());
    CHECK(mag(impulse - mass*vector(speed, 0, 0)) < 1e-6*mass*speed);
    CHECK(speed == Approx(0.15).epsilon(density == "1e6" ? 0.02 : 0.1));
}


TEST_CASE("move: a rod that turns strikes a bead with the torque of the table", "[cloud][move]")
{
    const bool rubs = GENERATE(false, true);
    const string bonds =
        " bondModel { type elastic; rigidities { normal 1e-9; tangential 1e-9;"
        " bending 1e-21; torsional 1e-21; } } dampingModel { type none; } motion free; ";
    openCloud cloud
    (
        testMesh(),
        dictOf
        (
            "types { rod { shape { type chain; nSpheres 3; spacing 1.5e-6;"
            " sphereRadius 1e-6; } density 1000;" + bonds + "}"
            " bead { shape { type chain; nSpheres 1; sphereRadius 1e-6; } density 1000;"
          + bonds + "} }"
            "placement { type list; clumps"
            " ({ type rod; position (9e-6 10e-6 10e-6); velocity (0 0 0);"
            " angularVelocity (0 0 1e4); }"
            " { type bead; position (10.5e-6 12.05e-6 10e-6); velocity (0 0 0); }); }"
            "integrator { type implicitEuler; tolerance 1e-10; maxIterations 100; }"
            "contactModel { type hertz; reducedModulus 1e6; restitution 0.2;"
          + string(rubs ? " friction 0.3; }" : " }")
          + "wallContactModel { type none; }"
            "rotation { type wholeClump; } couplingScheme { type robin; coefficient 1; }"
            "immersedBoundary { solidFraction { type tetClipping; }"
            " forcing { type sharp; } hydrodynamicForce { type momentumExchange; }"
            " interiorDilation yes; } loads { turn { type move; clumpType rod;"
            " velocity (0 0 0); angularVelocity 1e4; axis (0 0 1); } }"
            " effects { fluid off; }"
        )
    );
    vector impulse(Zero), turn(Zero), end(Zero), before(Zero);
    scalar mass = 0;
    for (const clumpParcel& p : cloud)
    {
        if (cloud.type(p).name() == "bead")
        {
            mass = cloud.type(p).mass();
        }
        else
        {
            before = place(cloud, p).momentum;
        }
    }
    reduce(mass, maxOp<scalar>());
    vector spin(Zero), after(Zero);
    run
    (
        cloud, 60,
        [&](const scalar t, const place& p)
        {
            const bool last = t > 59.5*step;
            if (p.arms.size() == 1)
            {
                end = last ? vector(mass*p.velocity) : vector::zero;
                spin =
                    last
                  ? vector(p.momentum + mass*((p.centre - start) ^ p.velocity))
                  : vector::zero;
                return;
            }
            after = last ? p.momentum : vector::zero;
            CHECK(mag(p.centre - start) < 1e-18);
            for (const clumpMotion::constraint& c : cloud.motion().constraints())
            {
                impulse += step*c.force;
                turn += step*c.torque;
            }
        }
    );
    for (vector* v : {&impulse, &turn, &end, &spin, &before, &after})
    {
        reduce(*v, sumOp<vector>());
    }
    CHECK(end.y() > mass*5e-3);
    CHECK(mag(impulse - end) < 1e-6*mag(end));

    // Implicit steps lose a little of the angular momentum about a distant point
    CHECK(mag(turn - (spin + after - before)) < 0.02*mag(turn));
}


TEST_CASE("move: entries that are refused", "[cloud][move]")
{
    const string begin = "a { type move; clumpType chain; ";
    CHECK_NOTHROW(chain(begin + "velocity (0 1 0); }"));
    CHECK_THROWS(chain(begin + "}"));
    CHECK_THROWS(chain(begin + "velocity (0 1 0); displacement (0 1 0); }"));
    CHECK_THROWS(chain(begin + "velocity (0 1 0); directions ((0 0 0)); }"));
    CHECK_THROWS(chain(begin + "velocity (0 1 0); axis (0 0 1); }"));
    CHECK_THROWS(chain(begin + "angularVelocity 1; }"));
    CHECK_THROWS(chain(begin + "angularVelocity 1; axis (0 0 0); }"));
    CHECK_THROWS(chain(begin + "angularVelocity 1; axis (1 0 0); directions ((1 0 0)); }"));
    CHECK_THROWS
    (
        chain
        (
            begin + "velocity (0 1 0); } b { type hold; clumpType chain;"
            " directions ((0 0 1)); }"
        )
    );
    CHECK_NOTHROW
    (
        chain
        (
            begin + "angularVelocity 1; axis (0 1 0); } b { type hold; clumpType chain;"
            " directions ((0 0 1)); }"
        )
    );

    // More than a radian in a step
    autoPtr<openCloud> fast(chain(begin + "angularVelocity 1e7; axis (1 0 0); }"));
    label nClumps = 0;
    for (const clumpParcel& p : *fast)
    {
        nClumps += p.state().x.size() > 0;
    }
    if (nClumps && Pstream::nProcs() == 1)
    {
        CHECK_THROWS(run(*fast, 1, [](const scalar, const place&) {}));
        testTime().setTime(0, testTime().timeIndex());
    }
}
