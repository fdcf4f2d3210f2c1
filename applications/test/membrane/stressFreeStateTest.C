/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testMembrane.H"
#include "mathematicalConstants.H"
#include "membraneEquilibrium.H"
#include "membraneTensions.H"
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
        "stressFree { type spheroid; reducedVolume 0.65; }",
        "stressFree { type spheroid; reducedVolume 0.95; keep volume; }",
        "stressFree { type scaled; factor 0.8; }"
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
    CHECK_THROWS(membraneShape("stressFree { type sphere; keep mass; }"));
    CHECK_THROWS(membraneShape("stressFree { type scaled; }"));
    CHECK_THROWS(membraneShape("stressFree { type scaled; factor 0; }"));
    CHECK_THROWS(membraneShape("stressFree { type surface; }"));
    CHECK_THROWS(membraneShape("stressFree { type surface; file \"constant/none.obj\"; }"));
}


TEST_CASE("state without stress: the pressure in an inflated capsule", "[membrane][serial]")
{
    // 2 T/R with the isotropic tension T of the law at the stretch l
    const scalar l = GENERATE(1.05, 1.25);
    const scalar s = sqr(l);
    const struct { string law; scalar T; } laws[] =
    {
        {"type neoHookean; shearModulus 2;", 2*(1 - 1/pow3(s))},
        {"type skalak; shearModulus 2; areaRatio 3;", 2*(s - 1 + 3*s*(sqr(s) - 1))},
        {"type hookeSheet; shearModulus 2; poissonRatio 0.3;", 2*1.3/0.7*(s - 1)},
        {"type triangleArea; areaModulus 2;", 2*(s - 1)}
    };
    for (const auto& of : laws)
    {
        INFO(of.law << " at " << l);
        scalar last = 0;
        for (const label n : {2, 3})
        {
            const testMembrane m
            (
                "a { " + of.law + " }"
                "b { type neoHookean; shearModulus 1e-4; }"
                "stressFree { type scaled; factor " + Foam::name(1/l) + "; }",
                "type icosphere; radius 3; subdivisions " + Foam::name(n) + ";"
            );
            const membraneTensions state(m.mechanics, m.type.centres());
            for (const Pair<scalar>& T : state.tensions())
            {
                REQUIRE(T.first() == Approx(of.T).epsilon(2e-4));
                REQUIRE(T.second() == Approx(of.T).epsilon(2e-4));
            }
            for (const Pair<scalar>& stretch : state.stretches())
            {
                REQUIRE(stretch.second() == Approx(l).epsilon(1e-6));
            }

            pointField x(m.type.centres());
            const membraneEquilibrium solver(m.type, m.dict);
            REQUIRE(solver.find(vectorField(x.size(), Zero), x));
            const vectorField S(m.type.surface().areaVectors(x));
            const scalar p = -sum(m.mechanics.forces(x) & S)/sum(S & S);
            const scalar error = p/(2*of.T/3) - 1;
            CHECK(mag(error) < 0.04/pow(4.0, n - 2));
            if (last)
            {
                CHECK(error/last < 0.35);
            }
            last = error;
        }
    }
}


TEST_CASE("state without stress: an inflated capsule is stiffer, as in linear theory",
    "[membrane][serial]")
{
    // A sphere of neo-Hookean membrane under small radial tractions f P2 becomes
    // r = 1 + f/(2 S) P2 with S = 2 T + 4 G K/(3 K + 2 G). At the stretch l it has the tension
    // T = Gs (1 - l^-6), and the energy of a further strain is that of the moduli
    // G = Gs and K = 3 Gs l^-6
    for (const scalar l : {1.05, 1.2})
    {
        const testMembrane m
        (
            "a { type neoHookean; shearModulus 1; }"
            "stressFree { type scaled; factor " + Foam::name(1/l) + "; }",
            "type icosphere; radius 1; subdivisions 3;"
        );
        const scalar K = 3*Foam::pow(l, -6);
        const scalar S = 2*(1 - K/3) + 4*K/(3*K + 2);
        pointField x(m.type.centres());
        vectorField f(m.type.surface().areaVectors(x));
        const scalar w = 0.01;
        forAll(f, i)
        {
            // The constant leaves the shape, but keeps the sphere from turning under forces
            // that do not turn with it
            f[i] *= 2*S*w*(1.5*sqr(x[i].z())/magSqr(x[i]) - 0.5 + 0.3);
        }
        const membraneEquilibrium solver(m.type, m.dict);
        REQUIRE(solver.find(f, x));
        const symmTensor M(m.type.surface().secondMoments(x));
        CHECK((M.zz() - 0.5*(M.xx() + M.yy()))/tr(M) == Approx(w).epsilon(0.025));
    }
}


