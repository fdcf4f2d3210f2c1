/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

const scalar pi = constant::mathematical::pi;

clumpType typeOf(const string& shape, const string& more = "")
{
    return clumpType
    (
        "test", dictOf("density 1000; shape { " + shape + " } " + more)
    );
}

}


TEST_CASE("surfaces: spheres and red cells", "[membrane][serial]")
{
    const clumpType sphere(typeOf("type icosphere; radius 2e-6; subdivisions 3;"));
    CHECK(sphere.hasTriangles());
    CHECK(sphere.size() == 642);
    CHECK(sphere.volume() == Approx(pi*4/3*8e-18).epsilon(1e-12));
    CHECK(sphere.mass() == Approx(1000*sphere.volume()).epsilon(1e-12));
    CHECK(sphere.halfWidth() == Approx(2e-6).epsilon(0.01));

    // The area converges with the second order
    const scalar coarse = 1 -
        typeOf("type icosphere; radius 1; subdivisions 2;").halfWidth();
    const scalar fine = 1 -
        typeOf("type icosphere; radius 1; subdivisions 3;").halfWidth();
    CHECK(coarse > 0);
    CHECK(fine/coarse == Approx(0.25).margin(0.02));

    // 94 um3 and 135 um2, Evans & Fung 1972
    const clumpType cell(typeOf("type biconcave; diameter 7.82e-6; subdivisions 4;"));
    CHECK(cell.volume() == Approx(94e-18).epsilon(0.01));
    CHECK(cell.surface().area(cell.centres()) == Approx(135e-12).epsilon(0.01));
    CHECK(mag(cell.surface().centroid(cell.centres())) < 1e-12);
}


TEST_CASE("surfaces: area vectors are the gradient of the volume", "[membrane][serial]")
{
    const clumpType type(typeOf("type biconcave; diameter 2; subdivisions 2;"));
    const closedSurface& surface = type.surface();
    Random random(1);
    pointField x(type.centres());
    for (point& p : x)
    {
        p += 0.02*randomVector(random);
    }
    const vectorField g(surface.areaVectors(x));
    CHECK(mag(sum(g)) < 1e-14);
    CHECK(sum(g & x) == Approx(3*surface.volume(x)).epsilon(1e-12));

    const scalar h = 1e-5;
    vectorField v(x.size());
    for (vector& e : v)
    {
        e = randomVector(random);
    }
    CHECK
    (
        sum(g & v)
     == Approx((surface.volume(x + h*v) - surface.volume(x - h*v))/(2*h)).epsilon(1e-6)
    );

    // Far from the origin nothing changes
    const pointField far(x + vector(1e3, 0, 0));
    CHECK(surface.volume(far) == Approx(surface.volume(x)).epsilon(1e-10));
}


TEST_CASE("surfaces: second moments of an ellipsoid", "[membrane][serial]")
{
    const clumpType type(typeOf("type icosphere; radius 1; subdivisions 4;"));
    pointField x(type.centres());
    for (point& p : x)
    {
        p = vector(3*p.x(), 2*p.y(), p.z()) + vector(5, 5, 5);
    }
    const symmTensor M(type.surface().secondMoments(x));
    const scalar V = type.surface().volume(x);
    CHECK(M.xx() == Approx(V*9/5).epsilon(0.005));
    CHECK(M.yy() == Approx(V*4/5).epsilon(0.005));
    CHECK(M.zz() == Approx(V*1/5).epsilon(0.005));
    CHECK(mag(M.xy()) < 1e-6*V);
}


TEST_CASE("surfaces: those that are not one closed surface are refused", "[membrane][serial]")
{
    const pointField x({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    typedef std::initializer_list<FixedList<label, 3>> corners;
    const auto surfaceOf = [&](const corners& triangles)
    {
        DynamicList<triFace> faces;
        for (const auto& t : triangles)
        {
            faces.append(triFace(t[0], t[1], t[2]));
        }
        return closedSurface(x, faces, dictionary::null);
    };
    const auto throws = [&](const corners& triangles)
    {
        CHECK_THROWS(surfaceOf(triangles));
    };
    throws({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}});                  // open
    throws({{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 3, 2}});       // oriented at odds
    throws({{0, 1, 2}, {0, 2, 1}});                             // node 3 is loose
    throws({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 4}});       // no node 4

    // Turned inside out it is the same
    CHECK(surfaceOf({{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}).volume(x) == Approx(1.0/6));
    CHECK(surfaceOf({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}).volume(x) == Approx(1.0/6));

    // Two tetrahedra are two surfaces
    pointField two(x);
    two.append(x + vector(3, 0, 0));
    List<triFace> faces(8);
    const FixedList<triFace, 4> one
    ({
        triFace(0, 1, 2), triFace(0, 3, 1), triFace(0, 2, 3), triFace(1, 3, 2)
    });
    forAll(one, n)
    {
        const triFace& t = one[n];
        faces[n] = t;
        faces[n + 4] = triFace(t[0] + 4, t[1] + 4, t[2] + 4);
    }
    CHECK_THROWS(closedSurface(two, faces, dictionary::null));
}
