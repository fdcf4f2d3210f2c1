/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testMembrane.H"
#include "equilibrium.H"
#include "membraneEquilibrium.H"

using namespace Foam;

namespace
{

const string capsule
(
    "a { type skalak; shearModulus 2; areaRatio 3; }"
    " b { type helfrich; bendingStiffness 0.01; }"
);

//- Largest of the forces that are left on the nodes, over the largest load; the pressure
//  is the one that leaves least
scalar left(const testMembrane& m, const pointField& x, const vectorField& f)
{
    const vectorField S(m.type.surface().areaVectors(x));
    const vectorField sum0(m.mechanics.forces(x) + f);
    const scalar p = -sum(sum0 & S)/sum(S & S);
    return max(mag(sum0 + p*S))/max(mag(f));
}

scalar length(const pointField& x)
{
    const scalarField along(x.component(vector::X));
    return max(along) - min(along);
}

}


TEST_CASE("membraneEquilibrium: the forces balance", "[membrane][serial]")
{
    const string shape = GENERATE
    (
        "type icosphere; radius 1; subdivisions 2;",
        "type biconcave; diameter 2; subdivisions 2;"
    );
    INFO(shape);
    const testMembrane m(capsule, shape);
    const membraneEquilibrium solver(m.type, m.dict);

    // The bending changes the biconcave shape. Then small forces, and some that make it
    // half as long again or more
    const vectorField none(m.type.size(), Zero);
    pointField x(m.type.centres());
    REQUIRE(solver.find(none, x));
    const scalar atRest = length(x);
    for (const scalar F : {0.1, 1.0, 5.0})
    {
        const vectorField f(equilibrium::stretch(m.type, vector(F, 0, 0), 0.02).f);
        REQUIRE(solver.find(f, x));
        CHECK(left(m, x, f) < 1e-3);
        CHECK(m.type.surface().volume(x) == Approx(m.type.volume()).epsilon(1e-9));
    }
    CHECK(length(x) > 1.4*atRest);

    // The same from the shape at rest, and back to it
    const vectorField f(equilibrium::stretch(m.type, vector(5, 0, 0), 0.02).f);
    pointField y(m.type.centres());
    REQUIRE(solver.find(f, y));
    CHECK(length(y) == Approx(length(x)).epsilon(1e-3));
    REQUIRE(solver.find(none, x));
    CHECK(length(x) == Approx(atRest).epsilon(1e-3));
}


TEST_CASE("membraneEquilibrium: nodes that are pulled", "[membrane][serial]")
{
    const testMembrane m(capsule, "type icosphere; radius 1; subdivisions 2;");
    for (const scalar part : {0.0, 0.02, 0.1})
    {
        const externalForces ext
        (
            equilibrium::stretch(m.type, vector(0, 3, 0), part)
        );
        label nPulled = 0;
        scalar outermost = GREAT;
        forAll(ext.f, i)
        {
            if (ext.f[i].y() > 0)
            {
                ++nPulled;
                outermost = min(outermost, m.type.centres()[i].y());
            }
        }
        CHECK(nPulled >= max(label(part*m.type.size() + 0.5), label(1)));
        CHECK(sum(max(ext.f & vector(0, 1, 0), scalar(0))) == Approx(3));
        CHECK(mag(sum(ext.f)) < 1e-12);

        // None is further out than those
        forAll(ext.f, i)
        {
            const bool pulled = ext.f[i].y() > 0;
            CHECK(pulled == (m.type.centres()[i].y() > outermost - 1e-6));
        }
    }
}
