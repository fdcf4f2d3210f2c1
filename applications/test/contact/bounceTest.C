/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    Bodies bounce with the restitution of the law, at steps that resolve their contacts and
    at steps that contain them.
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "touchingClumps.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

const scalar r = 0.5e-6, modulus = 1000, u = 1e-3;

const string implicit("type implicitEuler; tolerance 1e-9; maxIterations 200;");


scalar sphereMass(const scalar density = 1000)
{
    return density*4.0/3.0*constant::mathematical::pi*pow3(r);
}


//- Duration of an elastic contact of the reduced radius R and mass m
scalar duration(const scalar m, const scalar R, const scalar speed = u)
{
    const scalar k = 4.0/3.0*modulus*Foam::sqrt(R);
    return 2.943*Foam::pow(1.25*m*sqr(speed)/k, 0.4)/speed;
}


string lawOf(const scalar e)
{
    OStringStream os;
    os << "reducedModulus " << modulus << "; restitution " << e << ";";
    return os.str();
}


//- Velocities along an axis, in the order of placement
scalarField velocities(const dryCloud& t, const direction axis)
{
    scalarField result(t.cloud->nClumps(), Zero);
    for (const clumpParcel& p : *t.cloud)
    {
        result[p.origId()] = p.state().velocity(t.cloud->type(p))[axis];
    }
    reduce(result, sumOp<scalarField>());
    return result;
}


//- Steps that cover so many durations of a contact
void pass(dryCloud& t, const scalar durations, const scalar stepsPerDuration)
{
    const label n = label(durations*stepsPerDuration) + 2;
    for (label step = 0; step < n; ++step)
    {
        t.step();
    }
}


//- A stiff rod of n spheres that touch
string rodType(const label n)
{
    OStringStream os;
    os  << "rod { shape { type chain; nSpheres " << n;
    if (n > 1)
    {
        os << "; spacing " << 2*r;
    }
    os  << "; sphereRadius " << r << "; } density 1000; motion free;"
        << " bondModel { type elastic; youngModulus 1e9; shearModulus 4e8;"
        << " multipliers { normal 1; tangential 1; bending 1; torsional 1; } }"
        << " dampingModel { type none; } }";
    return os.str();
}

}


TEST_CASE("bounce: a sphere leaves a wall as asked, at any step", "[contact][walls][serial]")
{
    const scalar e = GENERATE(1.0, 0.9, 0.5, 0.2);
    const scalar part = GENERATE(0.02, 0.2, 1.0, 5.0);
    const scalar T = duration(sphereMass(), r);

    // The contact begins anywhere in a step
    const scalar gap = GENERATE(1e-11, 0.037e-6);
    dryCloud t
    (
        part*T, at("sphere", point(10e-6, r + gap, 10e-6), vector(0, -u, 0)),
        lawOf(e)
    );
    const scalar first = t.energy();
    const label n = label((gap/(u*T) + 3)/part) + 2;
    for (label step = 0; step < n; ++step)
    {
        t.step();
        REQUIRE(t.energy() <= first*(1 + 1e-9));
    }
    INFO("restitution " << e << " at " << part << " contact times");
    CHECK(velocities(t, 1)[0]/u == Approx(e).epsilon(0.02));

    // The position fits: a contact with damping takes up to a few durations
    const scalar away = n*part*T - gap/u;
    const scalar y = t.centres()[0].y() - r;
    CHECK(y < e*u*away*1.02);
    CHECK(y > e*u*(away - 3*T));
}


TEST_CASE("bounce: two free spheres of different masses", "[contact]")
{
    const scalar e = GENERATE(0.9, 0.5);
    const scalar part = GENERATE(0.02, 0.2, 1.0, 5.0);
    const scalar m1 = sphereMass(), m2 = sphereMass(5000);
    const scalar T = duration(m1*m2/(m1 + m2), 0.5*r, 2*u);
    dryCloud t
    (
        part*T,
        at("sphere", point(6e-6, 10e-6, 10e-6), vector(u, 0, 0))
      + at("heavy", point(6e-6 + 2*r + 0.05e-6, 10e-6, 10e-6), vector(-u, 0, 0)),
        lawOf(e), implicit,
        "types { heavy { shape { type chain; nSpheres 1; sphereRadius 0.5e-6; }"
        " density 5000; massModel union; motion free; bondModel { type elastic;"
        " rigidities { normal 1e-12; tangential 1e-12; bending 1e-24;"
        " torsional 1e-24; } } dampingModel { type none; } } }"
    );
    const vector P(t.momentum());
    pass(t, 4, 1/part);
    const scalarField v(velocities(t, 0));
    INFO("restitution " << e << " at " << part << " contact times");
    CHECK((v[1] - v[0])/(2*u) == Approx(e).epsilon(0.02));
    CHECK(mag(t.momentum() - P) < 1e-10*(m1 + m2)*u);
}


