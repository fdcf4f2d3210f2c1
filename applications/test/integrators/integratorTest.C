/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "implicitEuler.H"
#include "velocityVerlet.H"

using namespace Foam;

namespace
{

autoPtr<integrator> implicitOne()
{
    return selectModel<integrator>
    (
        dictOf("type implicitEuler; tolerance 1e-9; maxIterations 100;")
    );
}

autoPtr<integrator> explicitOne()
{
    return selectModel<integrator>
    (
        dictOf("type velocityVerlet; stepFraction 0.2;")
    );
}

scalar energy(const clumpBonds& bonds, const clumpState& s)
{
    const clumpType& type = bonds.type();
    vectorField F(type.size()), T(type.size());
    return
        s.kineticEnergy(type) + bondForces(bonds, s).stepForces(s, -1, F, T);
}

}


TEST_CASE("integrators: passive motion gains no energy", "[energy][serial]")
{
    const scalar dt = GENERATE(1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3);
    const string damping = GENERATE
    (
        "type none;", "type dampingRatio; beta 1500;",
        "type kelvinVoigt; timeConstant 0.08;",
        "type shearThinning; lowRate { type dampingRatio; beta 1500; }"
        " highRateFraction 0.1; transitionRate 10; exponent 0;"
    );
    const bondedClump clump("cell", cellDict(damping));
    const clumpType& type = clump.type;
    const autoPtr<integrator> euler(implicitOne());
    Random random(8);

    clumpState s(type);
    disturb(type, s, 0.3, random);
    const externalForces nothing(type.size());
    const scalar first = energy(clump.bonds, s);
    scalar before = first;

    for (label step = 0; step < 100; ++step)
    {
        euler->advance(clump.bonds, nothing, dt, s);
        const scalar now = energy(clump.bonds, s);
        REQUIRE(now <= before + 1e-12*first);
        before = now;
    }
}


TEST_CASE("integrators: momentum changes by the impulse alone", "[momentum][serial]")
{
    const bondedClump clump("cell", cellDict());
    const clumpType& type = clump.type;
    const autoPtr<integrator> method
    (
        GENERATE(true, false) ? implicitOne() : explicitOne()
    );
    Random random(9);

    clumpState s(type);
    disturb(type, s, 0.2, random);
    const clumpState start(s);

    const auto angular = [&](const clumpState& c)
    {
        return c.angularMomentum(type);
    };

    externalForces ext(type.size());
    SECTION("free")
    {}
    SECTION("forced")
    {
        forAll(ext.f, i)
        {
            ext.f[i] = 1e-12*randomVector(random);
        }
    }

    const scalar dt = 1e-6;
    const scalar size = type.mass()*max(mag(s.u));
    vector torque(Zero);

    for (label step = 0; step < 20; ++step)
    {
        const clumpState before(s);
        method->advance(clump.bonds, ext, dt, s);
        const point centre(s.centre(type));
        forAll(ext.f, i)
        {
            torque += (s.x[i] - centre) ^ ext.f[i];
        }
    }

    const vector P(type.mass()*(s.velocity(type) - start.velocity(type)));
    CHECK(mag(P - 20*dt*sum(ext.f)) < 1e-11*size);

    if (mag(torque) == 0)
    {
        CHECK(mag(angular(s) - angular(start)) < 1e-11*size*type.reach());
    }
}


