/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCloud.H"
#include "mathematicalConstants.H"
#include <cmath>
#include <functional>

using namespace Foam;

namespace
{

using constant::mathematical::pi;

const scalar L = 20e-6;         // length of the box [m]
const scalar radius = 1e-6;     // of the spheres [m]


//- A field of the mesh with the values of a function in cells and on walls
volScalarField fieldOf
(
    const word& name,
    const std::function<scalar(const point&)>& value
)
{
    volScalarField psi
    (
        IOobject(name, testTime().timeName(), testMesh()),
        testMesh(), dimensionedScalar(dimless, Zero)
    );
    forAll(psi, celli)
    {
        psi[celli] = value(testMesh().C()[celli]);
    }
    forAll(psi.boundaryField(), patchi)
    {
        fvPatchScalarField& patch = psi.boundaryFieldRef()[patchi];
        if (!patch.coupled())
        {
            const vectorField& x = patch.patch().Cf();
            forAll(patch, i)
            {
                patch[i] = value(x[i]);
            }
        }
    }
    psi.correctBoundaryConditions();
    return psi;
}


//- Clumps of one sphere or of three, 3 um apart in x, that a load acts on
autoPtr<openCloud> loaded
(
    const string& clumps,
    const string& load,
    const string& fluid = "off"
)
{
    const string bonds =
        "bondModel { type elastic; rigidities { normal 1e-12; tangential 1e-12;"
        " bending 1e-24; torsional 1e-24; } } dampingModel { type none; }";
    const string text =
        "types"
        "{"
        "    bead { shape { type chain; nSpheres 1; sphereRadius 1e-6; }"
        "        density 1000; }"
        "    row { shape { type chain; nSpheres 3; spacing 3e-6;"
        "        sphereRadius 1e-6; } density 1000; " + bonds + " }"
        "}"
        "placement { type list; clumps (" + clumps + "); }"
        "contactModel { type none; } wallContactModel { type none; }"
        "loads { a { " + load + " } } effects { fluid " + fluid + "; }";
    return autoPtr<openCloud>(new openCloud(testMesh(), dictOf(text)));
}


struct loadedSphere
{
    point x;
    vector f;
    vector u;
};


//- The spheres of all processors after a step without a fluid
List<loadedSphere> spheresAfterStep(openCloud& cloud)
{
    List<pointField> x(Pstream::nProcs());
    List<vectorField> f(Pstream::nProcs());
    List<vectorField> u(Pstream::nProcs());
    const label me = Pstream::myProcNo();
    cloud.evolve();
    cloud.accept();
    for (const clumpParcel& p : cloud)
    {
        // Those at the start of the step, a way of less than 1e-9 m earlier
        x[me].append(p.centres());
        f[me].append(p.step().forces.f);
        u[me].append(p.state().u);
    }
    for (auto* lists : {&f, &u})
    {
        Pstream::gatherList(*lists);
        Pstream::scatterList(*lists);
    }
    Pstream::gatherList(x);
    Pstream::scatterList(x);

    List<loadedSphere> result;
    forAll(x, proci)
    {
        forAll(x[proci], i)
        {
            result.append({x[proci][i], f[proci][i], u[proci][i]});
        }
    }
    return result;
}

}


TEST_CASE
(
    "fieldForce: gradients at spheres of other processors and beyond patches",
    "[cloud][fieldLoad]"
)
{
    const volScalarField psi
    (
        fieldOf("psi", [](const point& x) { return sqr(x.y()); })
    );
    const volScalarField wave
    (
        fieldOf("wave", [](const point& x) { return std::sin(2*pi*x.x()/L); })
    );
    // Across the boundary between two processors, both periodic ones, and a corner
    const string rows =
        "{ type row; position (10e-6 5.3e-6 4e-6); }"
        "{ type row; position (0.2e-6 7.1e-6 12e-6); }"
        "{ type row; position (19.9e-6 13.7e-6 0.1e-6); }";
    const scalar volume = 4*pi/3*pow3(radius);

    SECTION("exact in a quadratic field")
    {
        autoPtr<openCloud> cloud
        (
            loaded
            (
                rows,
                "type fieldForce; clumpType row; field psi; coefficient 3e-9;"
            )
        );
        const List<loadedSphere> spheres(spheresAfterStep(*cloud));
        REQUIRE(spheres.size() == 9);
        for (const loadedSphere& s : spheres)
        {
            const vector expected(0, 3e-9*volume*2*s.x.y(), 0);
            // The volume of the union of the spheres has an error of 1e-4 at most
            CHECK(mag(s.f - expected) < 3e-4*mag(expected));
        }
    }
    SECTION("of second order in a wave, per clump")
    {
        autoPtr<openCloud> cloud
        (
            loaded
            (
                rows,
                "type fieldForce; clumpType row; field wave; per clump;"
                " coefficient table ((0 6e-18) (10 6e-18));"
            )
        );
        const scalar k = 2*pi/L;
        const List<loadedSphere> spheres(spheresAfterStep(*cloud));
        REQUIRE(spheres.size() == 9);
        for (const loadedSphere& s : spheres)
        {
            const vector expected(2e-18*k*std::cos(k*s.x.x()), 0, 0);
            // Central differences over two cells of 1 um, then a straight line
            CHECK(mag(s.f - expected) < 0.3*sqr(k*1e-6)*2e-18*k);
        }
    }
}


