/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "bondForces.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

//- Scale of the bond forces for strains of order one
scalar forceScale(const clumpBonds& bonds)
{
    const clumpBonds::bond& b = bonds.bonds()[0];
    return b.stiffness.normal*b.length;
}

}


TEST_CASE("bonds: a rigid motion leaves no force", "[bonds][serial]")
{
    const string bond = GENERATE
    (
        "type elastic;",
        "type strainStiffening; stiffening 0.5;"
    );
    const bondedClump clump("cell", cellDict("type dampingRatio; beta 1500;", bond));
    const clumpType& type = clump.type;
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
        const scalar energy = bondForces(clump.bonds, start).explicitForces(s, F, T);

        // Coordinates of 1e-3 m carry an error of 1e-19 m: 1e-13 of a bond.
        // Damping multiplies rates of 1 m/s by c/K = 0.05 s.
        const scalar scale = forceScale(clump.bonds);
        CHECK(max(mag(F)) < 1e-9*scale);
        CHECK(max(mag(T)) < 1e-9*scale*type.radii()[0]);
        CHECK(energy < 1e-18*scale*type.radii()[0]);
    }
}


TEST_CASE("bonds: neither net force nor net torque", "[bonds][serial]")
{
    const bondedClump clump("cell", cellDict());
    const clumpType& type = clump.type;
    Random random(2);

    for (label trial = 0; trial < 20; ++trial)
    {
        clumpState s(type, randomRotation(random));
        const clumpState start(s);
        disturb(type, s, 0.4, random);

        vectorField F(type.size()), T(type.size());
        bondForces(clump.bonds, start).explicitForces(s, F, T);

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
        "type elastic;",
        "type strainStiffening; stiffening 0.5;"
    );
    const string damping = GENERATE
    (
        "type none;",
        "type shearThinning; lowRate { type dampingRatio; beta 1500; }"
        " highRateFraction 0.1; transitionRate 300; exponent 0.2;"
    );
    const bondedClump clump("cell", cellDict(damping, bond));
    const clumpType& type = clump.type;
    Random random(3);

    const clumpState start(type);
    clumpState s(start);
    disturb(type, s, 0.3, random);

    const bondForces bonds(clump.bonds, start);
    const scalar dt = 1e-3;
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
            CHECK(mag(slope - expected) < 1e-6*r*forceScale(clump.bonds));
        }
    }
}


TEST_CASE("bonds: nothing jumps as a bond locks and at half a turn", "[bonds][serial]")
{
    const string bond = GENERATE
    (
        "type elastic;",
        "type strainStiffening; stiffening 0.5;"
    );
    const bondedClump clump("cell", cellDict("type dampingRatio; beta 1500;", bond));
    const clumpType& type = clump.type;
    Random random(5);
    const vector axis(normalised(random.sample01<vector>() - 0.5*vector::one));

    // Sphere 3 turns about any axis while the others stay
    const auto turned = [&](const scalar angle)
    {
        clumpState s(type);
        s.q[3] = rotation(angle*axis)*s.q[3];
        return s;
    };
    const scalar pi = constant::mathematical::pi;
    const bondForces bonds(clump.bonds, turned(0.9*pi));
    const scalar dt = 1e-3;
    vectorField F(type.size()), T(type.size()), f(F), t(T);

    const scalar h = 1e-5;
    for (const scalar angle : {1.999, 2.001, 0.95*pi, pi, 1.05*pi, 1.6*pi})
    {
        bonds.stepForces(turned(angle), dt, F, T);
        const scalar slope =
            (
                bonds.stepForces(turned(angle + h), dt, f, t)
              - bonds.stepForces(turned(angle - h), dt, f, t)
            )/(2*h);
        INFO("angle over pi " << angle/pi);
        CHECK(mag(slope + (T[3] & axis)) < 1e-6*mag(T[3]));
        CHECK(mag(t[3] - T[3]) < 1e-3*mag(T[3]));
    }
}


