/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "bondForces.H"
#include "integrator.H"
#include <Eigen/Eigenvalues>

using namespace Foam;

namespace
{

//- One relaxation time for all kinds of strain
const scalar tau = 2e-3;
const string oneTime = "type kelvinVoigt; timeConstant 2e-3;";

//- Low, high and transition rate of this file
const scalar fraction = 0.1;
const scalar transition = 50;

string thinning(const string& exponent, const string& low = oneTime)
{
    return
        "type shearThinning; lowRate { " + low + " } highRateFraction 0.1;"
        " transitionRate 50; exponent " + exponent + ";";
}

scalar carreau(const scalar q, const scalar n)
{
    return
        fraction
      + (1 - fraction)*Foam::pow(1 + sqr(q/transition), 0.5*(n - 1));
}


//- Two spheres with the rigidities 1e-10 N, 2e-10 N, 3e-22 N m2 and 4e-22 N m2
dictionary pairDict(const string& damping)
{
    return dictOf
    (
        "shape { type chain; nSpheres 2; spacing 2e-6; sphereRadius 1e-6; }"
        "density 1000; massModel union; motion free;"
        "bondModel { type elastic; rigidities { normal 1e-10;"
        " tangential 2e-10; bending 3e-22; torsional 4e-22; } }"
        "dampingModel { " + damping + " }"
    );
}


//- Frame of a bond with these strains: d [m] and psi [rad]
bondFrame frameOf(const vector& d, const vector& psi)
{
    return bondFrame(Zero, d, rotation(-0.5*psi), rotation(0.5*psi));
}

typedef Eigen::Matrix<double, 6, 1> vector6;
typedef Eigen::Matrix<double, 6, 6> matrix6;

//- A strain in bond lengths and radians
bondFrame frameOf(const vector6& e, const scalar length)
{
    return frameOf
    (
        length*vector(e[0], e[1], e[2]), vector(e[3], e[4], e[5])
    );
}


//- The damping alone of the only bond of a clump over a step
struct stepOfPair
{
    const bondedClump clump;
    const clumpBonds::bond& bond;
    stepDamping damping;

    stepOfPair(const string& model, const vector6& start, const scalar dt)
    :
        clump("pair", pairDict(model)),
        bond(clump.bonds.bonds()[0]),
        damping(clump.bonds)
    {
        damping.setStart(0, frameOf(start, bond.length));
        damping.setStep(1/dt);
    }

    //- Potential [J] and its gradient [J] by strains in bond lengths and radians
    scalar potential(const vector6& e, vector6* gradient = nullptr) const
    {
        const bondFrame frame(frameOf(e, bond.length));
        bondResponse r
        (
            clump.bonds.law(), bond, frame.d(), frame.psi()
        );
        r.n = r.m = Zero;
        r.energy = 0;
        damping.add(0, frame, r);
        if (gradient)
        {
            r.n *= bond.length;
            *gradient << r.n.x(), r.n.y(), r.n.z(), r.m.x(), r.m.y(), r.m.z();
        }
        return r.energy;
    }

    //- Matrix of these coefficients, for strains in bond lengths and radians
    matrix6 matrix(const bondCoefficients& c) const
    {
        matrix6 result(matrix6::Zero());
        for (label k = 0; k < 3; ++k)
        {
            vector unit(Zero);
            unit[k] = 1;
            const vector n
            (
                sqr(bond.length)*bondResponse::transverse
                (
                    c.normal, c.tangential, damping.direction(0), unit
                )
            );
            const vector m
            (
                bondResponse::transverse
                (
                    c.torsional, c.bending, bond.direction, unit
                )
            );
            result.col(k).head<3>() << n.x(), n.y(), n.z();
            result.col(3 + k).tail<3>() << m.x(), m.y(), m.z();
        }
        return result;
    }
};

}


