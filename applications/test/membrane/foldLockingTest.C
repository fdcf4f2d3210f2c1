/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testMembrane.H"
#include "foldLocking.H"
#include "surfaceFold.H"

using namespace Foam;

namespace
{

const scalar stiffness = 3;

//- The first hinge of a sphere, closed like a book by turning one of its triangles until
//  the normals have an angle
struct book
{
    testMembrane membrane{"a { type neoHookean; shearModulus 1; }"};
    const closedSurface& surface = membrane.type.surface();
    const closedSurface::hinge& hinge = surface.hinges()[0];
    foldLocking locking{surface, membrane.type.centres(), stiffness};

    pointField closed(const scalar angle) const
    {
        pointField x(membrane.type.centres());
        const surfaceFold at(hinge, x);
        const quaternion q(at.along, angle - at.angle);
        x[hinge.right] = x[hinge.i] + q.transform(x[hinge.right] - x[hinge.i]);
        return x;
    }

    scalar energy(const pointField& x) const
    {
        vectorField unused(x.size(), Zero);
        return locking.add(x, unused, nullptr);
    }

    vectorField gradient(const pointField& x) const
    {
        vectorField g(x.size(), Zero);
        locking.add(x, g, nullptr);
        return g;
    }
};

}


TEST_CASE("foldLocking: only what folds beyond two radians", "[membrane][serial]")
{
    const book b;
    CHECK(surfaceFold(b.hinge, b.closed(1.7)).angle == Approx(1.7));
    CHECK(b.energy(b.membrane.type.centres()) == 0);
    CHECK(max(mag(b.gradient(b.membrane.type.centres()))) == 0);

    // Convex or concave; the neighbours of the triangle that turns fold as well
    for (const scalar side : {-1, 1})
    {
        for (const scalar angle : {2.2, 2.6, 3.0, 3.1})
        {
            const scalar k = 10*stiffness/b.surface.nNodes();
            CHECK(b.energy(b.closed(side*angle)) >= k*pow3(angle - 2)*(1 - 1e-9));
        }
    }
}


TEST_CASE("foldLocking: a shape that is folded at rest is at rest", "[membrane][serial]")
{
    const book b;
    const pointField x(b.closed(2.5));
    const foldLocking locking(b.surface, x, stiffness);
    vectorField g(x.size(), Zero);
    CHECK(locking.add(x, g, nullptr) == 0);
    CHECK(locking.add(b.closed(2.6), g, nullptr) > 0);
}


TEST_CASE("foldLocking: gradient, tangent, no force and torque", "[membrane][serial]")
{
    const book b;
    const scalar side = GENERATE(-1, 1);
    const pointField x(b.closed(side*2.7));
    const vectorField g(b.gradient(x));
    REQUIRE(max(mag(g)) > 0);

    vector torque(Zero);
    forAll(x, i)
    {
        torque += x[i] ^ g[i];
    }
    CHECK(mag(sum(g)) < 1e-12*sum(mag(g)));
    CHECK(mag(torque) < 1e-12*sum(mag(g)));

    membraneTangent tangent(b.surface, 1);
    tangent.clear();
    vectorField unused(x.size(), Zero);
    b.locking.add(x, unused, &tangent);

    const closedSurface::hinge& h = b.hinge;
    Random random(3);
    const scalar e = 1e-6;
    for (const label i : {h.i, h.j, h.left, h.right})
    {
        const vector d(randomVector(random));
        pointField plus(x), minus(x);
        plus[i] += e*d;
        minus[i] -= e*d;
        const scalar slope = (b.energy(plus) - b.energy(minus))/(2*e);
        CHECK((g[i] & d) == Approx(slope).epsilon(1e-6).margin(1e-8));
    }

    // Along the turn of the triangle the angle is linear, and Gauss-Newton's is exact
    vectorField turn(x.size(), Zero);
    turn[h.right] =
        surfaceFold(h, x).along ^ (x[h.right] - x[h.i]);
    const auto v = membraneTangent::asVector(turn);
    CHECK(v.dot(tangent.times(v)) > 0);
    CHECK
    (
        v.dot(tangent.times(v))
     >= 6*10*stiffness/b.surface.nNodes()*0.7*(1 - 1e-9)
    );
}
