/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "fluidCoupling.H"
#include "testCloud.H"
#include "clumpDisplacement.H"
#include "wallSurface.H"
#include "mathematicalConstants.H"

using namespace Foam;

TEST_CASE("cloud: a clump outside the mesh is refused", "[cloud]")
{
    CHECK_THROWS(testCloud(point(1e-3, 10e-6, 10e-6)));

    // Its centre is inside, a sphere is behind the wall
    CHECK_THROWS(testCloud(point(10e-6, 0.5e-6, 10e-6)));

    // Across a periodic boundary it is whole
    CHECK_NOTHROW(testCloud(point(0.1e-6, 10e-6, 10e-6)));
}


TEST_CASE("cloud: free flight through every periodic boundary", "[cloud]")
{
    const vector u(0.3, 0, 0.2);
    testCloud t
    (
        point(10e-6, 10e-6, 10e-6), u, Zero, "wholeClump", false
    );
    const scalar dt = testTime().deltaTValue();

    // Three periods in x, two in z: back where it came from
    const label nSteps = round(60e-6/(u.x()*dt));
    for (label step = 0; step < nSteps; ++step)
    {
        t.cloud().evolve();
        t.cloud().accept();
        t.cloud().moveParcels();
    }
    REQUIRE(t.cloud().nClumps() == 1);

    scalar away = 0;
    for (const clumpParcel& p : t.cloud())
    {
        away = mag(p.centre(t.type()) - point(10e-6, 10e-6, 10e-6));
        CHECK(mag(p.state().velocity(t.type()) - u) < 1e-10*mag(u));
    }
    CHECK(returnReduce(away, maxOp<scalar>()) < 1e-9*20e-6);
}


TEST_CASE("cloud: a clump that is thrown through a wall is tracked along it", "[cloud]")
{
    // The normals of faces have errors of rounding, as the displacement along them has
    testCloud t(point(10e-6, 15e-6, 10e-6), Zero, Zero, "wholeClump", false);
    Random random(3);
    point expected(10e-6, 15e-6, 10e-6);
    for (label n = 0; n < 2000; ++n)
    {
        vector d
        (
            random.position(vector(-3e-6, -6e-6, -3e-6), vector(3e-6, 6e-6, 3e-6))
        );
        for (clumpParcel& p : t.cloud())
        {
            p.state().x += d;
        }
        expected += d;
        t.cloud().moveParcels();
        REQUIRE(t.cloud().nClumps() == 1);
    }
    scalar away = 0;
    for (const clumpParcel& p : t.cloud())
    {
        away = mag(p.unwrappedCentre(t.type()) - expected);
    }
    CHECK(returnReduce(away, maxOp<scalar>()) < 1e-12);
}


TEST_CASE("cloud: a collision conserves momentum", "[cloud][contact]")
{
    // Head-on across the periodic boundary in x
    const vector u(0.01, 0, 0);
    testCloud t(point(14e-6, 10e-6, 10e-6), u, Zero, "wholeClump", false);
    t.add(point(25e-6 - 20e-6, 10.7e-6, 10.4e-6), -u);

    const scalar size = t.type().mass()*mag(u);
    const vector before(t.momentum());
    CHECK(mag(before) < 1e-10*size);

    scalar slowest = mag(u);
    for (label step = 0; step < 300; ++step)
    {
        t.cloud().evolve();
        t.cloud().accept();
        t.cloud().moveParcels();
        scalar speed = 0;
        for (const clumpParcel& p : t.cloud())
        {
            speed = max(speed, mag(p.state().velocity(t.type())));
        }
        slowest = min(slowest, returnReduce(speed, maxOp<scalar>()));
    }

    // They met
    CHECK(slowest < 0.5*mag(u));
    CHECK(t.cloud().timing().calls("contact") > 0);
    CHECK(mag(t.momentum() - before) < 1e-10*size);
}


TEST_CASE("cloud: walls are felt from either side of a processor boundary", "[cloud][walls]")
{
    testCloud t(point(10e-6, 10e-6, 10e-6), Zero, Zero, "wholeClump", false);
    const wallSurface walls(testMesh(), t.cloud().ghosts());
    const scalar r = 2e-6;

    if (walls.empty())
    {
        return;
    }

    // Those near the lower wall of this processor
    const boundBox& box = t.cloud().ghosts().localBox();
    if (box.min().y() < 1e-9)
    {
        const point x(box.midpoint().x(), 1.5e-6, box.midpoint().z());
        const auto contacts(walls.contacts(x, r));
        REQUIRE(contacts.size() == 1);
        CHECK(mag(contacts[0].normal - vector(0, 1, 0)) < 1e-9);
        CHECK(contacts[0].overlap == Approx(0.5e-6).epsilon(1e-6));
        CHECK(walls.distance(x, 1) == Approx(1.5e-6).epsilon(1e-6));
        CHECK(walls.contacts(x + vector(0, 1e-6, 0), r).empty());
    }
}