TEST_CASE("shear thinning: the law, its integral and its slope", "[bonds][serial]")
{
    const scalar n = GENERATE(0.0, 0.4, 1.0);
    const rateThinning law(fraction, transition, n);
    CHECK(law.active() == (n < 1));
    CHECK(!rateThinning(1, transition, n).active());
    CHECK(!rateThinning().active());

    // Both limits
    CHECK(law.factor(0) == 1);
    CHECK(law.mean(0) == 1);
    if (n == 0)
    {
        CHECK(law.factor(1e20) == Approx(fraction).epsilon(1e-8));
        CHECK(law.mean(1e20) == Approx(fraction).epsilon(1e-8));
    }

    scalar sum = 0, below = 0, force = 0;
    for (const scalar s : {1e-12, 1e-5, 0.01, 0.3, 1.0, 4.0, 100.0, 1e5})
    {
        const scalar h = 1e-5*s;
        CHECK
        (
            s*law.slope(s)
         == Approx(s*(law.factor(s + h) - law.factor(s - h))/(2*h)).margin(1e-8)
        );

        // Integral in 1000 intervals by Simpson's rule, uniform in ln(1 + s)
        const scalar a = std::log1p(below), b = std::log1p(s);
        for (label k = 0; k < 1000; ++k)
        {
            const scalar width = (b - a)/1000;
            const auto f = [&](const scalar y)
            {
                return law.factor(std::expm1(y))*Foam::exp(y);
            };
            const scalar y = a + k*width;
            sum += width/6*(f(y) + 4*f(y + 0.5*width) + f(y + width));
        }
        below = s;
        CHECK(law.mean(s)*s == Approx(sum).epsilon(1e-9));

        // The force grows with the rate
        CHECK(law.factor(s)*Foam::sqrt(s) > force);
        force = law.factor(s)*Foam::sqrt(s);
        CHECK(law.factor(s) + 2*s*law.slope(s) > 0);
    }
}


TEST_CASE("shear thinning: forces of one bond at given rates", "[bonds][serial]")
{
    const scalar n = GENERATE(0.0, 0.4);
    const bondedClump clump("pair", pairDict(thinning(n == 0 ? "0" : "0.4")));
    const clumpBonds::bond& bond = clump.bonds.bonds()[0];
    const vector e(bond.direction);
    const vector across(e ^ (mag(e.x()) < 0.9 ? vector(1, 0, 0) : vector(0, 1, 0)));
    const scalar l = bond.length;

    for (const scalar q : {1e-4, 1.0, 50.0, 400.0, 1e6})
    {
        const scalar g = carreau(q, n);
        vectorField F(2), T(2);

        // Elongation at the rate q
        clumpState s(clump.type);
        s.u[0] = -0.5*l*q*e;
        s.u[1] = -s.u[0];
        bondForces(clump.bonds).explicitForces(s, F, T);
        CHECK((F[0] & e) == Approx(g*tau*1e-10*q).epsilon(1e-9));

        // Bending and torsion: with the radius of gyration
        for (const bool bends : {true, false})
        {
            const vector axis(bends ? across/mag(across) : e);
            const scalar rigidity = bends ? 3e-22 : 4e-22;
            const scalar rate = q*l/Foam::sqrt(rigidity/1e-10);
            s = clumpState(clump.type);
            s.w[0] = -0.5*rate*axis;
            s.w[1] = -s.w[0];
            bondForces(clump.bonds).explicitForces(s, F, T);
            CHECK
            (
                (T[0] & axis) == Approx(g*tau*rigidity/l*rate).epsilon(1e-9)
            );
        }
    }

    // Two kinds at once: 3, 4, 5
    clumpState s(clump.type);
    s.u[1] = 0.3*400*l*e;
    s.w[1] = 0.4*400*l/Foam::sqrt(4e-12)*e;
    vectorField F(2), T(2);
    bondForces(clump.bonds).explicitForces(s, F, T);
    CHECK
    (
        (F[0] & e) == Approx(carreau(0.5*400, n)*tau*1e-10*0.3*400).epsilon(1e-9)
    );
}


