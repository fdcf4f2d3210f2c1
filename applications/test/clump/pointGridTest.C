/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "nearestCentres.H"
#include "pointGrid.H"
#include "Random.H"
#include "sphereDistance.H"
#include "sphereUnion.H"
#include <algorithm>

using namespace Foam;

namespace
{

point randomPoint(Random& random)
{
    return random.position<vector>(point(-1, -1, -1), point(1, 1, 1));
}

}


TEST_CASE("point grid: no point of a box is missed", "[pointGrid][boundary]")
{
    // Points in space, in a plane, on a line, in one place, none; some of them in
    // a corner, where a refined mesh has most of its cells
    const label nDirections = GENERATE(3, 2, 1, 0);
    const label n = GENERATE(0, 1, 2, 3000);
    Random random(7);
    pointField points(n);
    forAll(points, i)
    {
        point x(randomPoint(random));
        if (i % 3 == 0)
        {
            x = point(1, 1, 1) - 0.01*(point(1, 1, 1) + x);
        }
        for (direction d = 0; d < 3; ++d)
        {
            points[i][d] = d < nDirections ? x[d] : 0.3;
        }
    }
    pointGrid grid;
    grid.update(points);

    DynamicList<label> found;
    bool complete = true, ascending = true;
    for (label k = 0; k < 200; ++k)
    {
        // Also boxes that reach out of the points' own, or lie beside it
        const point centre(1.5*randomPoint(random));
        const scalar half = k % 2 ? 0.1 : 0.7;
        const boundBox box
        (
            centre - half*vector::one, centre + half*vector::one
        );
        grid.find(box, found);

        forAll(points, i)
        {
            complete =
                complete && (found.found(i) || !box.contains(points[i]));
        }
        ascending =
            ascending && std::is_sorted(found.begin(), found.end());
    }
    CHECK(complete);
    CHECK(ascending);
}


TEST_CASE("point grid: little around a box is read", "[pointGrid][boundary]")
{
    // A regular mesh of 40^3 cells of width 1, a box of 6^3
    pointField points(64000);
    forAll(points, i)
    {
        points[i] = point(i % 40, (i/40) % 40, i/1600);
    }
    pointGrid grid;
    grid.update(points);

    DynamicList<label> found;
    const point low(10.5, 20.5, 30.5);
    grid.find(boundBox(low, low + 6*vector::one), found);

    CHECK(found.size() >= 6*6*6);
    CHECK(found.size() <= 8*8*8);
}


TEST_CASE("point grid: points in one place", "[pointGrid][boundary]")
{
    pointGrid grid;
    grid.update(pointField(5, point(1, 2, 3)));
    DynamicList<label> found;

    grid.find(boundBox(point(0, 0, 0), point(4, 4, 4)), found);
    CHECK(found.size() == 5);

    // However far away
    grid.find(boundBox(point(2, 2, 2), 1e200*vector::one), found);
    CHECK(found.empty());
}


TEST_CASE("sphere distance: that of the union", "[pointGrid][boundary]")
{
    const bool same = GENERATE(true, false);
    Random random(3);
    pointField centres(10);
    scalarField radii(10);
    forAll(centres, i)
    {
        centres[i] = randomPoint(random);
        radii[i] = same ? 0.3 : 0.2 + 0.02*i;
    }
    const sphereDistance distance(centres, radii);
    const scalarField wider(radii + 0.1/radii);

    for (label k = 0; k < 200; ++k)
    {
        const point p(2*randomPoint(random));
        CHECK
        (
            distance(p)
         == Approx(sphereUnion::distance(p, centres, radii)).margin(1e-14)
        );
        CHECK
        (
            distance(p, [](const scalar r) { return r + 0.1/r; })
         == Approx(sphereUnion::distance(p, centres, wider)).margin(1e-14)
        );
    }
}


TEST_CASE("nearest centres: those of all, at a linear cost", "[pointGrid][boundary]")
{
    // As many centres per volume, in a space eight times as large
    const scalar reach = GENERATE(0.05, 0.2, 10.0);
    Random random(5);
    labelList compared(2);
    for (const label larger : {0, 1})
    {
        const label n = larger ? 1600 : 200;
        const scalar width = larger ? 2 : 1;
        pointField centres(n), points(8*n);
        for (pointField* x : {&centres, &points})
        {
            for (point& p : *x)
            {
                p = width*randomPoint(random);
            }
        }
        const labelList found
        (
            nearestCentres(points, centres, reach, &compared[larger])
        );

        label wrong = 0, none = 0;
        forAll(points, k)
        {
            scalar least = sqr(reach);
            label expected = -1;
            forAll(centres, i)
            {
                const scalar d = magSqr(centres[i] - points[k]);
                if (d < least)
                {
                    least = d;
                    expected = i;
                }
            }
            wrong += found[k] != expected;
            none += expected < 0;
        }
        CHECK(wrong == 0);
        CHECK((none > 0) == (reach < 1));
    }
    INFO(compared[0] << " and " << compared[1] << " comparisons");
    CHECK(compared[1] < 1.5*8*compared[0]);

    // None, and one
    CHECK(nearestCentres(pointField(1), pointField(), 1)[0] == -1);
    CHECK(nearestCentres(pointField(3, point::zero), pointField(1, point::one), 2)[2] == 0);
}
