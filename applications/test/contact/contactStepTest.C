/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "clumpMotion.H"
#include "touchingClumps.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

const scalar r = 0.5e-6;

}


TEST_CASE("contact step: energy never grows, momentum stays", "[contact]")
{
    // Tilted rings without damping, one across a periodic boundary
    const scalar dt = GENERATE(1e-6, 1e-5, 1e-4, 1e-3, 1e-2);
    // At most a radius per step
    const scalar u = min(1e-3, 2e-6/dt);
    dryCloud t
    (
        dt,
        at
        (
            "cell", point(17e-6, 10e-6, 10e-6), vector(u, 0, 0),
            "axis (1 1 0); angle 40;"
        )
      + at("cell", point(4.6e-6, 10.7e-6, 9.6e-6), vector(-0.3*u, 0, 0))
    );
    const scalar mass = t.cloud->types()[t.cloud->types().size() - 1].mass();
    const scalar first = t.energy();
    const vector P(t.momentum());
    const scalar size = mass*u;

    // Until they reach a wall
    scalar least = first;
    for (label step = 0; step < 40; ++step)
    {
        t.step();
        const scalar now = t.energy();
        least = min(least, now);
        INFO("step " << step << " of " << dt << " s: " << now/first
            << ", momentum " << mag(t.momentum() - P)/size);
        REQUIRE(now <= first*(1 + 1e-9));
        REQUIRE(mag(t.momentum() - P) < 1e-10*size);
    }
    if (dt > 5e-5)
    {
        CHECK(least < 0.9*first);
    }
}


TEST_CASE("contact step: the forces are opposite, without a moment", "[contact]")
{
    // In the middle of the box, so that no part of a clump is an image
    const scalar dt = GENERATE(1e-6, 1e-4, 1e-3, 1e-2);
    const scalar u = min(1e-3, 1e-7/dt);
    dryCloud t
    (
        dt,
        at
        (
            "cell", point(5.2e-6, 10e-6, 10e-6), vector(u, 0, 0),
            "axis (1 1 0); angle 40;"
        )
      + at("cell", point(12e-6, 11.7e-6, 9.1e-6), vector(-u, 0, 0))
    );
    t.cloud->evolve();
    t.cloud->accept();
    vector force(Zero), moment(Zero);
    scalar size = 0;
    for (const clumpParcel& p : *t.cloud)
    {
        const vectorField& f = p.step().forces.f;
        const pointField x(p.centres());
        force += sum(f);
        moment += sum(x ^ f);
        size += sum(mag(f));
    }
    reduce(force, sumOp<vector>());
    reduce(moment, sumOp<vector>());
    reduce(size, sumOp<scalar>());
    CHECK(size > 0);
    CHECK(mag(force) < 1e-13*size);
    if (dt > 5e-4)
    {
        // The forces of a step that contacts divide act at several places
        CHECK(mag(moment) < 1e-13*size*20e-6);
    }
}


TEST_CASE("contact step: nothing passes through anything", "[contact]")
{
    // On one line, at speeds with which the centres would nearly meet in one step.
    // Faster clumps, which would pass, may find their way around each other
    const string type = GENERATE(string("cell"), string("sphere"));
    const string other("sphere");
    const scalar part = GENERATE(0.3, 0.6, 0.9);
    const scalar reach = (type == "cell") + (other == "cell");
    const scalar dt = 1e-4, gap = 0.3e-6;
    const scalar D = reach*(3.91e-6 - r) + 2*r;
    const scalar u = (gap + part*2*r)/dt;
    const string lying("axis (0 0 1); angle 0;");
    dryCloud t
    (
        dt,
        at(other, point(16e-6, 10e-6, 10e-6), Zero, lying)
      + at(type, point(16e-6 - D - gap, 10e-6, 10e-6), vector(u, 0, 0), lying),
        "reducedModulus 1e6; restitution 0.5;"
    );
    const vector P(t.momentum());
    t.cloud->evolve();
    t.cloud->accept();
    const vectorField x(t.centres());
    INFO(type << ' ' << part << ": " << x[0].x() << ' ' << x[1].x());
    CHECK(x[0].x() - x[1].x() > D - 0.2*r);
    CHECK(mag(t.momentum() - P) < 1e-11*mag(P));
}