TEST_CASE("integrators: implicit and explicit agree on small steps", "[verlet][serial]")
{
    // Rates of strain of 1e4 to 1e5 1/s
    const string damping = GENERATE
    (
        "type kelvinVoigt; timeConstant 1e-6;",
        "type shearThinning; lowRate { type kelvinVoigt; timeConstant 1e-6; }"
        " highRateFraction 0.1; transitionRate 2e4; exponent 0;"
    );
    const bondedClump clump("cell", cellDict(damping));
    const clumpType& type = clump.type;
    Random random(10);

    clumpState a(type);
    forAll(a.u, i)
    {
        a.u[i] = 0.1*randomVector(random);
    }
    clumpState b(a), c(a);
    const clumpState start(a);
    const externalForces nothing(type.size());

    // First order: half the step, half the error
    const scalar t = 2e-6;
    for (label k = 0; k < 100; ++k)
    {
        implicitOne()->advance(clump.bonds, nothing, t/100, a);
    }
    for (label k = 0; k < 200; ++k)
    {
        implicitOne()->advance(clump.bonds, nothing, t/200, b);
    }
    for (label k = 0; k < 1000; ++k)
    {
        explicitOne()->advance(clump.bonds, nothing, t/1000, c);
    }

    const scalar moved = max(mag(c.x - start.x));
    const scalar coarse = max(mag(a.x - c.x))/moved;
    const scalar fine = max(mag(b.x - c.x))/moved;

    CHECK(fine < 0.01);
    CHECK(coarse/fine == Approx(2).epsilon(0.1));
}


TEST_CASE("integrators: equilibrium does not depend on the step", "[equilibrium][serial]")
{
    const bondedClump clump("cell", cellDict("type kelvinVoigt; timeConstant 1e-3;"));
    const clumpType& type = clump.type;
    externalForces ext(type.size());
    ext.f[0] = vector(100e-12, 0, 0);
    ext.f[5] = -ext.f[0];

    const auto stretched = [&](const scalar dt, const scalar t)
    {
        clumpState s(type);
        for (scalar now = 0; now < t; now += dt)
        {
            implicitOne()->advance(clump.bonds, ext, dt, s);
        }
        return mag(s.x[0] - s.x[5]);
    };

    const scalar coarse = stretched(1e-3, 0.3);
    CHECK(stretched(1e-4, 0.1) == Approx(coarse).epsilon(1e-6));

    // 100 pN: between rest and twice the diameter
    CHECK(coarse > 1.5*2*1.955e-6);
}


TEST_CASE("integrators: undamped velocity-Verlet keeps its energy", "[verlet][serial]")
{
    const bondedClump clump("cell", cellDict("type none;"));
    const clumpType& type = clump.type;
    Random random(11);
    clumpState start(type);
    forAll(start.u, i)
    {
        start.u[i] = 0.02*randomVector(random);
    }
    const scalar first = energy(clump.bonds, start);
    const externalForces nothing(type.size());

    // Bounded, and second order: half the step, a quarter of the error
    const auto worst = [&](const string& fraction)
    {
        const auto verlet
        (
            selectModel<integrator>
            (
                dictOf("type velocityVerlet; stepFraction " + fraction + ";")
            )
        );
        clumpState s(start);
        scalar error = 0;
        for (label k = 0; k < 200; ++k)
        {
            verlet->advance(clump.bonds, nothing, 1e-6, s);
            error = max(error, mag(energy(clump.bonds, s) - first));
        }
        return error/first;
    };

    const scalar coarse = worst("0.1");
    CHECK(coarse < 0.02);
    CHECK(coarse/worst("0.05") == Approx(4).epsilon(0.25));
}


TEST_CASE("integrators: coincident and inverted spheres are no singularity", "[hard][serial]")
{
    const bondedClump clump("cell", cellDict("type kelvinVoigt; timeConstant 1e-3;"));
    const clumpType& type = clump.type;
    clumpState s(type);

    SECTION("all spheres at one point")
    {
        s.x = Zero;
    }
    SECTION("flattened to a line")
    {
        for (point& p : s.x)
        {
            p.y() = p.z() = 0;
        }
    }
    SECTION("turned inside out")
    {
        s.x *= -0.5;
    }

    const externalForces nothing(type.size());
    const scalar before = energy(clump.bonds, s);
    for (label step = 0; step < 200; ++step)
    {
        implicitOne()->advance(clump.bonds, nothing, 1e-4, s);
    }
    CHECK(energy(clump.bonds, s) < 0.5*before);
    CHECK(max(mag(s.x - s.centre(type))) < 2*type.reach());
}


