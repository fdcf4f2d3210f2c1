/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCase.H"
#include "testCatch.H"
#include "bell.H"
#include "bondFrame.H"
#include "bondSpring.H"
#include "mathematicalConstants.H"
#include "surfaceBonds.H"

using namespace Foam;

namespace
{

const scalar kT = 1.380649e-23*310;

gapModels::bell law(const string& further = "")
{
    return gapModels::bell
    (
        dictOf
        (
            "type bell; density 1e13; reach 1e-7; onRate 3; offRate 2;"
            " compliance 4e-10; stiffness 1e-3; " + further
        )
    );
}


//- Numbers by chance of the bond with a number
scalar chance(const label number, const label timeIndex)
{
    surfaceBond b;
    b.law = "selectins";
    b.clump = labelPair(number, number + 1);
    b.sphere = labelPair(0, 0);
    return surfaceBonds::uniform(surfaceBonds::breaking, 1, b, timeIndex);
}

}


TEST_CASE("bell: the rate of slip, ideal and catch bonds", "[contact][serial]")
{
    const scalar F = 1e-11;
    CHECK(law().offRate(0) == 2);
    CHECK(law().offRate(F) == Approx(2*Foam::exp(F*4e-10/kT)));
    CHECK(law("compliance 0;").offRate(F) == 2);
    CHECK(law("compliance -4e-10;").offRate(F) == Approx(2*Foam::exp(-F*4e-10/kT)));
    CHECK
    (
        law("temperature 620;").offRate(F)
     == Approx(2*Foam::exp(F*4e-10/(2*kT)))
    );

    // A bond is a string, without force when it forms
    CHECK(law().tension(0.9e-7) == 0);
    CHECK(law().tension(1.2e-7) == Approx(1.5e-11));
    CHECK(law("restLength 0;").tension(1e-7) == Approx(1e-10));
    for (const scalar l : {0.9e-7, 1.02e-7, 1.0999e-7, 1.1001e-7, 1.4e-7})
    {
        INFO(l);
        const gapModels::bell model(law());
        const scalar h = 1e-12;
        CHECK
        (
            model.tension(l)
         == Approx((model.energy(l + h) - model.energy(l - h))/(2*h)).margin(1e-17)
        );
        CHECK
        (
            model.stiffness(l)
         == Approx((model.tension(l + h) - model.tension(l - h))/(2*h)).margin(1e-7)
        );
    }
}


TEST_CASE("bell: chances of a step are those of any other division of the time",
    "[contact][serial]")
{
    // Of a place that is bound and of one that is free, after the time 0.7 in n steps: the
    // exact solution of dP/dt = k_on (1 - P) - k_off P
    const gapModels::bell model(law());
    for (const scalar off : {0.01, 2.0, 500.0})
    {
        for (const label n : {1, 2, 7, 100})
        {
            const scalar dt = 0.7/n;
            const scalar p = model.toForm(off, dt);
            const scalar lost =
                model.toBreak(off, dt)*(1 - model.toFormAnew(off, dt));
            const scalar k = 3 + off;
            scalar bound = 1, unbound = 0;
            for (label step = 0; step < n; ++step)
            {
                bound += p*(1 - bound) - lost*bound;
                unbound += p*(1 - unbound) - lost*unbound;
            }
            INFO(off << ' ' << n);
            CHECK(bound == Approx((3 + off*Foam::exp(-0.7*k))/k).epsilon(1e-9));
            CHECK(unbound == Approx(3/k*(1 - Foam::exp(-0.7*k))).epsilon(1e-9));
        }
    }
    const gapModels::bell noneForm(law("onRate 0; offRate 0;"));
    CHECK(noneForm.toForm(0, 1) == 0);
    CHECK(noneForm.toBreak(0, 1) == 0);
    CHECK(noneForm.toFormAnew(0, 1) == 0);
}


TEST_CASE("bell: lifetimes under a constant force are exponential",
    "[contact][serial]")
{
    const gapModels::bell model(law());
    const label n = 5000;
    const scalar dt = 0.01;
    for (const scalar F : {0.0, 5e-12, 1.5e-11})
    {
        const scalar rate = model.offRate(F);
        const scalar q = model.toBreak(rate, dt);
        scalarList ends(n, Zero);
        forAll(ends, bond)
        {
            label step = 1;
            for (; chance(bond, step) >= q; ++step)
            {}
            // Anywhere in the step, as the exact lifetime is
            const scalar u = chance(bond, -step);
            ends[bond] =
                (step - 1)*dt - std::log1p(-u*q)/rate;
        }
        const scalar mean = sum(ends)/n;
        INFO(F << " N: mean lifetime " << mean << " s, exact " << 1/rate);
        Info<< "Bell, " << F << " N: mean lifetime of " << n << " bonds " << mean
            << " s, exact " << 1/rate << " s, standard error "
            << 1/rate/Foam::sqrt(scalar(n)) << endl;
        CHECK(mag(mean*rate - 1) < 3/Foam::sqrt(scalar(n)));

        // Kolmogorov and Smirnov: 1.63/sqrt(n) is exceeded in 1 % of the samples
        sort(ends);
        scalar largest = 0;
        forAll(ends, i)
        {
            const scalar exact = -std::expm1(-rate*ends[i]);
            largest = max
            (
                largest, max(mag(exact - scalar(i)/n), mag(exact - scalar(i + 1)/n))
            );
        }
        CHECK(largest < 1.63/Foam::sqrt(scalar(n)));
    }
}