TEST_CASE("contact step: what slips around is noticed", "[contact]")
{
    // Two spheres that meet head on with three diameters of displacement, off the line
    // by a hair, against a pair that slows down and one that has room to pass
    const scalar dt = 1e-4;
    const auto passing = [&](const scalar way, const scalar aside)
    {
        dryCloud t
        (
            dt,
            at("sphere", point(10e-6, 10e-6, 10e-6), Zero)
          + at
            (
                "sphere", point(8.7e-6, 10e-6 + aside, 10e-6),
                vector(way/dt, 0, 0)
            )
        );
        t.cloud->evolve();
        t.cloud->accept();
        bool any = false;
        for (const bool passes : t.cloud->motion().passing())
        {
            any = any || passes;
        }
        const vectorField x(t.centres());
        INFO(way << ' ' << aside << ": " << x[0].x() << ' ' << x[1].x());
        const bool passed = x[1].x() > x[0].x() && mag(aside) < 0.5*r;
        CHECK(returnReduce(any, orOp<bool>()) == passed);
        return passed;
    };
    CHECK(!passing(0.8e-6, 0.01e-6));
    CHECK(!passing(3e-6, 1.3e-6));
    CHECK(passing(6e-6, 0.01e-6));
}


TEST_CASE("contact step: nothing passes through a wall", "[contact][walls]")
{
    const scalar dt = 1e-3;
    dryCloud t
    (
        dt,
        at("cell", point(10e-6, 8e-6, 10e-6), vector(1e-3, -12e-6/dt, 0))
    );
    for (label step = 0; step < 3; ++step)
    {
        t.step();
        REQUIRE(t.cloud->nClumps() == 1);
        CHECK(t.centres()[0].y() > 1e-6);
    }
}


TEST_CASE("contact step: restitution for small steps", "[contact]")
{
    // Of two spheres and of a sphere and a wall
    const scalar e = GENERATE(1.0, 0.6);
    const bool verlet = GENERATE(false, true);
    const scalar u = 1e-3, dt = verlet ? 5e-8 : 1e-8;
    OStringStream law;
    law << "reducedModulus 1000; restitution " << e << ";";
    dryCloud t
    (
        dt,
        at("sphere", point(5e-6, 10e-6, 10e-6), vector(u, 0, 0))
      + at("sphere", point(5e-6 + 2*r + 1e-11, 10e-6, 10e-6), vector(-u, 0, 0))
      + at("sphere", point(12e-6, r + 1e-11, 10e-6), vector(0, -u, 0)),
        law.str(),
        verlet
      ? "type velocityVerlet; stepFraction 0.02;"
      : "type implicitEuler; tolerance 1e-9; maxIterations 200;"
    );
    for (label step = 0; step < (verlet ? 300 : 1500); ++step)
    {
        t.step();
    }
    for (const clumpParcel& p : *t.cloud)
    {
        INFO(p.origId() << ' ' << verlet);
        CHECK(mag(p.state().u[0])/u == Approx(e).margin(0.02));
    }
}