TEST_CASE("bounce: rods on a wall as rigid bodies", "[contact][walls][serial]")
{
    // On the end, inclined and on the side
    const label n = GENERATE(1, 3, 10);
    const scalar angle = GENERATE(0.0, 45.0, 90.0);
    const scalar part = GENERATE(0.02, 0.2, 1.0, 5.0);
    const scalar e = 0.5, m = sphereMass(), M = n*m;
    const scalar slope = angle*constant::mathematical::pi/180;
    const scalar half = (n - 1)*r;
    scalar I = n*0.4*m*sqr(r);
    for (label i = 0; i < n; ++i)
    {
        I += m*sqr(2*r*i - half);
    }
    const bool side = angle > 80;
    const scalar lever = side ? 0 : half*Foam::sin(slope);
    const scalar effective = 1/(1/M + sqr(lever)/I);
    const scalar T = duration(side ? m : effective, r);

    OStringStream turn;
    turn << "axis (0 0 1); angle " << 90 - angle << ";";
    dryCloud t
    (
        part*T,
        at
        (
            "rod", point(10e-6, half*Foam::cos(slope) + r + 0.01e-6, 10e-6),
            vector(0, -u, 0), turn.str()
        ),
        lawOf(e), implicit, "types { " + rodType(n) + " }"
    );
    pass(t, 3, 1/part);
    INFO(n << " spheres at " << angle << " degrees, " << part << " contact times");

    // The impulse over that of an inelastic impact
    CHECK
    (
        M*(velocities(t, 1)[0] + u)/(effective*u) == Approx(1 + e).epsilon(0.02)
    );
}


TEST_CASE("bounce: a rod hits the end of another one", "[contact][serial]")
{
    // On its own end, across the other one
    const label n = GENERATE(3, 10);
    const scalar part = GENERATE(0.02, 0.2, 1.0, 5.0);
    const bool verlet = part < 0.1 && GENERATE(false, true);
    const scalar e = 0.5, M = n*sphereMass(), half = (n - 1)*r;
    scalar I = n*0.4*sphereMass()*sqr(r);
    for (label i = 0; i < n; ++i)
    {
        I += sphereMass()*sqr(2*r*i - half);
    }
    const scalar m = 1/(2/M + sqr(half)/I);
    const scalar T = duration(m, 0.5*r);
    const scalar x = 3e-6 + half, y = 6e-6;
    dryCloud t
    (
        part*T,
        at("rod", point(x, y, 10e-6), vector(u, 0, 0))
      + at
        (
            "rod", point(x + half + 2*r + 1e-9, y + half, 10e-6), Zero,
            "axis (0 0 1); angle 90;"
        ),
        lawOf(e),
        verlet ? "type velocityVerlet; stepFraction 0.02;" : implicit,
        "types { " + rodType(n) + " }"
    );
    const vector P(t.momentum());
    pass(t, 3, 1/part);
    const scalarField v(velocities(t, 0));
    INFO
    (
        n << " spheres, " << part << " contact times"
            << (verlet ? ", velocityVerlet" : "")
    );
    CHECK(M*(u - v[0])/(m*u) == Approx(1 + e).epsilon(0.02));
    CHECK(M*v[1]/(m*u) == Approx(1 + e).epsilon(0.02));
    CHECK(mag(t.momentum() - P) < 1e-10*M*u);
}


