/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "cellModel.H"
#include "constraintForces.H"
#include "Random.H"
#include "symmetryPlanes.H"

using namespace Foam;

namespace
{

//- One mesh cell of 2 x 3 x 4 m, of which the corner opposite to the origin is moved; the
//  faces at x = 0 and y = 0, or x = 0 and x = 2, are patches of a type
autoPtr<polyMesh> cellMesh
(
    const word& type,
    const bool opposite,
    const vector& moved = Zero
)
{
    pointField x
    ({
        point(0, 0, 0), point(2, 0, 0), point(2, 3, 0), point(0, 3, 0),
        point(0, 0, 4), point(2, 0, 4), point(2, 3, 4), point(0, 3, 4)
    });
    x[6] += moved;
    const face low({0, 4, 7, 3});
    const face high({1, 2, 6, 5});
    const face front({0, 1, 5, 4});
    const cellModel& hex = cellModel::ref(cellModel::HEX);
    return autoPtr<polyMesh>::New
    (
        IOobject
        (
            "cellMesh", testMesh().time().constant(), testMesh().time(),
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        std::move(x),
        cellShapeList(1, cellShape(hex, identity(8))),
        faceListList({faceList(1, low), faceList(1, opposite ? high : front)}),
        wordList({"one", "two"}),
        wordList({type, type}),
        "rest",
        "patch",
        wordList(2)
    );
}

}


TEST_CASE("symmetry: images behind planes, an edge of two planes and periods", "[cloud]")
{
    const point x(0.3, 0.5, 1);
    const vector period(0, 0, 4);
    const auto mesh = cellMesh("symmetryPlane", false);
    const symmetryPlanes planes(mesh->boundaryMesh());
    REQUIRE(planes.planes().size() == 2);
    CHECK(planes.fault(List<vector>({period})).empty());

    const auto images = planes.transforms
    (
        List<vector>({vector(Zero), period, -period})
    );
    REQUIRE(images.size() == 9);
    DynamicList<point> expected;
    for (const point& at : {point(-0.3, 0.5, 1), point(0.3, -0.5, 1), point(-0.3, -0.5, 1)})
    {
        expected.append(at);
        expected.append(at + period);
        expected.append(at - period);
    }
    for (const point& at : expected)
    {
        label n = 0;
        for (const imageTransform& t : images)
        {
            n += mag(t.position(x) - at) < 1e-12;
        }
        CHECK(n == 1);
    }

    // Two that face each other have no image of an image
    const auto slit = cellMesh("symmetry", true);
    const auto near =
        symmetryPlanes(slit->boundaryMesh()).transforms(List<vector>(1, vector(Zero)));
    REQUIRE(near.size() == 2);
    CHECK(mag(near[0].position(x).x() + near[1].position(x).x() - 3.4) < 1e-12);
}


TEST_CASE("symmetry: planes that cannot be used are found", "[cloud]")
{
    // Not flat, at an angle, across the period
    const auto bent = cellMesh("symmetry", true, vector(0.2, 0, 0));
    const auto straight = cellMesh("symmetry", true);
    const auto fault = [](const polyMesh& mesh, const List<vector>& periods)
    {
        return symmetryPlanes(mesh.boundaryMesh()).fault(periods);
    };
    CHECK(fault(*straight, List<vector>()).empty());
    CHECK(fault(*bent, List<vector>()).find("Patch two of type symmetry is not flat") == 0);
    CHECK
    (
        fault(*straight, List<vector>(1, vector(0.1, 0, 4))).find("not parallel")
     != std::string::npos
    );
}


TEST_CASE("symmetry: an image moves and is pushed as a mirror shows it", "[cloud]")
{
    Random random(3 + Pstream::myProcNo());
    const auto any = [&]() { return random.sample01<vector>() - 0.5*vector::one; };
    for (label nMirrors = 0; nMirrors <= 2; ++nMirrors)
    {
        imageTransform t;
        const vector n(normalised(any()));
        const vector m(normalised(any() ^ n));
        t.shift = 0.6*n;
        t.nMirrors = nMirrors;
        t.reflection -= nMirrors > 0 ? 2*sqr(n) : symmTensor(Zero);
        t.reflection -= nMirrors > 1 ? 2*sqr(m) : symmTensor(Zero);

        // The velocity of a rigid motion at an image of a point
        const point x(any()), centre(any());
        const vector u(any()), omega(any());
        const vector seen
        (
            t.polar(u)
          + (t.axial(omega) ^ (t.position(x) - t.position(centre)))
        );
        CHECK(mag(seen - t.polar(u + (omega ^ (x - centre)))) < 1e-12);

        // The power of forces and torques is the same after they have returned
        constraintForces sums;
        sums.reset(1);
        sums.f[0] = any();
        sums.t[0] = any();
        sums.solidMoments[0] = t.polar(u);
        sums.solidInertias[0] = sqr(t.polar(omega));
        const scalar power = (sums.f[0] & t.polar(u)) + (sums.t[0] & t.axial(omega));
        sums.bringBack(t);
        CHECK(mag((sums.f[0] & u) + (sums.t[0] & omega) - power) < 1e-12);
        CHECK(mag(sums.solidMoments[0] - u) < 1e-12);
        CHECK(mag(sums.solidInertias[0] - sqr(omega)) < 1e-12);

        // A box holds the images of its points
        const boundBox box(point(-0.5, -0.5, -0.5), point(0.5, 0.5, 0.5));
        CHECK(t.box(box).contains(t.position(x)));
        if (t.mirrors())
        {
            CHECK(mag(t.position(t.position(x)) - x) < 1e-12);
        }
    }
}
