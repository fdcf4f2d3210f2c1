/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "sceneEffects.H"
#include "StringStream.H"

using namespace Foam;

TEST_CASE("effects: the user's word stands", "[effects][serial]")
{
    sceneEffects e(dictOf("effects { contact off; walls on; }"));

    e.decide("contact", true, "clumps are near");
    CHECK(!e.active("contact"));
    e.decide("walls", false, "none near");
    CHECK(e.active("walls"));
    e.decide("gravity", false, "equal densities");
    CHECK(!e.active("gravity"));
}


TEST_CASE("effects: the table gives the reasons", "[effects][serial]")
{
    sceneEffects e{dictionary()};
    e.decide("contact", false, "one clump in the domain");

    OStringStream table;
    e.print(table);
    CHECK_THAT
    (
        table.str(),
        Catch::Contains("contact: off, one clump in the domain")
    );
    CHECK(!e.takesPart("contact"));
    CHECK(e.takesPart("flow"));
}


TEST_CASE("effects: only a fluid can be frozen", "[effects][serial]")
{
    CHECK(sceneEffects(dictOf("effects { fluid frozen; }")).frozen());
    CHECK(!sceneEffects(dictOf("effects { fluid on; }")).frozen());
    CHECK_THROWS(sceneEffects(dictOf("effects { contact frozen; }")));
}


TEST_CASE("effects: unknown names and values are refused", "[effects][serial]")
{
    CHECK_THROWS(sceneEffects(dictOf("effects { contacts off; }")));
    CHECK_THROWS(sceneEffects(dictOf("effects { contact of; }")));
}
