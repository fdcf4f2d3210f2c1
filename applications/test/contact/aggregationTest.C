/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "catch2/catch.hpp"
#include "touchingClumps.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

const scalar r = 0.5e-6;
const scalar length = 1e-7;
const scalar gamma = 1e-6;

//- What pulls two spheres apart [N]
scalar pullOff(const scalar radius)
{
    return constant::mathematical::pi*radius*gamma;
}

const string attraction
(
    "aggregation { type morse; surfaceEnergy 1e-6; length 1e-7; }"
);

const string elastic
(
    "type implicitEuler; tolerance 1e-9; maxIterations 200;"
);

//- A ring as stiff as the forces ask for, which lies in a plane of constant z
string ring(const string& name, const string& motion = "free")
{
    return
        name + " { shape { type ring; nSpheres 10; ringRadius 2.435e-6;"
        " sphereRadius 1.475e-6; } density 1000; massModel union; motion " + motion
      + "; bondModel { type elastic; youngModulus 1e4; shearModulus 1e4;"
        " multipliers { normal 1; tangential 1; bending 1; torsional 1; } }"
        " dampingModel { type none; } } ";
}

//- A pull along z on every sphere of the clumps of a type
string pull(const string& type, const label n, const scalar F)
{
    OStringStream os;
    os  << "loads { pull { type pointForces; clumpType " << type.c_str()
        << "; factor 1; spheres " << identity(n) << "; forces "
        << vectorField(n, vector(0, 0, F/n)) << "; torques "
        << vectorField(n, Zero) << "; } }";
    return os.str();
}

//- Distance of two clumps after some time, or when it exceeds a limit
scalar distanceAfter(dryCloud& t, const label nSteps, const scalar limit)
{
    scalar distance = 0;
    for (label step = 0; step < nSteps && distance < limit; ++step)
    {
        t.cloud->evolve();
        const vectorField x(t.centres());
        distance = x[1].z() - x[0].z();
        t.cloud->moveParcels();
    }
    return distance;
}

}


TEST_CASE("aggregation: what pulls two spheres apart", "[aggregation]")
{
    // The maximal force of the potential, from one side against a held sphere
    for (const scalar part : {0.97, 1.03})
    {
        dryCloud t
        (
            1e-4,
            at("held", point(10e-6, 10e-6, 10e-6), Zero)
          + at("sphere", point(10e-6, 10e-6, 10e-6 + 2*r), Zero),
            "reducedModulus 1000; restitution 1;", elastic,
            attraction + pull("sphere", 1, part*pullOff(r))
        );
        const scalar gap = distanceAfter(t, 100, 2*r + 11*length) - 2*r;
        INFO(part << ": gap " << gap);
        CHECK((part < 1 ? gap < length : gap > 10*length));
    }
}


TEST_CASE("aggregation: what pulls two rings apart", "[aggregation]")
{
    // Face to face, the sum over the pairs: L/(r sqrt(pi/2)) times that of a pair
    const scalar rs = 1.475e-6;
    const scalar F =
        constant::mathematical::twoPi*2.435e-6
       /(rs*Foam::sqrt(0.5*constant::mathematical::pi))*pullOff(rs);
    for (const scalar part : {0.93, 1.07})
    {
        dryCloud t
        (
            1e-4,
            at("held1", point(10e-6, 10e-6, 6e-6), Zero)
          + at("ring", point(10e-6, 10e-6, 6e-6 + 2*rs), Zero),
            "reducedModulus 1000; restitution 1;", elastic,
            attraction + pull("ring", 10, part*F)
          + "types { " + ring("held1", "fixed") + ring("ring") + "}"
        );
        const scalar gap =
            distanceAfter(t, 200, 2*rs + 11*length) - 2*rs;
        INFO(part << ": gap " << gap << ", force " << part*F);
        CHECK((part < 1 ? gap < length : gap > 10*length));
    }
}


TEST_CASE("aggregation: a rouleau holds at rest", "[aggregation]")
{
    // Four rings, moved out of line; the attraction draws them together, without a
    // force on the whole. They turn until the spheres of each lie in the gaps of the
    // next one, at a distance of down to 0.97 diameters
    const scalar rs = 1.475e-6;
    string clumps;
    for (label k = 0; k < 4; ++k)
    {
        clumps += at
        (
            "ring",
            point
            (
                (k % 2 ? 10.1 : 10)*1e-6, 10e-6, 4e-6 + k*(2*rs + 1.5e-7)
            ),
            Zero
        );
    }
    dryCloud t
    (
        1e-4, clumps, "reducedModulus 1000; restitution 0.5;", elastic,
        attraction + "types { " + ring("ring") + "}"
    );
    CHECK(t.cloud->effects().active("aggregation"));
    const vector before(sum(t.centres()));
    for (label step = 0; step < 200; ++step)
    {
        t.step();
    }
    const vectorField x(t.centres());
    CHECK(mag(sum(x) - before) < 1e-5*rs);
    for (label k = 0; k < 3; ++k)
    {
        INFO(k << ": " << x[k + 1].z() - x[k].z());
        const scalar distance = x[k + 1].z() - x[k].z();
        CHECK(distance < 2*rs + 0.5*length);
        CHECK(distance > 1.85*rs);
    }
}


TEST_CASE("aggregation: off without an entry, refused without contact", "[aggregation]")
{
    const string pair
    (
        at("sphere", point(10e-6, 10e-6, 10e-6), Zero)
      + at("sphere", point(10e-6, 10e-6, 11.1e-6), Zero)
    );
    const string law("reducedModulus 1000; restitution 1;");
    CHECK(!dryCloud(1e-4, pair).cloud->effects().active("aggregation"));
    CHECK_THROWS
    (
        dryCloud(1e-4, pair, law, elastic, "effects { aggregation on; }")
    );
    CHECK_THROWS
    (
        dryCloud
        (
            1e-4, pair, law, elastic,
            attraction + "effects { aggregation on; contact off; }"
        )
    );
    CHECK_THROWS
    (
        dryCloud(1e-4, pair, law, elastic, "aggregation { type morse; length 1e-7; }")
    );
}