TEST_CASE("fieldForce: a uniform field has no force", "[cloud][fieldLoad]")
{
    const volScalarField psi(fieldOf("psi", [](const point&) { return 7; }));
    autoPtr<openCloud> cloud
    (
        loaded
        (
            "{ type row; position (0.2e-6 7.1e-6 12e-6); }",
            "type fieldForce; clumpType row; field psi; coefficient 1;"
        )
    );
    // Of the force where the field falls by 7 over a mesh cell
    const scalar scale = 4*pi/3*pow3(radius)*7/1e-6;
    for (const loadedSphere& s : spheresAfterStep(*cloud))
    {
        CHECK(mag(s.f) < 1e-9*scale);
    }
}


TEST_CASE
(
    "fieldForce: a sphere reaches the Stokes velocity of the force",
    "[cloud][fieldLoad]"
)
{
    const volScalarField psi
    (
        fieldOf("psi", [](const point& x) { return 2*x.y() + 5; })
    );
    autoPtr<openCloud> cloud
    (
        loaded
        (
            "{ type bead; position (0.2e-6 7.1e-6 12e-6); velocity (0 0 0); }",
            "type fieldForce; clumpType bead; field psi; coefficient 1000;",
            "frozen"
        )
    );
    const volVectorField U
    (
        IOobject("testU", testTime().timeName(), testMesh()),
        testMesh(), dimensionedVector(dimVelocity, Zero)
    );
    const volScalarField p
    (
        IOobject("testP", testTime().timeName(), testMesh()),
        testMesh(), dimensionedScalar(dimPressure/dimDensity, Zero)
    );
    const volScalarField nu(uniformViscosity(testMesh(), 1e-6));
    for (label step = 0; step < 50; ++step)
    {
        cloud->evolve(U, p, nu);
        cloud->accept();
        cloud->moveParcels();
    }
    // F = 1000 V 2, u = F/(6 pi mu a)
    const scalar mu = 1e-6*cloud->fluidDensity();
    const scalar u = 1000*4*pi/3*pow3(radius)*2/(6*pi*mu*radius);
    label n = 0;
    for (const clumpParcel& parcel : *cloud)
    {
        CHECK(mag(parcel.state().u[0] - vector(0, u, 0)) < 3e-4*u);
        ++n;
    }
    CHECK(returnReduce(n, sumOp<label>()) == 1);
}


TEST_CASE("fieldForce: fields that are not there", "[cloud][fieldLoad]")
{
    const string bead = "{ type bead; position (5e-6 7e-6 12e-6); }";
    const string begin = "type fieldForce; clumpType bead; coefficient 1; ";
    const volScalarField psi(fieldOf("psi", [](const point&) { return 7; }));
    CHECK_NOTHROW(loaded(bead, begin + "field psi;"));
    CHECK_THROWS(loaded(bead, begin + "field notThere;"));
    CHECK_THROWS(loaded(bead, begin + "field psi; per sphere;"));
    CHECK_THROWS(loaded(bead, "type fieldForce; clumpType bead; field psi;"));
}


TEST_CASE("rotatingField: the field turns with the time", "[cloud][fieldLoad]")
{
    const scalar start = testTime().value();
    const label index = testTime().timeIndex();
    autoPtr<openCloud> cloud
    (
        loaded
        (
            "{ type row; position (5e-6 7e-6 12e-6); }",
            "type rotatingField; clumpType row; field (2e-3 0 0); axis (0 0 2);"
            " frequency 10; charge 3e-15;"
        )
    );
    for (const scalar t : {0.0, 0.0125, 0.025, 0.07})
    {
        testTime().setTime(t, index);
        const scalar a = 2*pi*10*t;
        const vector expected(2e-18*vector(std::cos(a), std::sin(a), 0));
        for (const loadedSphere& s : spheresAfterStep(*cloud))
        {
            CHECK(mag(s.f - expected) < 1e-9*mag(expected));
        }
    }
    testTime().setTime(start, index);
}


TEST_CASE("rotatingField: a magnet swings in a field at rest", "[cloud][fieldLoad]")
{
    // The field that gives a half swing in 40 steps, at an amplitude of 0.1
    const label n = 40;
    const scalar inertia = 0.4*1000*4*pi/3*pow3(radius)*sqr(radius);
    const scalar dt = testTime().deltaTValue();
    const scalar torque = inertia*sqr(pi/(n*dt));
    autoPtr<openCloud> cloud
    (
        loaded
        (
            "{ type bead; position (5e-6 7e-6 12e-6); axis (0 0 1);"
            " angle 5.7295779513; }",
            "type rotatingField; clumpType bead; field (1 0 0); moment ("
          + Foam::name(torque) + " 0 0);"
        )
    );
    const auto angle = [&]()
    {
        scalar result = 0;
        for (const clumpParcel& p : *cloud)
        {
            const vector m(p.state().q[0].transform(vector(1, 0, 0)));
            result = std::atan2(m.y(), m.x());
        }
        return returnReduce(result, sumOp<scalar>());
    };
    CHECK(angle() == Approx(0.1));
    for (label step = 0; step < n; ++step)
    {
        cloud->evolve();
        cloud->accept();
        cloud->moveParcels();
        if (step == n/2 - 1)
        {
            // A first order in the length of the step, 1/13 of a radian of the swing
            CHECK(mag(angle()) < 0.01);
        }
    }
    CHECK(angle() == Approx(-0.1).epsilon(0.02));
}