TEST_CASE("state without stress: a surface, and a sphere for any shape", "[membrane][serial]")
{
    const membraneShape given("stressFree { type scaled; factor 0.8; }");
    const closedSurface& surface = given.type.surface();
    const auto stressFree = [](const fileName& file, const string& of)
    {
        return
            "stressFree { type surface; file \"" + file + "\"; " + of + " }";
    };
    const auto removed = [](const fileName& file)
    {
        rm(getEnv("FOAM_CASE")/file);
    };

    const fileName same
    (
        writtenSurface("same", 0.4*given.type.centres(), surface.triangles())
    );
    const membraneShape read(stressFree(same, "scale 2;"));
    CHECK
    (
        max(mag(read.mechanics.stressFree() - given.mechanics.stressFree())) < 1e-12
    );

    // A type of another size
    dictionary larger(read.dict);
    larger.set("scale", 3.0);
    const clumpType largerType("larger", larger);
    CHECK
    (
        max
        (
            mag
            (
                stressFreeState(largerType, larger).positions()
              - 3*given.mechanics.stressFree()
            )
        ) < 1e-12
    );
    CHECK_THROWS
    (
        membraneShape
        (
            stressFree(same, ""), "type icosphere; radius 1; subdivisions 2;"
        )
    );
    removed(same);

    // A spheroid from a file: radially onto a sphere
    const scalar k = 1.5;
    const pointField prolate
    (
        cmptMultiply(vector(1, 1, k), given.type.centres()/mag(given.type.centres()))
    );
    const fileName file(writtenSurface("prolate", prolate, surface.triangles()));
    for (const word kept : {"area", "volume"})
    {
        const membraneShape sphere
        (
            "stressFree { type sphere; keep " + kept + "; }",
            "type surfaceFile; file \"" + file + "\";"
        );
        const pointField& x0 = sphere.mechanics.stressFree();
        const pointField& x = sphere.type.centres();
        CHECK(max(mag(x0))/min(mag(x0)) == Approx(1));
        const bool area = kept == "area";
        const closedSurface& own = sphere.type.surface();
        const scalar value = area ? own.area(x0) : own.volume(x0);
        CHECK(value == Approx(area ? own.area(x) : own.volume(x)));
        CHECK(max(mag(x0/mag(x0) - x/mag(x))) < 0.01);
    }
    removed(file);

    // Bent so far that its nodes have no place on a sphere
    pointField banana(prolate);
    for (point& p : banana)
    {
        p.x() += 2*sqr(p.z());
    }
    const fileName bent(writtenSurface("banana", banana, surface.triangles()));
    CHECK_THROWS
    (
        membraneShape
        (
            "stressFree { type sphere; }", "type surfaceFile; file \"" + bent + "\";"
        )
    );
    removed(bent);
}


TEST_CASE("membraneTensions: a part of the surface under compression", "[membrane][serial]")
{
    const membraneShape loose("stressFree { type scaled; factor 1.1; }");
    const membraneTensions all(loose.mechanics, loose.type.centres());
    CHECK(all.partBelow(0) == Approx(1));
    const membraneShape tight("stressFree { type scaled; factor 0.9; }");
    const membraneTensions none(tight.mechanics, tight.type.centres());
    CHECK(none.partBelow(0) == 0);

    // The springs of a network, and the tension of the whole, too: forces follow from the
    // tensions, and the virial is that of the forces
    for
    (
        const string model :
        {
            "a { type springNetwork; shearModulus 2; }",
            "a { type surfaceArea; areaModulus 5; }",
            "a { type surfaceTension; tension 2; }",
            "a { type skalak; shearModulus 2; areaRatio 3; }",
            "a { type surfaceViscosity; viscosity 2; } b { type surfaceTension; tension 2; }"
        }
    )
    {
        INFO(model);
        const testMembrane m(model);
        Random random(5);
        const pointField x(1.1*deformed(m.type, 0.1, random));
        symmTensorField T(m.type.surface().triangles().size(), Zero);
        m.mechanics.addTensions(x, T);
        tensor sum(Zero);
        const vectorField f(m.mechanics.forces(x));
        forAll(x, i)
        {
            sum += x[i]*f[i];
        }
        forAll(T, n)
        {
            const triFace& t = m.type.surface().triangles()[n];
            sum += t.mag(x)*tensor(T[n]);
            CHECK(mag(T[n] & t.unitNormal(x)) < 1e-12);
        }
        CHECK(mag(sum) < 1e-10);
    }
}