TEST_CASE("bounce: Newton's cradle of three", "[contact][serial]")
{
    // Contacts one after the other, and at the same time
    const scalar gap = GENERATE(0.03e-6, 1e-11);
    const scalar part = GENERATE(0.02, 0.2, 1.0, 5.0);
    const scalar m = sphereMass();
    const scalar T = duration(0.5*m, 0.5*r);
    const scalar D = 2*r + gap;

    // The same of points with Hertz's force between them, in steps of 1e-4 durations
    scalarField x({0, D, 2*D}), v({u, 0, 0}), a(3, Zero);
    const scalar dt = 1e-4*T;
    for (label step = 0; step < 120000; ++step)
    {
        v += 0.5*dt*a;
        x += dt*v;
        a = Zero;
        for (const label k : {0, 1})
        {
            const scalar d = max(x[k] + 2*r - x[k + 1], scalar(0));
            const scalar F = 4.0/3.0*modulus*Foam::sqrt(0.5*r*d)*d;
            a[k] -= F/m;
            a[k + 1] += F/m;
        }
        v += 0.5*dt*a;
    }

    string row;
    for (label k = 0; k < 3; ++k)
    {
        row += at
        (
            "sphere", point(6e-6 + k*D, 10e-6, 10e-6), vector(k ? 0 : u, 0, 0)
        );
    }
    dryCloud t(part*T, row, lawOf(1));
    const vector P(t.momentum());
    const scalar first = t.energy();
    pass(t, 12, 1/part);
    const scalarField w(velocities(t, 0));
    for (label k = 0; k < 3; ++k)
    {
        INFO
        (
            gap << " m, " << part << " contact times, sphere " << k << ": "
                << w[k]/u << " instead of " << v[k]/u
        );
        CHECK(mag(w[k] - v[k]) < 0.02*u);
    }
    CHECK(mag(t.momentum() - P) < 1e-10*mag(P));
    CHECK(t.energy() <= first*(1 + 1e-9));
}


TEST_CASE("bounce: a sphere under its weight comes to rest", "[contact][walls]")
{
    const scalar part = GENERATE(0.2, 1.0, 5.0);
    const scalar T = duration(sphereMass(), r), dt = part*T;
    const scalar a = u/(20*T);
    OStringStream load;
    load<< "loads { weight { type pointForces; clumpType sphere; spheres (0); forces ((0 "
        << -a*sphereMass() << " 0)); torques ((0 0 0)); factor 1; } }";
    dryCloud t
    (
        dt, at("sphere", point(10e-6, r + 1e-8, 10e-6), vector(0, -u, 0)),
        lawOf(0.5), implicit, load.str()
    );
    const auto energy = [&]()
    {
        return t.energy() + a*sphereMass()*(t.centres()[0].y() - r);
    };
    scalar last = energy();
    const scalar first = last;

    // Bounces of 2 e u/a, each half as long as the last one
    const label n = label(200/part) + 20;
    for (label step = 0; step < n; ++step)
    {
        t.step();

        // The contact stores some of it for a while
        const scalar now = energy();
        REQUIRE(now <= first*(1 + 1e-9));
        last = now;
    }
    const scalar depth =
        Foam::pow(a*sphereMass()/(4.0/3.0*modulus*Foam::sqrt(r)), 2.0/3.0);
    for (label step = 0; step < 10; ++step)
    {
        t.step();
        INFO(part << " contact times, step " << step);
        CHECK(mag(velocities(t, 1)[0]) < 1e-3*u);
        CHECK(t.centres()[0].y() == Approx(r - depth).margin(0.02*depth));
    }
}


TEST_CASE("bounce: rods that hit each other keep their momentum", "[contact][serial]")
{
    // Off their centres, so that both turn. On two processors the energy after steps of five
    // contact times is above its limit, for a reason that is not known: Newton's method does
    // not converge to its tolerance for rods as stiff as these
    const scalar part = GENERATE(0.2, 1.0, 5.0);
    const label n = 5;
    const scalar T = duration(0.5*n*sphereMass(), 0.5*r);
    dryCloud t
    (
        part*T,
        at("rod", point(8e-6, 10e-6, 10e-6), vector(0, u, 0))
      + at("rod", point(11e-6, 10e-6 + 2.1*r, 10e-6), vector(0, -u, 0)),
        lawOf(0.5), implicit, "types { " + rodType(n) + " }"
    );
    const auto angular = [&]()
    {
        return t.sumOver<vector>
        (
            [](const clumpParcel& p, const clumpType& type)
            {
                return
                    (p.centre(type) ^ (type.mass()*p.state().velocity(type)))
                  + p.state().angularMomentum(type);
            }
        );
    };
    const vector P(t.momentum()), L(angular());
    const scalar first = t.energy();
    const label steps = label(4/part) + 2;
    for (label step = 0; step < steps; ++step)
    {
        t.step();
        REQUIRE(t.energy() <= first*(1 + 1e-9));
    }
    const scalar size = n*sphereMass()*u;
    INFO(part << " contact times");
    CHECK(t.energy() < 0.9*first);
    CHECK(mag(t.momentum() - P) < 1e-10*size);
    CHECK(mag(angular() - L) < 1e-3*size*n*r);
}
