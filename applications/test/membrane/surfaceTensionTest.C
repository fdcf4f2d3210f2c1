/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testMembrane.H"
#include "membraneEquilibrium.H"

using namespace Foam;

namespace
{

//- Pressure inside that leaves least of the forces on the nodes, and the largest force that
//  it leaves over the largest one
Pair<scalar> pressure(const testMembrane& m, const pointField& x)
{
    const vectorField S(m.type.surface().areaVectors(x));
    const vectorField f(m.mechanics.forces(x));
    const scalar p = -sum(f & S)/sum(S & S);
    return Pair<scalar>(p, max(mag(f + p*S))/max(mag(f)));
}

//- Second moment along z less that across it, over their sum: proportional to w of a
//  surface r = 1 + w P2(cos theta) where w is small
scalar elongation(const testMembrane& m, const pointField& x)
{
    const symmTensor M(m.type.surface().secondMoments(x));
    return (M.zz() - 0.5*(M.xx() + M.yy()))/tr(M);
}

}


TEST_CASE("surfaceTension: the pressure of Laplace", "[membrane][tension][serial]")
{
    scalar last = 0;
    for (const label n : {1, 2, 3})
    {
        const testMembrane m
        (
            "a { type surfaceTension; tension 0.3; }"
            "b { type neoHookean; shearModulus 0.003; }",
            "type icosphere; radius 2; subdivisions " + Foam::name(n) + ";"
        );
        pointField x(m.type.centres());
        const membraneEquilibrium solver(m.type, m.dict);
        REQUIRE(solver.find(vectorField(x.size(), Zero), x));
        const Pair<scalar> p(pressure(m, x));
        CHECK(p.second() < 1e-3);

        // 2 s/R of the sphere, of second order; that of the triangles to all digits
        const scalar error = p.first()/(2*0.3/2) - 1;
        CHECK(mag(error) < 0.02/pow(4.0, n - 1));
        if (last)
        {
            CHECK(error/last < 0.3);
        }
        last = error;
        const scalar A = m.type.surface().area(x);
        CHECK(p.first() == Approx(2*0.3*A/(3*m.type.volume())).epsilon(1e-4));
    }
}


TEST_CASE("surfaceTension: a spheroid becomes a sphere as far as its strain allows",
    "[membrane][tension][serial]")
{
    // A surface r = 1 + w P2 that is free of strain with w = w0 has, per squared P2, the
    // energies 4 G K/(3 K + 2 G) (w - w0)^2 of strain, with the modulus of area K = 3 G, and
    // 2 s w^2 of the tension s
    const testMembrane sphere
    (
        "a { type neoHookean; shearModulus 1; }",
        "type icosphere; radius 1; subdivisions 3;"
    );
    pointField x0(sphere.type.centres());
    for (point& p : x0)
    {
        p *= 1 + 0.01*(1.5*sqr(p.z()/mag(p)) - 0.5);
    }
    const fileName file
    (
        writtenSurface("tensionTest", x0, sphere.type.surface().triangles())
    );
    for (const scalar G : {1.0, 0.01})
    {
        const testMembrane m
        (
            "a { type surfaceTension; tension 1; }"
            "b { type neoHookean; shearModulus " + Foam::name(G) + "; }",
            "type surfaceFile; file \"" + file + "\";"
        );
        pointField x(m.type.centres());
        const scalar before = elongation(m, x);
        const membraneEquilibrium solver(m.type, m.dict);
        REQUIRE(solver.find(vectorField(x.size(), Zero), x));
        const scalar part = 12*G/11/(12*G/11 + 2);
        CHECK(elongation(m, x)/before == Approx(part).epsilon(0.02).margin(0.005));
    }
    rm(getEnv("FOAM_CASE")/file);
}