TEST_CASE("cloud: curvature of walls across processor boundaries", "[cloud][walls]")
{
    // For a clump on every processor
    ghostExchange ghosts(testMesh());
    ghosts.own(1)[0].reach = 4e-6;
    ghosts.updateNeighbours();

    // A post in the middle of the box: the faces whose centres this processor has, and
    // all of them, which others add once more
    const scalar R = 4e-6, r = 2e-6;
    const label n = 48, m = 10;
    pointField points;
    faceList all, own;
    for (label j = 0; j <= m; ++j)
    {
        for (label i = 0; i < n; ++i)
        {
            const scalar angle = constant::mathematical::twoPi*(i + 0.3)/n;
            points.append
            (
                point(10.01e-6, 10.02e-6, 5e-6 + 1e-6*j)
              + R*vector(Foam::cos(angle), Foam::sin(angle), 0)
            );
        }
    }
    for (label f = 0; f < n*m; ++f)
    {
        const label next = f - f % n + (f + 1) % n;
        all.append(face(labelList({f, f + n, next + n, next})));
        if (testMesh().findCell(all.last().centre(points)) >= 0)
        {
            own.append(all.last());
        }
    }
    CHECK(returnReduce(own.size(), sumOp<label>()) == all.size());
    const wallSurface walls(own, points, ghosts);
    const wallSurface reference(all, points, ghosts);

    for (label k = 0; k < 40; ++k)
    {
        const vector out
        (
            Foam::cos(0.16*k), Foam::sin(0.16*k), 0
        );
        const point x(point(10.01e-6, 10.02e-6, 10.3e-6) + (R + 1.05*r)*out);
        if (testMesh().findCell(x) < 0)
        {
            continue;
        }
        const auto curvature = [&](const wallSurface& surface)
        {
            const vector width(1.5*r*vector::one);
            const auto films
            (
                surface.films
                (
                    x, r, 0.1*r, 0.2*r, surface.near(boundBox(x - width, x + width))
                )
            );
            REQUIRE(films.size() >= 1);
            return films[0].curvature;
        };
        const symmTensor found(curvature(walls));
        CHECK(R*mag(found - curvature(reference)) < 1e-8);
        CHECK(R*tr(found) == Approx(1).epsilon(0.05));
        CHECK(R*mag(found.zz()) < 0.01);
    }
}


TEST_CASE("cloud: walls of processors that become neighbours", "[cloud][walls]")
{
    // Two spheres that touch the floor are drawn apart, to 5.3 um from their
    // middle: on four ranks in a row the second one is then above the floor of a
    // processor that was no neighbour of its clump's
    dictionary dict
    (
        dictOf
        (
            "types { pair { shape { type chain; nSpheres 2; spacing 0.6e-6;"
            " sphereRadius 0.3e-6; } density 1000; massModel union; motion free;"
            " bondModel { type elastic; rigidities { normal 1e-15;"
            " tangential 1e-15; bending 1e-30; torsional 1e-30; } }"
            " dampingModel { type none; } } }"
            "placement { type list; clumps ({ type pair;"
            " position (9.9e-6 0.2e-6 4.9e-6); }); }"
            "integrator { type implicitEuler; tolerance 1e-9;"
            " maxIterations 100; }"
            "contactModel { type none; }"
            "wallContactModel { type hertz; reducedModulus 100; restitution 1; }"
            "effects { fluid off; walls on; }"
        )
    );
    const scalar dt0 = testTime().deltaTValue();
    testTime().setDeltaT(1e-9, false);
    openCloud cloud(testMesh(), dict);
    cloud.evolve();
    cloud.accept();

    vectorField u(2, Zero);
    for (clumpParcel& p : cloud)
    {
        clumpState& s = p.state();
        s.u = Zero;
        s.w = Zero;
        s.x[0].x() = -5.3e-6;
        s.x[1].x() = 5.3e-6;
    }
    cloud.evolve();
    cloud.accept();
    for (const clumpParcel& p : cloud)
    {
        u = p.state().u;
    }
    testTime().setDeltaT(dt0, false);

    reduce(u[0], sumOp<vector>());
    reduce(u[1], sumOp<vector>());
    CHECK(u[0].y() > 0);
    CHECK(u[1].y() == Approx(u[0].y()).epsilon(0.01));
}


