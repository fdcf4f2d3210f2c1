/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "catch2/catch.hpp"
#include "testCase.H"
#include "effects.H"
#include "OStringStream.H"

using namespace Foam;

TEST_CASE("effects: the user's word stands", "[effects][serial]")
{
    effects e(dictOf("effects { contact off; walls on; }"));

    e.decide("contact", true, "clumps are near");
    CHECK(!e.active("contact"));
    e.decide("walls", false, "none near");
    CHECK(e.active("walls"));
    e.decide("gravity", false, "equal densities");
    CHECK(!e.active("gravity"));
}


TEST_CASE("effects: table and ledger say what happened", "[effects][serial]")
{
    effects e{dictionary()};
    e.decide("contact", false, "one clump in the domain");

    OStringStream table;
    e.printTable(table);
    CHECK_THAT
    (
        table.str(),
        Catch::Contains("contact: off, one clump in the domain")
    );

    {
        const effects::timer t(e, "clumps");
    }
    e.endStep();
    CHECK(e.calls("clumps") == 1);
    CHECK(e.calls("contact") == 0);
}


TEST_CASE("effects: unknown names and values are refused", "[effects][serial]")
{
    CHECK_THROWS(effects(dictOf("effects { contacts off; }")));
    CHECK_THROWS(effects(dictOf("effects { contact of; }")));
}
