/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    The models of this folder, each as a user's own library has it: what they are for.
    The tests of their families have cubicBond, hookeSheet and smoothFraction, too.
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "contact/touchingClumps.H"
#include "load.H"
#include "membrane/testMembrane.H"
#include "contactModel.H"
#include "mathematicalConstants.H"
#include "nodeFlow.H"

using namespace Foam;

namespace
{

const scalar pi = constant::mathematical::pi;

const string layer("modulus 100; thickness 1e-6;");

//- A bead of 2 um, a ring and a capsule of 3 um with the elastic layer, in the test box,
//  whose mesh cells are 1 um wide and whose walls are at y = 0 and 20 um
autoPtr<openCloud> scene(const string& clumps, const bool wet)
{
    const string law("{ type elasticLayer; " + layer + " }");
    return autoPtr<openCloud>
    (
        new openCloud
        (
            testMesh(),
            dictOf
            (
                "types"
                "{"
                "    bead { shape { type chain; nSpheres 1; sphereRadius 2e-6; }"
                "        density 1000; }"
                "    ring { shape { type ring; nSpheres 12; ringRadius 2e-6;"
                "        sphereRadius 1e-6; } density 1000; bondModel { type elastic;"
                "        rigidities { normal 1e-9; tangential 1e-9; bending 1e-22;"
                "        torsional 1e-22; } } dampingModel { type none; } }"
              + string
                (
                    wet
                  ? "    capsule"
                    "    {"
                    "        shape { type icosphere; radius 3e-6; subdivisions 4; }"
                    "        density 1000;"
                    "        membrane { a { type neoHookean; shearModulus 1e-6; } }"
                    "    }"
                  : ""
                )
              + "}"
                "placement { type list; clumps (" + clumps + "); }"
                "contactModel " + law + "wallContactModel " + law
              + "membraneContact " + law
              + (wet ? "effects { fluid on; }" : "effects { fluid off; }")
            )
        )
    );
}

//- Force of contact on the first clump [N]
vector forceOn(openCloud& cloud, const bool wet)
{
    if (wet)
    {
        cloud.immerse(uniformViscosity(), true);
    }
    else
    {
        cloud.evolve();
        cloud.accept();
    }
    vector result(Zero);
    for (const clumpParcel& p : cloud)
    {
        if (p.origId() == 0)
        {
            result += sum(wet ? nodesOf(p).force : p.step().forces.f);
        }
    }
    reduce(result, sumOp<vector>());
    return result;
}

}


TEST_CASE("examples: a contact law acts on beads, rings, capsules and walls",
    "[examples][contact][membrane]")
{
    struct row
    {
        const char* clumps;
        bool wet;
        scalar overlap;     // [m]; of membranes that of the range, half a mesh cell
        // Reduced radius [m]. The surface of a sphere a has 2 pi a rho drho/D at the
        // distance rho from the centre of a sphere b: a (b + gap)/D with the mean gap
        scalar R;
        vector away;
        scalar error;
    };
    const row r = GENERATE
    (
        row
        {
            "{ type bead; position (7e-6 10e-6 10e-6); }"
            "{ type bead; position (10.8e-6 10e-6 10e-6); }",
            false, 0.2e-6, 1e-6, vector(-1, 0, 0), 1e-3
        },
        row
        {
            "{ type bead; position (10e-6 1.8e-6 10e-6); }",
            false, 0.2e-6, 2e-6, vector(0, 1, 0), 1e-3
        },
        row
        {
            "{ type bead; position (7e-6 10e-6 10e-6); }"
            "{ type ring; position (11.8e-6 10e-6 10e-6); }",
            false, 0.2e-6, 2e-6/3, vector(-1, 0, 0), 0.03
        },
        row
        {
            "{ type capsule; position (7e-6 10e-6 10e-6); }"
            "{ type capsule; position (13.2e-6 10e-6 10e-6); }",
            true, 0.3e-6, 3e-6*3.3/6.2, vector(-1, 0, 0), 0.02
        },
        row
        {
            "{ type capsule; position (7e-6 10e-6 10e-6); }"
            "{ type bead; position (12.2e-6 10e-6 10e-6); }",
            true, 0.3e-6, 3e-6*2.3/5.2, vector(-1, 0, 0), 0.02
        },
        row
        {
            "{ type capsule; position (10e-6 3.2e-6 10e-6); }",
            true, 0.3e-6, 3e-6, vector(0, 1, 0), 0.02
        }
    );
    INFO(r.clumps);
    const givenStep step(1e-8);
    auto cloud = scene(r.clumps, r.wet);
    const vector force(forceOn(*cloud, r.wet));

    const scalar expected = pi*r.R*100/1e-6*sqr(r.overlap);
    CHECK((force & r.away)/expected == Approx(1).epsilon(r.error));
    CHECK(mag(force - (force & r.away)*r.away) < 0.02*expected);
}


TEST_CASE("examples: a contact law gives membranes the pressure of the layer",
    "[examples][contact][serial]")
{
    const auto law
    (
        selectModel<contactModel>(dictOf("type elasticLayer; " + layer))
    );
    const scalar d = 0.3e-6;
    const auto p = law->surfacePressure(d, GENERATE(1e-6, 4e-6));
    CHECK(p.value == Approx(100*d/1e-6));
    CHECK(p.stiffness == Approx(100/1e-6));
    CHECK(p.energy == Approx(50*sqr(d)/1e-6));
    CHECK(law->surfacePressure(-d, 1e-6).value == 0);
}


TEST_CASE("examples: a sheet of Hooke has its moduli", "[examples][membrane][serial]")
{
    // Stretched alike in all directions, with the tension T = Gs (1 + nu)/(1 - nu) (l^2 - 1):
    // of a surface that is scaled, the area grows with the square of the size
    const testMembrane m("a { type hookeSheet; shearModulus 2; poissonRatio 0.3; }");
    for (const scalar stretch : {0.9, 1.2})
    {
        const pointField x(stretch*m.type.centres());
        const scalar T = 2*1.3/0.7*(sqr(stretch) - 1);
        CHECK
        (
            sum(x & m.mechanics.forces(x)) == Approx(-2*T*m.type.surface().area(x))
        );
    }
}


TEST_CASE("examples: a load swings a bead", "[examples][serial]")
{
    const scalar t = 1.3e-6;
    const auto load
    (
        selectModel<Foam::load>
        (
            dictOf
            (
                "type swingingForce; clumpType test; amplitude (0 3e-12 0);"
                "frequency " + Foam::name(0.25/t) + ";"
            )
        )
    );
    const clumpType type("test", cellDict());
    testTime().setTime(t, testTime().timeIndex());
    externalForces ext(type.size());
    load->add({testMesh(), type, clumpState(), type.centres(), vectorField()}, ext);
    testTime().setTime(0, 0);

    // A quarter of a period: the whole amplitude, and every sphere by its mass
    CHECK(mag(sum(ext.f) - vector(0, 3e-12, 0)) < 1e-20);
    CHECK(mag(ext.f[0]/type.masses()[0] - ext.f[3]/type.masses()[3]) < 1e-6);
}
