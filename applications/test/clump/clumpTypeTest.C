/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "sphereUnion.H"
#include "ring.H"
#include "mathematicalConstants.H"

using namespace Foam;
using constant::mathematical::pi;

namespace
{

scalar volumeOf(const std::initializer_list<point>& x, const std::initializer_list<scalar>& r)
{
    return sphereUnion::volume(List<point>(x), List<scalar>(r));
}

}


TEST_CASE("union: one sphere, two apart, one inside another", "[union][serial]")
{
    const scalar r = 2e-6;
    const scalar ball = 4.0/3.0*pi*pow3(r);

    CHECK(volumeOf({point(1, 2, 3)*r}, {r}) == Approx(ball).epsilon(1e-4));
    CHECK
    (
        volumeOf({point::zero, 3*r*vector::one}, {r, r})
     == Approx(2*ball).epsilon(1e-3)
    );
    CHECK
    (
        volumeOf({point::zero, 0.1*r*vector::one}, {r, 0.5*r})
     == Approx(ball).epsilon(1e-4)
    );
}


TEST_CASE("union: two overlapping spheres, the lens", "[union][serial]")
{
    // Two equal spheres at distance d share pi (4 r + d)(2 r - d)^2/12
    const scalar r = 1e-6, d = 0.7e-6;
    const scalar exact =
        8.0/3.0*pi*pow3(r) - pi*(4*r + d)*sqr(2*r - d)/12;

    CHECK
    (
        volumeOf({point::zero, point(0, d, 0)}, {r, r})
     == Approx(exact).epsilon(1e-4)
    );
}


TEST_CASE("union: the ring against Monte Carlo", "[union][serial]")
{
    const clumpType type("cell", cellDict());
    const scalar reach = type.reach();
    Random random(5);

    label inside = 0;
    const label n = 400000;
    for (label i = 0; i < n; ++i)
    {
        const point p(reach*randomVector(random));
        inside += sphereUnion::distance(p, type.centres(), type.radii()) < 0;
    }

    const scalar fraction = scalar(inside)/n;
    const scalar estimate = fraction*pow3(2*reach);
    const scalar deviation =
        pow3(2*reach)*Foam::sqrt(fraction*(1 - fraction)/n);

    CHECK(mag(type.volume() - estimate) < 4*deviation);

    // Of the released red blood cell, 140.6 um3
    CHECK(1e18*type.volume() == Approx(140.6).epsilon(1e-3));
}


TEST_CASE("type: masses, buoyancy, bonds of the red blood cell", "[type][serial]")
{
    const bondedClump clump("cell", cellDict());
    const clumpType& type = clump.type;

    CHECK(type.mass() == Approx(1098*type.volume()).epsilon(1e-12));
    CHECK(sum(type.volumes()) == Approx(type.volume()).epsilon(1e-12));
    CHECK(clump.bonds.bonds().size() == 10);
    CHECK(type.reach() == Approx(3.91e-6).epsilon(1e-12));
    CHECK(mag(sum(type.masses()*type.centres())) < 1e-12*type.mass()*type.reach());

    // l_b = 2 R sin(pi/N); K_n = E_b A_b/l_b with E_b A_b = 70 pN
    const clumpBonds::bond& b = clump.bonds.bonds()[3];
    CHECK(1e6*b.length == Approx(1.2082).epsilon(1e-4));
    CHECK(b.stiffness.normal*b.length == Approx(70e-12).epsilon(1e-3));

    // Eq. 10: c = 2 beta sqrt(m K)
    CHECK
    (
        b.damping.normal
     == Approx(2*1500*Foam::sqrt(type.masses()[0]*b.stiffness.normal))
    );
    CHECK
    (
        b.damping.bending
     == Approx(2*1500*Foam::sqrt(type.inertias()[0]*b.stiffness.bending))
    );
}


