/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCloud.H"
#include "givenRotation.H"

using namespace Foam;

namespace
{

// Across the processors of 2 and of 4, off the faces of the mesh; the edge of a mesh cell
// is 1 um
const point centre(10.3e-6, 9.8e-6, 10.1e-6);
const scalar width = 1e-6;

const char* types =
    "types"
    "{"
    "    bead { shape { type chain; nSpheres 1; sphereRadius 2.5e-6; } density 1100; }"
    "    capsule"
    "    {"
    "        shape { type icosphere; radius 3e-6; subdivisions 2; }"
    "        density 1100;"
    "        membrane { a { type neoHookean; shearModulus 1e-6; } }"
    "    }"
    "}";

//- A cloud with clumps in a fluid that feels them or does not
autoPtr<openCloud> cloudOf(const string& clumps, const bool coupled)
{
    dictionary dict
    (
        dictOf
        (
            string(types) + "placement { type list; clumps (" + clumps + "); }"
          + "effects { fluid on; feedback " + (coupled ? "on" : "off") + "; }"
        )
    );
    dict.subDict("types").add("cell", cellDict());
    if (!coupled)
    {
        dict.subDict("types").remove("capsule");
    }
    return autoPtr<openCloud>(new openCloud(testMesh(), dict));
}

//- U = v + G . (x - centre)
volVectorField flowOf(const vector& v, const tensor& G)
{
    volVectorField U
    (
        IOobject("testU", testTime().timeName(), testMesh()), testMesh(),
        dimensionedVector("U", dimVelocity, v)
    );
    forAll(U, celli)
    {
        U[celli] += G & (testMesh().C()[celli] - centre);
    }
    U.correctBoundaryConditions();
    return U;
}

//- The state of the clump of a number, on all processors
clumpState stateOf(const openCloud& cloud, const label number)
{
    clumpState result;
    for (const clumpParcel& p : cloud)
    {
        if (p.origId() == number)
        {
            result = p.state();
            result.x = p.centres();
        }
    }
    return result;
}

}


TEST_CASE("start: placed and injected clumps start with the flow", "[cloud][parallel]")
{
    const word type = GENERATE("bead", "cell", "capsule");
    const label flow = GENERATE(0, 1, 2);
    const bool coupled = GENERATE(true, false);
    if (type == "capsule" && !coupled)
    {
        return;
    }
    INFO(type << " flow " << flow << " coupled " << coupled);

    // Uniform, a solid rotation, and a shear
    const scalar rate = flow > 0 ? 200 : 0;
    const vector v(1e-3, 2e-4, -3e-4);
    const tensor G
    (
        flow == 2
      ? tensor(0, rate, 0, 0, 0, 0, 0, 0, 0)
      : tensor(0, -rate, 0, rate, 0, 0, 0, 0, 0)
    );
    const volVectorField U(flowOf(v, G));

    OStringStream place;
    place.precision(15);
    place
        << "{ type " << type << "; position " << centre << "; axis (1 1 0); angle 30; }";
    auto placed = cloudOf(place.str(), coupled);
    placed->startWithFlow(const_cast<volVectorField&>(U), uniformViscosity());

    // Another one is there before
    const vector own(0, 0, 1e-5);
    auto injected = cloudOf
    (
        "{ type bead; position (2.5e-6 3e-6 2.5e-6); velocity (0 0 1e-5); }", coupled
    );
    const label typeId = injected->typeIds()[type];
    injected->inject
    (
        newClump
        (
            injected->types()[typeId], typeId, centre,
            givenRotation(dictOf("axis (1 1 0); angle 30;"))
        ),
        7, U
    );

    const clumpState a(stateOf(*placed, 0)), b(stateOf(*injected, 7));
    CHECK(returnReduce(a.x.size(), sumOp<label>()) > 0);
    REQUIRE(a.x.size() == b.x.size());
    CHECK(a.x == b.x);
    CHECK(a.u == b.u);
    CHECK(a.w == b.w);
    if (a.x.size())
    {
        const clumpType& ct = placed->types()[typeId];
        CHECK(mag(a.velocity(ct) - v) < 1e-9*mag(v) + 0.03*rate*width);
    }

    // The one that was there keeps its own
    const clumpState other(stateOf(*injected, 0));
    if (other.u.size())
    {
        CHECK(other.u[0] == own);
    }
}