TEST_CASE("contact step: a sphere slides over the facets of a wall", "[contact][walls]")
{
    // Pressed to the wall, over 40 faces and through the periodic boundary
    const scalar dt = 1e-4, u = 0.4e-6/dt;
    const scalar F = 2e-11;
    OStringStream more;
    more<< "loads { press { type pointForces; clumpType sphere; spheres (0);"
        << " forces ((0 " << -F << " 0)); torques ((0 0 0)); factor 1; } }";
    const scalar d =
        Foam::pow(F/(4.0/3.0*1000*Foam::sqrt(r)), 2.0/3.0);
    dryCloud t
    (
        dt,
        at("sphere", point(5.3e-6, r - d, 9.7e-6), vector(u, 0, 0.3*u)),
        "reducedModulus 1000; restitution 1;",
        "type implicitEuler; tolerance 1e-9; maxIterations 200;",
        more.str()
    );
    for (label step = 0; step < 100; ++step)
    {
        t.step();
        CHECK(t.centres()[0].y() == Approx(r - d).epsilon(1e-6));
        for (const clumpParcel& p : *t.cloud)
        {
            // A resistance below 1e-9 of the normal force
            CHECK
            (
                mag(p.state().u[0] - vector(u, 0, 0.3*u))
              < 1e-9*F*100*dt/t.cloud->type(p).mass()
            );
        }
    }
}


TEST_CASE("contact step: the order of the clumps does not matter", "[contact]")
{
    // A cluster that is hit
    DynamicList<point> places;
    Random random(5);
    for (label k = 0; k < 27; ++k)
    {
        places.append
        (
            point(10e-6, 10e-6, 10e-6)
          + 0.96e-6*vector(k % 3 - 1, (k/3) % 3 - 1, k/9 - 1)
          + 0.05e-6*randomVector(random)
        );
    }
    vectorField ends[2];
    for (const bool reversed : {false, true})
    {
        string clumps;
        for (label k = 0; k < 27; ++k)
        {
            const label c = reversed ? 26 - k : k;
            clumps += at("sphere", places[c], vector(c ? 0 : 1e-2, 0, 0));
        }
        dryCloud t(1e-5, clumps, "reducedModulus 1000; restitution 0.5;");
        for (label step = 0; step < 5; ++step)
        {
            t.step();
        }
        ends[reversed] = t.centres();
    }
    scalar most = 0;
    for (label k = 0; k < 27; ++k)
    {
        most = max(most, mag(ends[0][k] - ends[1][26 - k]));
    }
    CHECK(most < 1e-6*r);
}


TEST_CASE("contact step: a contact costs the clumps that it moves", "[contact]")
{
    // Two of 216 spheres are pressed deep into each other
    string clumps;
    for (label k = 0; k < 216; ++k)
    {
        vector x(3e-6*vector(k % 6 + 0.6, (k/6) % 6 + 0.6, k/36 + 0.6));
        if (k == 1)
        {
            x.x() -= 2.45e-6;
        }
        clumps += at("sphere", x, vector(1e-4, 0, 0));
    }
    dryCloud t(1e-4, clumps);
    t.step();
    t.step();
    const label n = returnReduce(t.cloud->motion().nSolves(), sumOp<label>());
    INFO(n << " solutions in two steps");
    CHECK(n >= 2*216);
    CHECK(n < 2*216 + 80);
}


