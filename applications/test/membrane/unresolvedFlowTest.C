/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testMembrane.H"
#include "unresolvedFlow.H"
#include "mathematicalConstants.H"
#include "Random.H"

using namespace Foam;

namespace
{

//- Of the forces on a surface of triangles, with its normals, for a viscosity of one
vectorField flowOf(const testMembrane& m, const vectorField& forces, const scalar variance)
{
    const pointField& x = m.type.centres();
    const vectorField S(m.type.surface().areaVectors(x));
    return unresolvedFlow(variance)
    (
        x, forces, S/mag(S), m.type.surface().nodeAreas(x), x.size()
    );
}

}


TEST_CASE
(
    "unresolvedFlow: waves of force on a plane, by Fourier's integrals",
    "[membrane][unresolvedFlow][serial]"
)
{
    // A hexagonal lattice of the distance one
    const scalar height = Foam::sqrt(0.75);
    DynamicList<point> x;
    label middle = -1;
    for (label i = -30; i <= 30; ++i)
    {
        for (label j = -36; j <= 36; ++j)
        {
            const point p(j + 0.5*(i % 2), height*i, 0);
            if (mag(p) < 26)
            {
                middle = i == 0 && j == 0 ? x.size() : middle;
                x.append(p);
            }
        }
    }
    const vectorField n(x.size(), vector(0, 0, 1));
    const scalarField areas(x.size(), height);

    const scalar v = 0.4;
    const scalar left = Foam::sqrt(v/constant::mathematical::pi);
    for (const scalar k : {0.4, 0.8, 1.5, 2.5})
    {
        vectorField F(x.size());
        forAll(F, i)
        {
            F[i] = vector::one*height*Foam::cos(k*x[i].x());
        }
        const vector u(unresolvedFlow(v)(x, F, n, areas, x.size())[middle]);

        const scalar y = k*Foam::sqrt(v);
        const scalar across = 0.5*Foam::erf(y)/k;
        const scalar normal =
        (
            0.5*sqr(y)*Foam::erfc(y)
          + 0.25*Foam::erf(y)
          - 0.5*y*Foam::exp(-sqr(y))/Foam::sqrt(constant::mathematical::pi)
        )/k;
        INFO("k " << k << " u " << u.x() << " " << u.y() << " " << u.z());

        // Of the whole velocity that the mesh lacks; the shortest waves have the length of
        // two and a half distances
        const scalar limit = k < 1 ? 0.03 : 0.25;
        CHECK(mag(u.z() - normal) < limit*normal);
        CHECK(mag(u.y() + left - across) < limit*across);
        CHECK(mag(u.x() + left - (across - normal)) < limit*(across - normal));
    }
}


TEST_CASE
(
    "unresolvedFlow: symmetry, work and the pressure of a sphere",
    "[membrane][unresolvedFlow][serial]"
)
{
    const testMembrane m
    (
        "a { type surfaceTension; tension 1; }",
        "type icosphere; radius 1; subdivisions 3;"
    );
    const vectorField S(m.type.surface().areaVectors(m.type.centres()));
    const scalarField areas(m.type.surface().nodeAreas(m.type.centres()));

    // Those of a pressure do not move an incompressible fluid
    const scalar v = 0.01;
    const vectorField still(flowOf(m, S, v));
    CHECK(max(mag(still)) < 0.02*Foam::sqrt(v));

    Random random(7);
    vectorField F(S.size());
    vectorField G(S.size());
    for (label n = 0; n < 5; ++n)
    {
        forAll(F, i)
        {
            F[i] = random.sample01<vector>() - vector::uniform(0.5);
            G[i] = random.sample01<vector>() - vector::uniform(0.5);
        }
        const vectorField u(flowOf(m, F, v));
        const vectorField w(flowOf(m, G, v));
        CHECK(mag(sum(F & w) - sum(G & u)) < 1e-12*sum(mag(F)*mag(u)));

        // With what membraneStep adds along the surface
        const vectorField along(F - S*(S & F)/magSqr(S));
        const scalar left = Foam::sqrt(v/constant::mathematical::pi);
        CHECK(sum(F & (u + left/areas*along)) > 0);
    }
}