TEST_CASE("type: the weight is that of the nominal volume", "[type][serial]")
{
    dictionary dict(cellDict());
    dict.set("nominalVolume", 94e-18);
    const clumpType type("cell", dict);
    CHECK
    (
        sum(type.excessMasses(1025, type.centres()))
     == Approx((1098 - 1025)*94e-18).epsilon(1e-9)
    );

    // Without an entry that of the union; in a vacuum the mass
    const clumpType plain("cell", cellDict());
    CHECK
    (
        sum(plain.excessMasses(0, plain.centres()))
     == Approx(plain.mass()).epsilon(1e-12)
    );
}


TEST_CASE("type: full spheres weigh more than their union", "[type][serial]")
{
    dictionary dict(cellDict());
    dict.set("massModel", word("fullSpheres"));
    const clumpType type("cell", dict);

    CHECK
    (
        type.mass()
     == Approx(10*1098*4.0/3.0*pi*pow3(1.955e-6)).epsilon(1e-12)
    );
    CHECK(type.mass() > 2*1098*type.volume());
}


TEST_CASE("type: spheres too small for a union", "[type][serial]")
{
    dictionary dict(cellDict());
    dict.set("massModel", word("fullSpheres"));
    dict.set
    (
        "shape",
        dictOf("type ring; nSpheres 10; ringRadius 1; sphereRadius 1e-6;")
    );
    const clumpType type("cell", dict);
    CHECK(type.mass() > 0);
    CHECK(type.nominalVolume() == type.volume());
}


TEST_CASE("type: errors name what is wrong", "[type][serial]")
{
    dictionary dict(cellDict());

    SECTION("misspelt shape")
    {
        dict.subDict("shape").set("type", word("rign"));
    }
    SECTION("negative radius")
    {
        dict.subDict("shape").set("sphereRadius", -1e-6);
    }
    SECTION("missing density")
    {
        dict.remove("density");
    }
    SECTION("misspelt bond model")
    {
        dict.subDict("bondModel").set("type", word("elastik"));
    }
    SECTION("bond between spheres that do not exist")
    {
        dict.set
        (
            "shape",
            dictOf
            (
                "type fromFile; centres ((0 0 0) (1e-6 0 0));"
                "radii (1e-6 1e-6); bonds ((0 2));"
            )
        );
    }
    CHECK_THROWS(bondedClump("cell", dict));
}


TEST_CASE("shapes: ring, chain, disc, shell", "[type][serial]")
{
    const auto shapeOf = [](const string& text)
    {
        return clumpShapes::shape::New(dictOf(text));
    };

    CHECK(shapeOf("type chain; nSpheres 1; sphereRadius 1;")->bonds().empty());
    CHECK
    (
        shapeOf("type chain; nSpheres 5; spacing 2; sphereRadius 1;")
            ->bonds().size() == 4
    );
    CHECK
    (
        shapeOf
        (
            "type disc; nSpheres 10; ringRadius 2.6; sphereRadius 1.3;"
            "centreRadius 1;"
        )->bonds().size() == 20
    );

    // Euler: an icosahedron has 30 edges, subdivided once 120
    CHECK
    (
        shapeOf("type shell; nSpheres 12; shellRadius 1; sphereRadius 0.5;")
            ->bonds().size() == 30
    );
    CHECK
    (
        shapeOf("type shell; nSpheres 42; shellRadius 1; sphereRadius 0.5;")
            ->bonds().size() == 120
    );
}


TEST_CASE("ring: the volume of its union", "[ring][type][serial]")
{
    // Apart, overlapping, through the axis, and nearly one sphere
    for (const label n : {3, 8, 10, 16})
    {
        for (const scalar r : {0.15, 0.8, 1.0, 1.001, 2.5, 50.0})
        {
            pointField centres(n);
            forAll(centres, i)
            {
                const scalar angle = 2*pi*i/n;
                centres[i] = point(Foam::cos(angle), Foam::sin(angle), 0);
            }
            CHECK
            (
                clumpShapes::ring::volume(n, 1, r)
             == Approx(sphereUnion::volume(centres, scalarField(n, r)))
                .epsilon(5e-4)
            );
        }
    }

    // Through r = R without a step
    CHECK
    (
        clumpShapes::ring::volume(10, 1, 1 + 1e-9)
     == Approx(clumpShapes::ring::volume(10, 1, 1)).epsilon(1e-7)
    );
}