TEST_CASE("bonds: the tangent is the derivative of the forces", "[bonds][serial]")
{
    const string bond = GENERATE
    (
        "type elastic;",
        "type strainStiffening; stiffening 0.5;"
    );
    const string damping = GENERATE
    (
        "type dampingRatio; beta 1500;",
        "type shearThinning; lowRate { type dampingRatio; beta 1500; }"
        " highRateFraction 0.1; transitionRate 300; exponent 0.2;"
    );
    const bondedClump clump("cell", cellDict(damping, bond));
    const clumpType& type = clump.type;
    Random random(4);

    // Any state: large stretch, bending and torsion, at the end of a step
    clumpState start(type, randomRotation(random));
    disturb(type, start, 0.2, random);
    clumpState s(start);
    disturb(type, s, 0.5, random);

    // The two bonds of a sphere that turns by 2.5 rad lock
    const scalar turn = GENERATE(0.0, 2.5);
    s.q[3] = rotation(turn*normalised(randomVector(random)))*s.q[3];

    const bondForces bonds(clump.bonds, start);
    const scalar dt = 1e-3;
    const label n = 6*type.size();
    const scalar r = type.radii()[0];
    vectorField F(type.size()), T(type.size());
    clumpTangent tangent(clump.bonds.pattern());
    tangent.setZero();
    bonds.stepForces(s, dt, F, T, &tangent);

    // Rows and columns in radii and radians
    Eigen::VectorXd unit(Eigen::VectorXd::Ones(n));
    for (label i = 0; i < type.size(); ++i)
    {
        unit.segment<3>(6*i).setConstant(r);
    }
    const Eigen::MatrixXd K
    (
        unit.asDiagonal()*tangent.dense()*unit.asDiagonal()
    );

    const auto forces = [&](const label c, const scalar step)
    {
        clumpState moved(s);
        vector e(Zero);
        e[c % 3] = step;
        if (c % 6 < 3)
        {
            moved.x[c/6] += r*e;
        }
        else
        {
            moved.q[c/6] = rotation(e)*moved.q[c/6];
        }
        bonds.stepForces(moved, dt, F, T);

        Eigen::VectorXd f(n);
        forAll(F, i)
        {
            f.segment<6>(6*i) <<
                r*F[i].x(), r*F[i].y(), r*F[i].z(), T[i].x(), T[i].y(), T[i].z();
        }
        return f;
    };

    const scalar h = 1e-5;
    Eigen::MatrixXd D(n, n);
    for (label c = 0; c < n; ++c)
    {
        D.col(c) = -(forces(c, h) - forces(c, -h))/(2*h);
    }

    // Out of equilibrium the derivative has a skew part: the torque itself
    const Eigen::MatrixXd symmetric(0.5*(D + D.transpose()));
    CHECK((K - symmetric).norm() < 1e-6*K.norm());
}


TEST_CASE("bonds: gradients with respect to rotation vectors", "[bonds][serial]")
{
    Random random(3);
    const auto direction = [&]()
    {
        return 2*random.sample01<vector>() - vector::one;
    };

    for (const scalar angle : {1e-8, 0.003, 0.00999, 0.0101, 0.0999, 0.101, 1.0, 3.0})
    {
        vector phi(direction());
        phi *= angle/mag(phi);
        const vector v(direction());
        CHECK(mag(rotationGradient(phi, rotationVectorGradient(phi, v)) - v) < 1e-10);

        // v.(change of the rotation) by a change e of phi, beside the gradient
        const scalar h = 1e-5;
        const vector e(h*direction());
        const vector change
        (
            rotationVector(rotation(phi + e)*conjugate(rotation(phi - e)))/2
        );
        const scalar expected = rotationVectorGradient(phi, v) & e;
        CHECK(std::abs((v & change) - expected) < 1e-8*h);
    }
}
