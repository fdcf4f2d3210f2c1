/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "catch2/catch.hpp"
#include "testCase.H"
#include "bondForces.H"

using namespace Foam;

namespace
{

//- Scale of the bond forces for strains of order one
scalar forceScale(const clumpType& type)
{
    const clumpType::bond& b = type.bonds()[0];
    return b.stiffness.normal*b.length;
}

}


TEST_CASE("bonds: a rigid motion leaves no force", "[bonds][serial]")
{
    const string bond = GENERATE
    (
        "type linearElastic;",
        "type elastic;",
        "type strainStiffening; stiffening 0.5;"
    );
    const clumpType type("cell", cellDict("type dampingRatio; beta 1500;", bond));
    Random random(1);

    for (label trial = 0; trial < 20; ++trial)
    {
        const quaternion q(randomRotation(random));
        clumpState start(type, q);
        clumpState s(start);

        // Far away, turned by any angle, moving rigidly
        const quaternion turn(randomRotation(random));
        const tensor R(turn.R());
        forAll(s.x, i)
        {
            s.x[i] = (R & s.x[i]) + 1e-3*vector::one;
            s.q[i] = turn*s.q[i];
        }
        s.setRigidMotion(type, vector(1, 2, 3), vector(100, -50, 30));

        vectorField F(type.size()), T(type.size());
        const scalar energy = bondForces(type, start).explicitForces(s, F, T);

        // Coordinates of 1e-3 m carry an error of 1e-19 m: 1e-13 of a bond.
        // Damping multiplies rates of 1 m/s by c/K = 0.05 s.
        const scalar scale = forceScale(type);
        CHECK(max(mag(F)) < 1e-9*scale);
        CHECK(max(mag(T)) < 1e-9*scale*type.radii()[0]);
        CHECK(energy < 1e-18*scale*type.radii()[0]);
    }
}


TEST_CASE("bonds: neither net force nor net torque", "[bonds][serial]")
{
    const clumpType type("cell", cellDict());
    Random random(2);

    for (label trial = 0; trial < 20; ++trial)
    {
        clumpState s(type, randomRotation(random));
        const clumpState start(s);
        disturb(type, s, 0.4, random);

        vectorField F(type.size()), T(type.size());
        bondForces(type, start).explicitForces(s, F, T);

        vector torque(sum(T));
        forAll(F, i)
        {
            torque += s.x[i] ^ F[i];
        }
        CHECK(mag(sum(F)) < 1e-13*sum(mag(F)));
        CHECK(mag(torque) < 1e-13*sum(mag(F))*type.reach());
    }
}


TEST_CASE("bonds: forces are the gradient of the energy", "[bonds][serial]")
{
    const string bond = GENERATE
    (
        "type linearElastic;",
        "type elastic;",
        "type strainStiffening; stiffening 0.5;"
    );
    const clumpType type("cell", cellDict("type none;", bond));
    Random random(3);

    const clumpState start(type);
    clumpState s(start);
    disturb(type, s, 0.3, random);

    const bondForces bonds(type, start);
    const scalar dt = 1e-4;
    vectorField F(type.size()), T(type.size()), f(F), t(T);
    bonds.stepForces(s, dt, F, T);

    const scalar r = type.radii()[0];
    const scalar h = 1e-5;

    const auto energyAt = [&](const label i, const label c, const scalar step)
    {
        clumpState moved(s);
        vector e(Zero);
        e[c % 3] = step;
        if (c < 3)
        {
            moved.x[i] += r*e;
        }
        else
        {
            moved.q[i] = rotation(e)*moved.q[i];
        }
        return bonds.stepForces(moved, dt, f, t);
    };

    for (const label i : {0, 3, 7})
    {
        for (label c = 0; c < 6; ++c)
        {
            const scalar slope = (energyAt(i, c, h) - energyAt(i, c, -h))/(2*h);
            const scalar expected = c < 3 ? -r*F[i][c] : -T[i][c % 3];
            CHECK(mag(slope - expected) < 1e-6*r*forceScale(type));
        }
    }
}


TEST_CASE("bonds: the tangent is the derivative of the forces", "[bonds][serial]")
{
    const clumpType type("cell", cellDict());
    Random random(4);

    // The tangent leaves out moment times rotation: bending small here
    const clumpState start(type);
    clumpState s(start);
    forAll(s.x, i)
    {
        s.x[i] *= 1.2;
    }

    const bondForces bonds(type, start);
    const scalar dt = 1e-3;
    const label n = 6*type.size();
    vectorField F(type.size()), T(type.size()), Fp(F), Tp(T), Fm(F), Tm(T);
    Eigen::MatrixXd K(Eigen::MatrixXd::Zero(n, n));
    bonds.stepForces(s, dt, F, T, &K);

    const scalar r = type.radii()[0];
    const scalar h = 1e-5;

    for (label c = 0; c < 6; ++c)
    {
        clumpState plus(s), minus(s);
        vector e(Zero);
        e[c % 3] = h;
        if (c < 3)
        {
            plus.x[2] += r*e;
            minus.x[2] -= r*e;
        }
        else
        {
            plus.q[2] = rotation(e)*plus.q[2];
            minus.q[2] = rotation(-e)*minus.q[2];
        }
        bonds.stepForces(plus, dt, Fp, Tp);
        bonds.stepForces(minus, dt, Fm, Tm);

        const scalar unit = c < 3 ? r : 1;
        const scalar scale = K.cwiseAbs().maxCoeff()*r*unit;
        for (label i = 0; i < type.size(); ++i)
        {
            const vector dF((Fp[i] - Fm[i])/(2*h));
            for (label d = 0; d < 3; ++d)
            {
                CHECK
                (
                    mag(dF[d] + K(6*i + d, 12 + c)*unit) < 1e-6*scale
                );
            }
        }
    }
    CHECK((K - K.transpose()).cwiseAbs().maxCoeff() < 1e-12*K.cwiseAbs().maxCoeff());
}
