/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "catch2/catch.hpp"
#include "testCase.H"
#include "effects.H"
#include "StringStream.H"

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


TEST_CASE("effects: time within another entry's counts once", "[effects][serial]")
{
    const auto work = []()
    {
        const auto start = std::chrono::steady_clock::now();
        while (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(20))
        {}
    };

    effects e{dictionary()};
    const auto start = std::chrono::steady_clock::now();
    {
        const effects::timer outer(e, "clumps");
        work();
        {
            const effects::timer inner(e, "contact");
            work();
        }
        work();
    }
    work();
    const scalar total = std::chrono::duration<double>
    (
        std::chrono::steady_clock::now() - start
    ).count();

    CHECK(e.seconds("contact") >= 0.02);
    CHECK(e.seconds("clumps") >= 0.04);
    CHECK(e.seconds("contact") + e.seconds("clumps") <= total - 0.02);
}


TEST_CASE("effects: only a fluid can be frozen", "[effects][serial]")
{
    CHECK(effects(dictOf("effects { fluid frozen; }")).frozen());
    CHECK(!effects(dictOf("effects { fluid on; }")).frozen());
    CHECK_THROWS(effects(dictOf("effects { contact frozen; }")));
}


TEST_CASE("effects: unknown names and values are refused", "[effects][serial]")
{
    CHECK_THROWS(effects(dictOf("effects { contacts off; }")));
    CHECK_THROWS(effects(dictOf("effects { contact of; }")));
}
