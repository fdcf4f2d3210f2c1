/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "equilibrium.H"
#include "newtonMinimiser.H"
#include "clumpExtent.H"

using namespace Foam;


TEST_CASE("equilibrium: forces balance on every sphere", "[equilibrium][serial]")
{
    const string bond = GENERATE
    (
        "type elastic;",
        "type strainStiffening; stiffening 0.5;"
    );
    const bondedClump clump("cell", cellDict("type none;", bond));
    const clumpType& type = clump.type;
    const vector pull(1e-10, 0, 0);
    const auto ext(equilibrium::stretch(type, pull));
    CHECK(mag(sum(ext.f)) < 1e-24);
    CHECK(mag(ext.f[0] - pull) < 1e-22);

    clumpState s(type);
    REQUIRE(equilibrium().find(clump.bonds, ext, s));

    vectorField F(type.size()), T(type.size());
    bondForces(clump.bonds, s).stepForces(s, 0, F, T);
    CHECK(max(mag(F + ext.f)) < 1e-9*mag(pull));
    CHECK(max(mag(T)) < 1e-9*mag(pull)*type.reach());
}


TEST_CASE("equilibrium: Newton's method converges quadratically", "[equilibrium][serial]")
{
    const bondedClump clump("cell", cellDict("type none;"));
    const clumpType& type = clump.type;
    Random random(12);

    // A bent and twisted state in space, held by the forces it needs
    clumpState held(type);
    disturb(type, held, 0.1, random);
    vectorField F(type.size()), T(type.size());
    bondForces(clump.bonds, held).stepForces(held, 0, F, T);
    externalForces ext(type.size());
    ext.f = -F;
    ext.t = -T;

    // The steps from near by: each the square of the one before, but for a factor
    clumpState s(held);
    disturb(type, s, 0.001, random);
    const clumpState start(held);
    const incrementalPotential potential(clump.bonds, ext, 0, start);
    Eigen::VectorXd g(6*type.size());
    clumpTangent K(clump.bonds.pattern());
    scalarField sizes(4);
    for (scalar& size : sizes)
    {
        potential.value(s, &g, &K);

        // Free translations: a little stiffness, which does not move the minimum
        Eigen::MatrixXd A(K.dense());
        const scalar largest = A.diagonal().maxCoeff();
        for (label i = 0; i < type.size(); ++i)
        {
            A.diagonal().segment<3>(6*i).array() += 1e-12*largest;
        }
        g = A.fullPivLu().solve(g).eval();
        size = 0;
        forAll(s.x, i)
        {
            s.x[i] -= vector(g[6*i], g[6*i + 1], g[6*i + 2]);
            s.q[i] =
                rotation(-vector(g[6*i + 3], g[6*i + 4], g[6*i + 5]))*s.q[i];
            size = max(size, mag(vector(g[6*i + 3], g[6*i + 4], g[6*i + 5])));
        }
    }
    for (label k = 0; k < 3; ++k)
    {
        INFO("steps " << sizes[0] << ' ' << sizes[1] << ' ' << sizes[2]);
        CHECK(sizes[k + 1] < 100*sqr(sizes[k]) + 1e-11);
    }
}


TEST_CASE("tangent: sparse factorisation solves the dense system", "[tangent][serial]")
{
    // A shell fills in; a ring with its area and volume held has two
    // terms of rank one
    dictionary shell(cellDict("type none;"));
    shell.set("shape", dictOf
    (
        "type shell; nSpheres 42; shellRadius 3e-6; sphereRadius 1e-6;"
    ));
    dictionary ring(cellDict("type none;"));
    ring.set
    (
        "conservationModels",
        dictOf
        (
            "area { type enclosedArea; areaModulus 1e-4; }"
            "volume { type unionVolume; volumeModulus 1e4; }"
        )
    );
    const bondedClump clump("clump", GENERATE(true, false) ? shell : ring);
    const clumpType& type = clump.type;

    Random random(13);
    clumpState s(type);
    disturb(type, s, 0.1, random);
    vectorField F(type.size()), T(type.size());
    clumpTangent K(clump.bonds.pattern());
    K.setZero();
    bondForces(clump.bonds, s).stepForces(s, 0, F, T, &K);

    const scalar shift = 1e-4;
    const scalar turn = shift*sqr(type.radii()[0]);
    REQUIRE(K.factorise(shift, turn));
    Eigen::MatrixXd A(K.dense());
    for (label i = 0; i < type.size(); ++i)
    {
        A.diagonal().segment<3>(6*i).array() += shift;
        A.diagonal().segment<3>(6*i + 3).array() += turn;
    }
    const Eigen::VectorXd b(A*Eigen::VectorXd::Ones(6*type.size()));
    Eigen::VectorXd x(b);
    K.solve(x);
    CHECK((A*x - b).norm() < 1e-10*b.norm());
}


TEST_CASE("velocity-Verlet: acceleration is force over mass", "[verlet][serial]")
{
    const string bond = GENERATE
    (
        "type elastic;",
        "type strainStiffening; stiffening 0.5;"
    );
    const string damping = GENERATE("type none;", "type dampingRatio; beta 2;");
    const scalar size = GENERATE(0.05, 1.5);
    const bondedClump clump("cell", cellDict(damping, bond));
    const clumpType& type = clump.type;

    Random random(14);
    clumpState s(type, randomRotation(random));
    disturb(type, s, size, random);
    externalForces ext(type.size());
    forAll(ext.f, i)
    {
        ext.f[i] = 1e-12*randomVector(random);
        ext.t[i] = 1e-18*randomVector(random);
        ext.zeta[i] = 1e-9;
        ext.zetaR[i] = 1e-21;
        ext.imposedU[i] = randomVector(random);
    }

    vectorField F(type.size()), T(type.size());
    bondForces(clump.bonds, s).explicitForces(s, F, T);

    // In a step that is short against every time scale of the clump
    const scalar h = 1e-16;
    clumpState after(s);
    selectModel<integrator>
    (
        dictOf("type velocityVerlet; stepFraction 0.2;")
    )->advance(clump.bonds, ext, h, after);

    scalar worst = 0, scale = 0;
    forAll(F, i)
    {
        const vector f
        (
            F[i] + ext.f[i] - ext.zeta[i]*(s.u[i] - ext.imposedU[i])
        );
        const vector t(T[i] + ext.t[i] - ext.zetaR[i]*s.w[i]);
        const scalar r = type.radii()[i];
        worst = max(worst, mag((after.u[i] - s.u[i])*type.masses()[i]/h - f));
        worst = max
        (
            worst, mag((after.w[i] - s.w[i])*type.inertias()[i]/h - t)/r
        );
        scale = max(scale, mag(f));
    }
    CHECK(worst < 1e-5*scale);
}


TEST_CASE("extent: the outline reads a circle for any number of spheres", "[extent][serial]")
{
    const label n = GENERATE(6, 8, 10, 16);
    const bondedClump clump("cell", cellDict("type none;", "type elastic;", n));
    const clumpType& type = clump.type;
    const scalar D = 4*1.955e-6;

    for (const vector& d : {vector(1, 0, 0), vector(0, 1, 0), vector(0.6, 0.8, 0)})
    {
        CHECK
        (
            clumpExtent::along
            (
                d, type.centres(), type.radii(), clumpExtent::reading::outline
            ) == Approx(D).epsilon(1e-9)
        );
    }
    CHECK
    (
        clumpExtent::along
        (
            vector(1, 0, 0), type.centres(), type.radii(),
            clumpExtent::reading::spheres
        ) == Approx(D).epsilon(1e-12)
    );
}