TEST_CASE("shear thinning: the potential of a step is strictly convex", "[bonds][serial]")
{
    const string low = GENERATE
    (
        "type kelvinVoigt; timeConstant 2e-3;",
        "type kelvinVoigt; timeConstants { normal 2e-3; tangential 1e-3;"
        " bending 2e-2; torsional 1e-2; }",
        "type dampingRatio; beta 1500;"
    );
    const scalar dt = GENERATE(1e-5, 1e-4, 1e-3, 1e-2);
    const string exponent = GENERATE("0", "0.4");
    Random random(51);

    // A bond along any direction
    const auto random6 = [&random]()
    {
        const vector a(randomVector(random)), b(randomVector(random));
        vector6 v;
        v << a.x(), a.y(), a.z(), b.x(), b.y(), b.z();
        return v;
    };
    vector6 start(0.1*random6());
    start[0] += 1;
    const stepOfPair step(thinning(exponent, low), start, dt);
    const stepOfPair plain(low, start, dt);

    CHECK(step.potential(start) == 0);
    for (label trial = 0; trial < 20; ++trial)
    {
        // Rates of strain around the transition, rotations below half a turn
        const scalar size =
            min(transition*dt*Foam::pow(10.0, random.position(-1.0, 1.0)), 0.5);
        const vector6 a(start + size*random6());
        const vector6 b(start + size*random6());

        vector6 gradient;
        const scalar D = step.potential(a, &gradient);
        REQUIRE(D > 0);
        const scalar chord = 0.5*(D + step.potential(b));
        REQUIRE(step.potential(0.5*(a + b)) < chord);

        // Force against the change: dissipation
        REQUIRE(gradient.dot(a - start) > 0);

        // Gradient against differences of the potential, the second derivative
        // against differences of the gradient
        const scalar h = 1e-4*size;
        matrix6 differences;
        for (label c = 0; c < 6; ++c)
        {
            vector6 shift(vector6::Zero());
            shift[c] = h;
            vector6 plus, minus;
            const scalar slope =
                (step.potential(a + shift, &plus) - step.potential(a - shift, &minus))
               /(2*h);
            REQUIRE(mag(slope - gradient[c]) < 1e-7*gradient.norm());
            differences.col(c) = (plus - minus)/(2*h);
        }

        const bondFrame frame(frameOf(a, step.bond.length));
        const stepDamping::tangent second(step.damping.derivative(0, frame));
        const scalar l = step.bond.length;
        vector6 f;
        f <<
            l*second.n.x(), l*second.n.y(), l*second.n.z(),
            second.m.x(), second.m.y(), second.m.z();
        const matrix6 exact
        (
            step.matrix(second.c) + second.slope*f*f.transpose()
        );
        REQUIRE((exact - differences).norm() < 1e-6*exact.norm());

        // Between the high rate limit and the low rate limit, constant damping
        const stepDamping::tangent low0(plain.damping.derivative(0, frame));
        REQUIRE(low0.slope == 0);
        const Eigen::GeneralizedSelfAdjointEigenSolver<matrix6> eigen
        (
            exact, plain.matrix(low0.c)
        );
        REQUIRE(eigen.eigenvalues()[0] > fraction);
        REQUIRE(eigen.eigenvalues()[5] < 1);
    }
}


TEST_CASE("shear thinning: without it the damping is the same to the last bit", "[bonds][serial]")
{
    const string none = GENERATE
    (
        "highRateFraction 1; transitionRate 10; exponent 0;",
        "highRateFraction 0.1; transitionRate 10; exponent 1;"
    );
    const bondedClump thinned
    (
        "cell",
        cellDict
        (
            "type shearThinning; lowRate { type dampingRatio; beta 1500; }" + none
        )
    );
    const bondedClump plain("cell", cellDict());
    Random random(52);
    clumpState s(plain.type);
    const clumpState start(s);
    disturb(plain.type, s, 0.3, random);

    const label n = plain.type.size();
    vectorField F(n), T(n), f(n), t(n);
    clumpTangent K(plain.bonds.pattern()), k(thinned.bonds.pattern());
    K.setZero();
    k.setZero();
    const scalar E = bondForces(plain.bonds, start).stepForces(s, 1e-4, F, T, &K);
    CHECK(bondForces(thinned.bonds, start).stepForces(s, 1e-4, f, t, &k) == E);
    CHECK(f == F);
    CHECK(t == T);
    CHECK(k.dense() == K.dense());

    bondForces(plain.bonds).explicitForces(s, F, T);
    bondForces(thinned.bonds).explicitForces(s, f, t);
    CHECK(f == F);
    CHECK(t == T);
}