TEST_CASE("cloud: effects follow the scene", "[cloud][effects]")
{
    testCloud t(point(10e-6, 10e-6, 10e-6), Zero, Zero, "wholeClump", false);
    const sceneEffects& active = t.cloud().effects();
    const timeBreakdown& timing = t.cloud().timing();
    t.cloud().evolve();
    t.cloud().accept();
    t.cloud().moveParcels();

    CHECK(!active.active("contact"));
    CHECK(!active.active("gravity"));
    CHECK(!active.active("walls"));
    CHECK(timing.calls("contact") == 0);
    CHECK(timing.calls("walls") == 0);

    t.add(point(10e-6, 10e-6, 13e-6));
    t.cloud().evolve();
    t.cloud().accept();
    t.cloud().moveParcels();
    t.cloud().evolve();
    t.cloud().accept();
    t.cloud().moveParcels();
    CHECK(active.active("contact"));
}


TEST_CASE("cloud: an iteration sees the clumps where the step began", "[cloud][contact]")
{
    // Two that overlap, one across a periodic boundary
    testCloud t(point(19.5e-6, 10e-6, 10e-6));
    t.add(point(3e-6, 10.7e-6, 10.4e-6), vector(-1e-3, 0, 0));

    const fvMesh& mesh = testMesh();
    const volVectorField U
    (
        IOobject("U", testTime().timeName(), mesh),
        mesh, dimensionedVector(dimVelocity, Zero)
    );
    const volScalarField p
    (
        IOobject("p", testTime().timeName(), mesh),
        mesh, dimensionedScalar(sqr(dimVelocity), Zero)
    );
    const volScalarField nu(uniformViscosity(mesh));

    // A step decides that there is contact
    t.immerse();
    t.cloud().evolve(U, p, nu);
    t.cloud().accept();
    t.immerse();

    const List<clumpImage> before(t.cloud().ghosts().images());
    const scalarField S(t.boundary().strength().primitiveField());
    t.cloud().predict(U, p, nu);
    t.cloud().imposeEnd();
    const List<clumpImage> after(t.cloud().ghosts().images());

    REQUIRE(before.size() == after.size());
    forAll(before, a)
    {
        CHECK(before[a].id == after[a].id);
        CHECK(max(mag(before[a].x - after[a].x)) == 0);
    }
    CHECK(gMax(mag(t.boundary().strength().primitiveField() - S)) == 0);

    // What is imposed has no net dilation
    const scalarField Q(mesh.V()*t.boundary().dilation().primitiveField());
    CHECK(mag(gSum(Q)) < 1e-12*gSum(mag(Q)));
}


TEST_CASE("cloud: every mesh cell moves with the nearest clump", "[cloud]")
{
    const List<point> centres
    ({
        point(2.3e-6, 9.1e-6, 3.7e-6), point(16.9e-6, 10.3e-6, 5.2e-6),
        point(9.7e-6, 11.4e-6, 16.8e-6)
    });
    const List<vector> u
    ({
        vector(1e-3, 0, 0), vector(0, 2e-3, 0), vector(0, 0, 3e-3)
    });
    testCloud t(centres[0], u[0], Zero, "wholeClump", false);
    t.add(centres[1], u[1]);
    t.add(centres[2], u[2]);

    const tmp<volVectorField> found(clumpDisplacement(t.cloud()));
    const scalar half = 0.5*testTime().deltaTValue();
    scalar worst = 0;
    const vectorField& x = testMesh().cellCentres();
    forAll(x, celli)
    {
        scalar least = GREAT;
        vector expected(Zero);
        forAll(centres, k)
        {
            for (const scalar i : {-1.0, 0.0, 1.0})
            {
                for (const scalar j : {-1.0, 0.0, 1.0})
                {
                    const point c(centres[k] + 20e-6*vector(i, 0, j));
                    if (mag(c - x[celli]) < least)
                    {
                        least = mag(c - x[celli]);
                        expected = half*u[k];
                    }
                }
            }
        }
        worst = max(worst, mag(found()[celli] - expected));
    }
    CHECK(returnReduce(worst, maxOp<scalar>()) < 1e-9*half*1e-3);
}