TEST_CASE("ring: the volume of its hull", "[ring][type][serial]")
{
    // Slices across the axis: discs of the radius R + sqrt(r^2 - z^2)
    for (const scalar r : {0.1, 0.45, 1.0, 3.0})
    {
        const label n = 20000;
        scalar sum = 0;
        for (label i = 0; i < n; ++i)
        {
            const scalar z = r*(2*(i + 0.5)/n - 1);
            sum += pi*sqr(1 + Foam::sqrt(sqr(r) - sqr(z)))*2*r/n;
        }
        CHECK(clumpShapes::ring::hullVolume(1, r) == Approx(sum).epsilon(1e-5));
    }

    // One radius for every N
    for (const label n : {8, 10, 16})
    {
        const auto shape = clumpShapes::shape::New
        (
            dictOf
            (
                "type ring; nSpheres " + Foam::name(n) + ";"
                "diameter 7.6e-6; hullVolume 94e-18;"
            )
        );
        const scalar r = shape->radii()[0];
        const scalar R = shape->centres()[0].x();
        CHECK(R + r == Approx(3.8e-6).epsilon(1e-12));
        CHECK
        (
            clumpShapes::ring::hullVolume(R, r) == Approx(94e-18).epsilon(1e-9)
        );
        CHECK(r == Approx(1.183e-6).epsilon(1e-3));
    }
}


TEST_CASE("ring: a given volume for any N", "[ring][type][serial]")
{
    const auto ringOf = [](const label n, const string& size)
    {
        dictionary dict(cellDict());
        dict.set
        (
            "shape",
            dictOf("type ring; nSpheres " + Foam::name(n) + "; " + size)
        );
        return clumpType("cell", dict);
    };

    for (const label n : {3, 8, 10, 16, 40})
    {
        const clumpType type(ringOf(n, "diameter 7.82e-6; volume 94e-18;"));
        CHECK(type.volume() == Approx(94e-18).epsilon(1e-3));
        CHECK(type.reach() == Approx(3.91e-6).epsilon(1e-9));
    }

    // Fat rings: the spheres pass the axis
    CHECK
    (
        ringOf(10, "diameter 7.82e-6; volume 200e-18;").volume()
     == Approx(200e-18).epsilon(1e-3)
    );

    const clumpType type(ringOf(10, "ringRadius 2.4e-6; volume 94e-18;"));
    CHECK(type.volume() == Approx(94e-18).epsilon(1e-3));
    CHECK(max(mag(type.centres())) == Approx(2.4e-6).epsilon(1e-9));

    // The radius from the volume of a radius
    const scalar V = clumpShapes::ring::volume(10, 1.955e-6, 1.955e-6);
    CHECK
    (
        ringOf(10, "diameter 7.82e-6; volume " + Foam::name(V) + ";").radii()[0]
     == Approx(1.955e-6).epsilon(1e-5)
    );

    // More than the sphere about it, two sizes, nothing
    CHECK_THROWS(ringOf(10, "diameter 7.82e-6; volume 251e-18;"));
    CHECK_THROWS
    (
        ringOf(10, "diameter 7.82e-6; volume 94e-18; sphereRadius 1e-6;")
    );
    CHECK_THROWS(ringOf(10, "diameter 7.82e-6; hullVolume 251e-18;"));
    CHECK_THROWS
    (
        ringOf(10, "diameter 7.82e-6; volume 94e-18; hullVolume 140e-18;")
    );
    CHECK_THROWS(ringOf(10, "diameter 7.82e-6; volume -94e-18;"));
    CHECK_THROWS(ringOf(10, "diameter 7.82e-6;"));
    CHECK_THROWS
    (
        clumpShapes::shape::New
        (
            dictOf
            (
                "type disc; nSpheres 10; ringRadius 2.6; volume 94;"
                "centreRadius 1;"
            )
        )
    );
}
