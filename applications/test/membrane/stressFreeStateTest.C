/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testMembrane.H"
#include "mathematicalConstants.H"
#include "stressFreeState.H"

using namespace Foam;

namespace
{

const scalar pi = constant::mathematical::pi;

struct membraneShape
:
    public testMembrane
{
    explicit membraneShape
    (
        const string& stressFree,
        const string& shape = "type biconcave; diameter 2; subdivisions 3;"
    )
    :
        testMembrane
        (
            "strain { type skalak; shearModulus 2; areaRatio 10; }"
            " area { type surfaceArea; areaModulus 5; }" + stressFree,
            shape
        )
    {}

    scalar energy(const pointField& x) const
    {
        vectorField unused(x.size(), Zero);
        return mechanics.add(x, unused);
    }
};

scalar reducedVolume(const closedSurface& s, const pointField& x)
{
    return s.volume(x)/(4*pi/3*Foam::pow(s.area(x)/(4*pi), 1.5));
}

}


TEST_CASE("state without stress: no energy and no force in it", "[membrane][serial]")
{
    const string state = GENERATE
    (
        "",
        "stressFree { type shape; }",
        "stressFree { type sphere; }",
        "stressFree { type spheroid; reducedVolume 0.95; }",
        "stressFree { type spheroid; reducedVolume 0.65; }"
    );
    INFO(state);
    const membraneShape c(state);
    const pointField& x0 = c.mechanics.stressFree();
    const bool isShape = state.empty() || state.find("shape") != string::npos;

    CHECK(mag(c.energy(x0)) < 1e-13);
    CHECK(max(mag(c.mechanics.forces(x0))) < 1e-12);
    if (isShape)
    {
        CHECK(max(mag(x0 - c.type.centres())) == 0);
        return;
    }

    // The shape is strained. The forces there are the gradient of the energy, and add up
    // to nothing
    const pointField& x = c.type.centres();
    CHECK(c.energy(x) > 1e-3);
    const vectorField f(c.mechanics.forces(x));
    Random random(7);
    const scalar h = 1e-6;
    for (label n = 0; n < 20; ++n)
    {
        const label i = random.position<label>(0, x.size() - 1);
        const vector e(randomVector(random));
        pointField plus(x), minus(x);
        plus[i] += h*e;
        minus[i] -= h*e;
        const scalar expected = -(c.energy(plus) - c.energy(minus))/(2*h);
        CHECK((f[i] & e) == Approx(expected).epsilon(1e-5).margin(1e-7));
    }
    vector moment(Zero);
    forAll(x, i)
    {
        moment += x[i] ^ f[i];
    }
    CHECK(mag(sum(f)) < 1e-13*sum(mag(f)));
    CHECK(mag(moment) < 1e-12*sum(mag(f)));
}


TEST_CASE("state without stress: a spheroid of the area of the shape", "[membrane][serial]")
{
    for (const scalar v : {1.0, 0.96, 0.7})
    {
        INFO(v);
        const membraneShape c
        (
            "stressFree { type spheroid; reducedVolume " + Foam::name(v) + "; }"
        );
        const closedSurface& s = c.type.surface();
        const pointField& x0 = c.mechanics.stressFree();
        const pointField& x = c.type.centres();
        CHECK(s.area(x0) == Approx(s.area(x)).epsilon(1e-12));
        CHECK(reducedVolume(s, x0) == Approx(v).epsilon(0.01));

        // On an ellipsoid with the ratio of axes
        const scalar k = stressFreeState::aspectRatio(v);
        scalarField a(x0.size());
        forAll(a, i)
        {
            a[i] = Foam::sqrt
            (
                sqr(x0[i].x()) + sqr(x0[i].y()) + sqr(x0[i].z()/k)
            );
        }
        CHECK(max(a)/min(a) == Approx(1).epsilon(1e-6));

        // No part of the membrane is stretched in its area
        scalar deviation = 0;
        for (const triFace& t : s.triangles())
        {
            deviation += mag(t.mag(x0) - t.mag(x));
        }
        CHECK(deviation < 0.05*s.area(x));
    }
    CHECK(stressFreeState::aspectRatio(1) == Approx(1).epsilon(1e-6));
    const scalar k = stressFreeState::aspectRatio(0.9);
    const scalar e = Foam::sqrt(1 - sqr(k));
    const scalar area = 2*pi*(1 + sqr(k)/e*std::atanh(e));
    CHECK(k/Foam::pow(area/(4*pi), 1.5) == Approx(0.9));
}


TEST_CASE("state without stress: a sphere is its own", "[membrane][serial]")
{
    const membraneShape c
    (
        "stressFree { type sphere; }", "type icosphere; radius 3; subdivisions 3;"
    );
    CHECK
    (
        max(mag(c.mechanics.stressFree() - c.type.centres())) < 0.01*3
    );
}


TEST_CASE("state without stress: what cannot be is refused", "[membrane][serial]")
{
    CHECK_THROWS(membraneShape("stressFree { type disc; }"));
    CHECK_THROWS(membraneShape("stressFree { type spheroid; }"));
    CHECK_THROWS(membraneShape("stressFree { type spheroid; reducedVolume 1.1; }"));
    CHECK_THROWS(membraneShape("stressFree { type sphere; reducedVolume 0.9; }"));
    CHECK_THROWS(membraneShape("stressFree { type sphere; of cells; }"));
}