TEST_CASE("bell: the force of rupture at a constant rate of loading",
    "[contact][serial]")
{
    // Bonds that bear the force F* = kT/x_b ln(r x_b/(k_0 kT)), the most frequent one of
    // rupture: the part exp(-(1 - k_0 kT/(r x_b)))
    const gapModels::bell model(law());
    const scalar r = 1e-9, xb = 4e-10;
    const scalar slow = 2*kT/(r*xb);
    const scalar F = -kT/xb*Foam::log(slow);
    const label n = 5000, nSteps = 2000;
    const scalar dt = F/r/nSteps;
    label survived = 0;
    for (label bond = 0; bond < n; ++bond)
    {
        bool bound = true;
        for (label step = 1; bound && step <= nSteps; ++step)
        {
            const scalar rate = model.offRate(r*dt*(step - 0.5));
            bound = chance(bond, step) >= model.toBreak(rate, dt);
        }
        survived += bound;
    }
    const scalar exact = Foam::exp(-(1 - slow));
    const scalar part = scalar(survived)/n;
    Info<< "Bell, loaded with " << r << " N/s up to " << F << " N: survived " << part
        << ", exact " << exact << endl;
    CHECK(mag(part - exact) < 3*Foam::sqrt(exact*(1 - exact)/n));
}


TEST_CASE("surface bonds: chances are independent of each other", "[contact][serial]")
{
    const label n = 20000;
    scalar mean = 0, square = 0, next = 0, beside = 0;
    for (label k = 0; k < n; ++k)
    {
        const scalar u = chance(k, 7) - 0.5;
        mean += u/n;
        square += sqr(u)/n;
        next += u*(chance(k, 8) - 0.5)/n;
        beside += u*(chance(k + 1, 7) - 0.5)/n;
    }
    // In standard errors
    const scalar s = Foam::sqrt(1.0/12);
    CHECK(mag(mean) < 4*s/Foam::sqrt(scalar(n)));
    CHECK(mag(square - sqr(s)) < 4/Foam::sqrt(180.0*n));
    CHECK(mag(next) < 4*sqr(s)/Foam::sqrt(scalar(n)));
    CHECK(mag(beside) < 4*sqr(s)/Foam::sqrt(scalar(n)));
}


TEST_CASE("bond spring: forces and torques are derivatives of the energy",
    "[contact][serial]")
{
    const gapModels::bell model(law());
    const vector a(3e-7, -1e-7, 2e-7), b(-2e-7, 3e-7, 1e-7), d(8e-7, -3e-7, 3e-7);
    const auto spring = [&]
    (
        const vector& x, const vector& phi, const vector& y, const vector& psi
    )
    {
        bondSpring s;
        s.evaluate
        (
            model, d + y - x, rotation(phi).transform(a), rotation(psi).transform(b)
        );
        return s;
    };
    const bondSpring here(spring(Zero, Zero, Zero, Zero));
    CHECK(here.tension() > 0);
    CHECK(mag(here.force()) == Approx(here.tension()));

    // The other body has the opposite force and moment about any point
    bondSpring other;
    other.evaluate(model, -d, b, a);
    CHECK(mag(here.force() + other.force()) < 1e-12*here.tension());
    CHECK
    (
        mag(here.torque() + other.torque() + (d ^ other.force()))
      < 1e-12*here.tension()*mag(d)
    );

    clumpTangent::block D(clumpTangent::block::Zero());
    here.addRotations(D);
    const scalar h = 1e-11, turn = 1e-5;
    for (direction c = 0; c < 3; ++c)
    {
        vector e(Zero);
        e[c] = 1;
        const bondSpring up(spring(h*e, Zero, Zero, Zero));
        const bondSpring down(spring(-h*e, Zero, Zero, Zero));
        CHECK
        (
            (here.force() & e)
         == Approx((down.energy() - up.energy())/(2*h)).margin(1e-5*here.tension())
        );
        const vector K((down.force() - up.force())/(2*h));
        CHECK(mag((here.stiffness() & e) - K) < 1e-5*mag(here.stiffness()));

        const bondSpring left(spring(Zero, turn*e, Zero, Zero));
        const bondSpring right(spring(Zero, -turn*e, Zero, Zero));
        CHECK
        (
            (here.torque() & e)
         == Approx((right.energy() - left.energy())/(2*turn))
           .margin(1e-5*here.tension()*mag(a))
        );
        const vector KR((right.force() - left.force())/(2*turn));
        const vector KD(D(0, 3 + c), D(1, 3 + c), D(2, 3 + c));
        CHECK(mag(KR - KD) < 1e-4*mag(here.stiffness())*mag(a));
        for (direction r = 0; r < 3; ++r)
        {
            CHECK(D(r, 3 + c) == Approx(D(3 + c, r)));
        }

        // What the other body does
        vector F, M;
        here.ofOther(h*e, Zero, F, M);
        const bondSpring moved(spring(Zero, Zero, h*e, Zero));
        CHECK(mag(F - (moved.force() - here.force())) < 1e-3*mag(F) + 1e-20);
        CHECK(mag(M - (moved.torque() - here.torque())) < 1e-3*mag(M) + 1e-26);
        here.ofOther(Zero, turn*e, F, M);
        const bondSpring turned(spring(Zero, Zero, Zero, turn*e));
        CHECK(mag(F - (turned.force() - here.force())) < 1e-3*mag(F) + 1e-18);
    }
}