TEST_CASE("integrators: explicit steps follow a stiff conservation model", "[energy][serial]")
{
    // Moduli that are soft, as stiff as the bonds, and far stiffer
    const string model = GENERATE
    (
        "enclosedArea; areaModulus 1e-5;",
        "enclosedArea; areaModulus 1e-3;",
        "enclosedArea; areaModulus 0.1;",
        "enclosedArea; areaModulus 10;",
        "compression; volumeModulus 1e3;",
        "compression; volumeModulus 1e6;"
    );
    const label n = GENERATE(6, 10, 32);
    dictionary dict(cellDict("type none;", "type elastic;", n));
    dict.set
    (
        "shape",
        dictOf
        (
            "type ring; nSpheres " + Foam::name(n)
          + "; diameter 7.82e-6; volume 94e-18;"
        )
    );
    dict.add
    (
        "conservationModel",
        dictOf("type " + model)
    );
    const bondedClump clump("cell", dict);
    const clumpType& type = clump.type;
    const integrators::velocityVerlet verlet
    (
        dictOf("type velocityVerlet; stepFraction 0.9;")
    );

    clumpState s(type);
    Random random(41);
    disturb(type, s, 0.02, random);
    const externalForces nothing(type.size());
    const scalar first = energy(clump.bonds, s);
    INFO(model << ' ' << n << " spheres");

    // Two hundred sub-steps in twenty advances, longer than the bonds allow
    const scalar dt = 10*verlet.stableStep(clump.bonds, nothing, s.x);
    scalar largest = 0;
    for (label step = 0; step < 20; ++step)
    {
        verlet.advance(clump.bonds, nothing, dt, s);
        largest = max(largest, energy(clump.bonds, s));
    }
    CHECK(largest < 2*first);
}


TEST_CASE("integrators: energy and momentum of a fibre that turns", "[energy][serial]")
{
    const scalar stiffness = GENERATE(4e-10, 4e-8, 4e-6);
    const scalar dt = GENERATE(1e-5, 4e-5, 1e-4, 4e-4, 1e-3, 1e-2);
    const string damping = GENERATE("type none;", "type kelvinVoigt; timeConstant 1e-3;");
    const string rigidity(Foam::name(stiffness));
    dictionary dict(cellDict(damping, "type timoshenko;", 6));
    dict.set
    (
        "shape", dictOf("type chain; nSpheres 6; spacing 1.5e-6; sphereRadius 1e-6;")
    );
    dict.set
    (
        "bondModel",
        dictOf
        (
            "type timoshenko; rigidities { normal " + rigidity + "; tangential "
          + rigidity + "; bending 1e-21; torsional 1e-21; }"
        )
    );
    const bondedClump clump("fibre", dict);
    const clumpType& type = clump.type;
    const externalForces nothing(type.size());
    const vector omega(600, 2000, 1000);
    clumpState s(type);
    s.setRigidMotion(type, vector(1e-4, 0, 0), omega);
    const vector L(s.angularMomentum(type));
    const vector velocity(s.velocity(type));
    const scalar first = energy(clump.bonds, s);
    INFO(stiffness << ' ' << dt << ' ' << damping);

    // The velocities are means over a step: in the direction of its middle, and not of
    // its end, by half of the angle of a step
    const scalar angle = dt*mag(omega);
    for (label step = 0; step < 40; ++step)
    {
        implicitOne()->advance(clump.bonds, nothing, dt, s);
        if (angle < 0.25)
        {
            REQUIRE(energy(clump.bonds, s) <= (1 + 0.25*sqr(angle))*first);
        }
    }
    CHECK(mag(s.angularMomentum(type) - L) < 1e-11*mag(L));
    CHECK(mag(s.velocity(type) - velocity) < 1e-11*mag(omega)*type.reach());
}
