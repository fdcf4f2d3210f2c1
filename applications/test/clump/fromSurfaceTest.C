/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "clump/closedSurfaces.H"
#include "testCase.H"
#include "mathematicalConstants.H"
#include "OSspecific.H"
#include "shape.H"
#include "sphereFilling.H"
#include "sphereUnion.H"

using namespace Foam;

namespace
{

//- All spheres hang together
bool connected(const sphereFilling& filling)
{
    labelList group(identity(filling.centres().size()));
    for (const labelPair& bond : filling.tree())
    {
        const label from = group[bond.second()], to = group[bond.first()];
        for (label& g : group)
        {
            g = g == from ? to : g;
        }
    }
    return min(group) == max(group);
}


//- Every centre in its own region, see sphereUnion
bool ownRegions(const sphereFilling& filling)
{
    const auto& x = filling.centres();
    const auto& r = filling.radii();
    forAll(x, i)
    {
        forAll(x, j)
        {
            if (i != j && magSqr(x[i] - x[j]) + sqr(r[i]) - sqr(r[j]) <= 0)
            {
                return false;
            }
        }
    }
    return true;
}

}


TEST_CASE("fromSurface: a sphere is one sphere", "[serial][sizes]")
{
    const triSurface surface(ellipsoid(2*vector::one));
    const sphereFilling filling(surface, 0.05, 200);
    REQUIRE(filling.centres().size() == 1);
    CHECK(mag(filling.centres()[0]) < 1e-9);
    CHECK(mag(filling.volumeError()) < 1e-3);

    // Facets of 16 x 6 in the octants lie inside of the sphere
    CHECK(filling.radii()[0] == Approx(2).epsilon(0.01));
    CHECK(sphereFilling::volume(surface) == Approx(33.51).epsilon(0.02));
}


TEST_CASE("fromSurface: volume and surface of known shapes", "[serial][sizes]")
{
    const label shape = GENERATE(0, 1, 2);
    const triSurface surface
    (
        shape == 0 ? ellipsoid(vector(3, 1.5, 1))
      : shape == 1 ? ellipsoid(vector(2, 2, 0.8))
      : cube(8, [](const point& x) { return x; })
    );
    const scalar V = shape == 2 ? 8 : sphereFilling::volume(surface);
    CHECK
    (
        sphereFilling::volume(surface)
     == Approx
        (
            shape == 2 ? 8
          : constant::mathematical::pi*4/3*(shape == 0 ? 4.5 : 3.2)
        ).epsilon(0.02)
    );

    scalar before = GREAT;
    label nBefore = 0;
    for (const scalar part : {1.0, 0.5, 0.25})
    {
        // Edges need many spheres
        const scalar error = (shape == 2 ? 0.4 : 0.2)*part;
        const sphereFilling filling(surface, error, 500);
        CHECK(filling.uncovered() <= error);
        CHECK(filling.centres().size() > nBefore);
        CHECK(filling.meanDistance() < before);
        nBefore = filling.centres().size();
        before = filling.meanDistance();

        CHECK
        (
            sphereUnion::volume(filling.centres(), filling.radii())
         == Approx(V).epsilon(2e-3)
        );
        CHECK(connected(filling));
        CHECK(ownRegions(filling));
        Info<< "shape " << shape << ", error " << error << ": "
            << filling.centres().size() << " spheres, distance of the surfaces "
            << filling.meanDistance() << ", largest " << filling.largestDistance()
            << endl;
    }
    CHECK(before < 0.03*Foam::cbrt(V));
}


TEST_CASE("fromSurface: a file of the case", "[serial][sizes]")
{
    // In micrometres
    const fileName file(getEnv("FOAM_CASE")/"box.stl");
    cube(2, [](const point& x) { return 3*x; }).write(file);

    const auto made = [](const string& entries)
    {
        return clumpShapes::shape::New(dictOf("type fromSurface; " + entries));
    };
    const auto box(made("file \"box.stl\"; scale 1e-6; error 0.1;"));
    CHECK
    (
        sphereUnion::volume(box->centres(), box->radii())
     == Approx(216e-18).epsilon(2e-3)
    );
    CHECK(box->bonds().size() == box->centres().size() - 1);

    CHECK_THROWS(made("file \"notThere.stl\"; error 0.1;"));
    CHECK_THROWS(made("file \"box.stl\"; error 0.9;"));
    CHECK_THROWS(made("file \"box.stl\"; error 0.02; maxSpheres 5;"));

    triSurface open(cube(2, [](const point& x) { return 3*x; }));
    boolList all(open.size(), true);
    all[0] = false;
    open.subsetMesh(all).write(file);
    CHECK_THROWS(made("file \"box.stl\"; error 0.1;"));
    rm(file);
}