TEST_CASE("shear thinning: dissipation between its limits in every frame", "[bonds][serial]")
{
    const bondedClump thinned("cell", cellDict(thinning("0")));
    const bondedClump low("cell", cellDict(oneTime));
    const bondedClump elastic("cell", cellDict("type none;"));
    const clumpType& type = low.type;
    const label n = type.size();
    Random random(53);

    for (label trial = 0; trial < 20; ++trial)
    {
        clumpState s(type, randomRotation(random));
        disturb(type, s, 0.3, random);

        // From far below to far above the transition
        const scalar speed = Foam::pow(10.0, 0.5*(trial - 10));
        s.u *= speed;
        s.w *= speed;

        vectorField F(n), T(n), F0(n), T0(n), FE(n), TE(n);
        bondForces(elastic.bonds).explicitForces(s, FE, TE);
        bondForces(low.bonds).explicitForces(s, F0, T0);
        bondForces(thinned.bonds).explicitForces(s, F, T);
        const scalar power = -sum((F - FE) & s.u) - sum((T - TE) & s.w);
        const scalar power0 = -sum((F0 - FE) & s.u) - sum((T0 - TE) & s.w);

        // The elastic forces round the difference off
        const scalar error =
            1e-12*(sum(mag(FE))*max(mag(s.u)) + sum(mag(TE))*max(mag(s.w)));
        CHECK(power > -error);
        CHECK(power > fraction*power0 - error);
        CHECK(power < power0 + error);
        if (speed > 1e4)
        {
            CHECK(power == Approx(fraction*power0).epsilon(0.05));
        }
        if (speed < 1e-4)
        {
            CHECK(power == Approx(power0).epsilon(0.01).margin(error));
        }

        // Turned, and with any rigid motion on top
        const quaternion turn(randomRotation(random));
        const tensor R(turn.R());
        const vector omega(speed*100*randomVector(random));
        clumpState moved(s);
        forAll(s.x, i)
        {
            moved.x[i] = (R & s.x[i]) + 1e-5*vector::one;
            moved.q[i] = turn*s.q[i];
            moved.u[i] = (R & s.u[i]) + speed*vector(1e-4, 2e-4, 3e-4) + (omega ^ moved.x[i]);
            moved.w[i] = (R & s.w[i]) + omega;
        }
        vectorField f(n), t(n);
        bondForces(thinned.bonds).explicitForces(moved, f, t);
        CHECK(max(mag(f - (R & F))) < 1e-9*max(mag(F)));
        CHECK(max(mag(t - (R & T))) < 1e-9*max(mag(T)));

        // Over an implicit step, which starts and ends turned
        clumpState start(s);
        disturb(type, start, 0.05, random);
        clumpState movedStart(start);
        forAll(start.x, i)
        {
            movedStart.x[i] = R & start.x[i];
            movedStart.q[i] = turn*start.q[i];
        }
        const scalar W = bondForces(thinned.bonds, start).stepForces(s, 1e-3, F, T);
        const scalar w =
            bondForces(thinned.bonds, movedStart).stepForces(moved, 1e-3, f, t);
        CHECK(w == Approx(W).epsilon(1e-9));
        CHECK(max(mag(f - (R & F))) < 1e-9*max(mag(F)));
        CHECK(max(mag(t - (R & T))) < 1e-9*max(mag(T)));
    }
}


TEST_CASE("shear thinning: a bond relaxes as the equation says", "[bonds][serial]")
{
    const bool stretches = GENERATE(true, false);
    const scalar n = GENERATE(0.0, 0.4);
    const bondedClump clump("pair", pairDict(thinning(n == 0 ? "0" : "0.4")));
    const auto euler
    (
        selectModel<integrator>
        (
            dictOf("type implicitEuler; tolerance 1e-11; maxIterations 100;")
        )
    );
    const clumpType& type = clump.type;
    const vector e(clump.bonds.bonds()[0].direction);
    const scalar l = clump.bonds.bonds()[0].length;

    // Without inertia, K a = c(q) q for an elongation a: tau g(q) q = a, with
    // q = -da/dt. The elongation 0.5 starts at the rate 250 1/s without thinning
    const scalar a0 = 0.5;
    const scalar end = 1.5e-3;
    const auto rate = [&](const scalar a)
    {
        scalar low = 0, high = a/(fraction*tau);
        for (label k = 0; k < 100; ++k)
        {
            const scalar q = 0.5*(low + high);
            (tau*carreau(q, n)*q < a ? low : high) = q;
        }
        return 0.5*(low + high);
    };
    scalar exact = a0;
    const scalar h = end/2000;
    for (label k = 0; k < 2000; ++k)
    {
        const scalar k1 = rate(exact);
        const scalar k2 = rate(exact - 0.5*h*k1);
        const scalar k3 = rate(exact - 0.5*h*k2);
        const scalar k4 = rate(exact - h*k3);
        exact -= h/6*(k1 + 2*k2 + 2*k3 + k4);
    }

    // Torsion in units of elongation: l/r_g
    const scalar unit = stretches ? l : l/Foam::sqrt(4e-12);
    const auto relaxed = [&](const label nSteps)
    {
        clumpState s(type);
        if (stretches)
        {
            s.x[1] += a0*l*e;
        }
        else
        {
            s.q[1] = rotation(a0*unit*e);
        }
        const externalForces nothing(2);
        for (label k = 0; k < nSteps; ++k)
        {
            euler->advance(clump.bonds, nothing, end/nSteps, s);
        }
        return
            stretches
          ? mag(s.x[1] - s.x[0])/l - 1
          : (rotationVector(s.q[1]*conjugate(s.q[0])) & e)/unit;
    };

    const scalar coarse = relaxed(50) - exact;
    const scalar fine = relaxed(100) - exact;
    INFO(exact << ' ' << coarse << ' ' << fine << ' ' << relaxed(5));

    // Faster than without thinning, slower than with the damping of high rates
    CHECK(exact < a0*Foam::exp(-end/tau));
    CHECK(exact > a0*Foam::exp(-end/(fraction*tau)));
    CHECK(mag(fine) < 0.02*a0);
    CHECK(coarse/fine == Approx(2).epsilon(0.1));

    // Long steps, too, remain between start and rest
    CHECK(relaxed(1) > 0);
    CHECK(relaxed(1) < a0);
}
