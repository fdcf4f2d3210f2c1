/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCloud.H"
#include "clumpCandidate.H"
#include "foamCompat.H"
#include "surfaceCrossing.H"
#include "surfaceDistance.H"

using namespace Foam;

namespace
{

//- A cloud of membranes and a few clumps of spheres in the test box (periodic in x and z)
autoPtr<openCloud> scene(const string& placement)
{
    return autoPtr<openCloud>
    (
        new openCloud
        (
            testMesh(),
            dictOf
            (
                "types"
                "{"
                "    capsule"
                "    {"
                "        shape { type icosphere; radius 3e-6; subdivisions 1; }"
                "        density 1000;"
                "        membrane { a { type neoHookean; shearModulus 1e-6; } }"
                "    }"
                "    cell"
                "    {"
                "        shape { type biconcave; diameter 7.82e-6; subdivisions 2; }"
                "        density 1000;"
                "        membrane { a { type neoHookean; shearModulus 1e-6; } }"
                "    }"
                "    bead { shape { type chain; nSpheres 1; sphereRadius 2e-6; }"
                "        density 1000; }"
                "    smallCapsule"
                "    {"
                "        shape { type icosphere; radius 2e-6; subdivisions 1; }"
                "        density 1000;"
                "        membrane { a { type neoHookean; shearModulus 1e-6; } }"
                "    }"
                "}"
                "placement { " + placement + " }"
                "effects { fluid on; }"
            )
        )
    );
}


//- Least distance [m] of nodes from surfaces of others, and of spheres
scalar leastGap(const openCloud& cloud)
{
    const UList<clumpImage>& images = cloud.ghosts().images();
    scalar least = GREAT;
    forAll(images, a)
    {
        const clumpType& A = cloud.types()[images[a].typeId];
        if (!A.hasTriangles())
        {
            continue;
        }
        const surfaceDistance distance(A.surface(), images[a].x);
        forAll(images, b)
        {
            const clumpType& B = cloud.types()[images[b].typeId];
            if (a == b || (a >= cloud.ghosts().nOwn() && b >= cloud.ghosts().nOwn()))
            {
                continue;
            }
            const auto places = distance.nearest(images[b].x);
            forAll(places, i)
            {
                least = min
                (
                    least,
                    places[i].distance - (B.hasTriangles() ? scalar(0) : B.radii()[i])
                );
            }
        }
    }
    return returnReduce(least, minOp<scalar>());
}


scalar enclosedVolume(const openCloud& cloud)
{
    scalar V = 0;
    for (const clumpParcel& p : cloud)
    {
        const clumpType& type = cloud.type(p);
        V += type.hasTriangles()
          ? type.surface().volume(p.state().x) : type.volume();
    }
    return returnReduce(V, sumOp<scalar>());
}

}


TEST_CASE("placement of membranes: packed by their surfaces", "[membrane][parallel]")
{
    const string of = GENERATE
    (
        // At 45 %, not all ways of packing capsules of 3 um between the walls succeed
        string("clumpType smallCapsule; haematocrit 0.45;"),
        string("clumpType cell; haematocrit 0.3;"),
        string("fractions { cell 0.4; capsule 0.3; bead 0.3; } haematocrit 0.3;")
    );
    INFO(of);
    const auto cloud = scene("type random; seed 3; " + of);
    const scalar gap = leastGap(*cloud);
    CHECK(gap >= 0);

    // Where there is room, no contact acts at the start: mesh cells of 1 um
    const bool roomy = of.find("clumpType cell") != string::npos;
    CHECK((!roomy || gap > 0.499e-6));

    // The haematocrit is that of the volume inside, to half a clump
    const scalar wanted = of.find("0.45") != string::npos ? 0.45 : 0.3;
    const scalar V = gSum(testMesh().V());
    CHECK(mag(enclosedVolume(*cloud)/V - wanted) < 0.51*113e-18/V);

    const surfaceCrossing crossing
    (
        testMesh(), cloud->types(), cloud->ghosts(), 0
    );
    CHECK(crossing.nClumps() == 0);
}


TEST_CASE("placement of membranes: a lattice closer than the nodes are thick",
    "[membrane][serial]")
{
    // Gaps of 0.1 um; the spheres around the nodes are 1.7 um wide
    const auto cloud = scene
    (
        "type lattice; clumpType capsule; origin (4e-6 3.2e-6 4e-6);"
        " spacing (6.4e-6 6.4e-6 6.4e-6); number (2 3 2);"
    );
    CHECK(cloud->nClumps() == 12);
    CHECK(leastGap(*cloud) > 0.1e-6);
    CHECK_THROWS
    (
        scene
        (
            "type lattice; clumpType capsule; origin (4e-6 3.2e-6 4e-6);"
            " spacing (5.6e-6 6.4e-6 6.4e-6); number (2 1 1);"
        )
    );
    CHECK_THROWS
    (
        scene
        (
            "type lattice; clumpType capsule; origin (4e-6 2.6e-6 4e-6);"
            " spacing (6.4e-6 6.4e-6 6.4e-6); number (2 1 1);"
        )
    );
}


TEST_CASE("placement of membranes: candidates are judged by their surfaces",
    "[membrane][serial]")
{
    const auto cloud = scene("type list; clumps ({ type bead; position (4e-6 4e-6 4e-6); });");
    const PtrList<clumpType>& types = cloud->types();
    const auto candidate = [&](const label type, const point& x)
    {
        return clumpCandidate(newClump(types[type], type, x));
    };
    const auto overlapping = [&]
    (
        const label a, const label b, const scalar distance, const scalar gap = 0
    )
    {
        const clumpCandidate A(candidate(a, point(1e-6, 0, 0)));
        const clumpCandidate B(candidate(b, point(1e-6, 1e-6, 0)));
        const vector shift(0, distance - 1e-6, 0);
        CHECK(overlap(A, B, types, gap, shift) == overlap(B, A, types, gap, -shift));
        return overlap(A, B, types, gap, shift);
    };
    const label capsule = 0, bead = 2;
    CHECK(overlapping(capsule, capsule, 5.7e-6));
    CHECK(!overlapping(capsule, capsule, 6.4e-6));
    CHECK(overlapping(capsule, capsule, 6.4e-6, 0.8e-6));
    CHECK(overlapping(capsule, bead, 4.8e-6));
    CHECK(!overlapping(capsule, bead, 5.3e-6));

    // A bead inside a capsule
    CHECK(overlapping(capsule, bead, 0.1e-6));
}


TEST_CASE("placement of membranes: refused", "[membrane][serial]")
{
    const string at(" { type capsule; position (10e-6 10e-6 10e-6);");

    // It has no inertia
    CHECK_NOTHROW(scene("type list; clumps (" + at + " });"));
    CHECK_THROWS(scene("type list; clumps (" + at + " velocity (1e-3 0 0); });"));
    CHECK_THROWS(scene("type list; clumps (" + at + " angularVelocity (0 0 9); });"));

    // At the same place, or a little beside
    CHECK_THROWS(scene("type list; clumps (" + at + " }" + at + " });"));
    CHECK_THROWS
    (
        scene
        (
            "type list; clumps (" + at + " }"
            " { type capsule; position (10.1e-6 10e-6 10e-6); });"
        )
    );

    // Its force would be that of the coefficients of the step
    CHECK_THROWS
    (
        scene
        (
            "type list; clumps (" + at + " }); }"
            " loads { all { type hold; clumpType capsule; directions ((1 0 0)); }"
        )
    );
}