TEST_CASE("contact step: a column between two walls carries one force", "[contact][walls]")
{
    // Four spheres are together higher than the box. The overlaps with the walls and
    // between spheres differ, since R* differs; the forces do not. Time to settle, but
    // not to buckle, and away from the boundary of a processor, since p.step() stays
    // with the processor that made the step
    const scalar rs = 2.54e-6, E = 1000, H = 20e-6;
    const label n = 4;
    string clumps;
    for (label k = 0; k < n; ++k)
    {
        clumps += at("big", point(9.5e-6, H*(k + 0.5)/n, 9.5e-6));
    }
    dryCloud t
    (
        2e-5, clumps, "reducedModulus 1000; restitution 0.5;",
        "type implicitEuler; tolerance 1e-10; maxIterations 200;",
        "types { big { shape { type chain; nSpheres 1; sphereRadius 2.54e-6; }"
        " density 1000; massModel union; motion free; bondModel { type elastic;"
        " rigidities { normal 1e-12; tangential 1e-12; bending 1e-24;"
        " torsional 1e-24; } } dampingModel { type none; } } }"
    );
    for (label step = 0; step < 40; ++step)
    {
        t.step();
    }
    const vectorField x(t.centres());

    // 2 d_w + (n - 1) d_s = 2 n r - H with d_s = 2^(1/3) d_w
    const scalar dw = (2*n*rs - H)/(2 + (n - 1)*Foam::cbrt(2.0));
    const auto force = [&](const scalar d, const scalar R)
    {
        return 4.0/3.0*E*Foam::sqrt(R)*Foam::pow(max(d, scalar(0)), 1.5);
    };
    const scalar F = force(dw, rs);
    INFO(dw << ": " << rs - x[0].y() << ' ' << 2*rs - mag(x[1] - x[0]) << ' '
        << 2*rs - mag(x[2] - x[1]) << ", aside " << x[1].x() - x[0].x());
    CHECK(force(rs - x[0].y(), rs) == Approx(F).epsilon(1e-5));
    CHECK(force(x[n - 1].y() + rs - H, rs) == Approx(F).epsilon(1e-5));
    for (label k = 0; k + 1 < n; ++k)
    {
        INFO(k);
        CHECK
        (
            force(2*rs - mag(x[k + 1] - x[k]), 0.5*rs)
         == Approx(F).epsilon(1e-5)
        );
    }
    for (const clumpParcel& p : *t.cloud)
    {
        CHECK(mag(p.step().forces.f[0]) < 1e-5*F);
    }
}


TEST_CASE("contact step: a stack of clumps carries its load", "[contact][walls]")
{
    // Rings on the floor, each pushed down by the same force: the overlap under k of
    // them is k^(2/3) times that under one. Time to settle, but not to turn about
    // their axis until the spheres of one lie in the gaps of the next
    const label n = 4;
    const scalar rs = 1.475e-6, W = 4e-12;
    string clumps;
    for (label k = 0; k < n; ++k)
    {
        clumps += at
        (
            "ring", point(10e-6, rs*(1 + 2*k), 10e-6), Zero,
            "axis (1 0 0); angle 90;"
        );
    }
    OStringStream load;
    load<< "loads { press { type pointForces; clumpType ring; factor 1; spheres "
        << identity(10) << "; forces " << vectorField(10, vector(0, -0.1*W, 0))
        << "; torques " << vectorField(10, Zero) << "; } }";
    dryCloud t
    (
        2e-5, clumps, "reducedModulus 1000; restitution 0.5;",
        "type implicitEuler; tolerance 1e-10; maxIterations 200;",
        string(load.str())
      + "types { ring { shape { type ring; nSpheres 10; ringRadius 2.435e-6;"
        " sphereRadius 1.475e-6; } density 1000; massModel union; motion free;"
        " bondModel { type elastic; youngModulus 1e5; shearModulus 1e5;"
        " multipliers { normal 1; tangential 1; bending 1; torsional 1; } }"
        " dampingModel { type none; } } }"
    );
    for (label step = 0; step < 60; ++step)
    {
        t.step();
    }
    const vectorField x(t.centres());
    const scalar top = 2*rs - (x[n - 1].y() - x[n - 2].y());

    // The sum over the pairs is L/(r sqrt(pi/2)) times that of one
    const scalar L = constant::mathematical::twoPi*2.435e-6;
    CHECK
    (
        L/(rs*Foam::sqrt(0.5*constant::mathematical::pi))
       *4.0/3.0*1000*Foam::sqrt(0.5*rs)*Foam::pow(top, 1.5)
     == Approx(W).epsilon(0.05)
    );
    for (label k = 2; k < n; ++k)
    {
        const scalar d = 2*rs - (x[n - k].y() - x[n - k - 1].y());
        INFO(k << ": " << d << ' ' << top);
        CHECK(d == Approx(top*Foam::pow(scalar(k), 2.0/3.0)).epsilon(0.01));
    }
}
