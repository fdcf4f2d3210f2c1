/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "timeBreakdown.H"
#include "StringStream.H"

using namespace Foam;

TEST_CASE("timing: calls and steps are counted", "[timing][serial]")
{
    timeBreakdown e;
    {
        const timeBreakdown::timer t(e, "clumps");
    }
    e.endStep([](const char* part) { return std::string(part) != "contact"; });
    CHECK(e.calls("clumps") == 1);
    CHECK(e.calls("contact") == 0);

    OStringStream table;
    e.print(table, 1);
    CHECK_THAT
    (
        table.str(),
        Catch::Matches("(.|\\n)*clumps +1 +1 (.|\\n)*contact +0 +0 (.|\\n)*")
    );
}


TEST_CASE("timing: time within another part counts once", "[timing][serial]")
{
    const auto work = []()
    {
        const auto start = std::chrono::steady_clock::now();
        while (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(20))
        {}
    };

    timeBreakdown e;
    const auto start = std::chrono::steady_clock::now();
    {
        const timeBreakdown::timer outer(e, "clumps");
        work();
        {
            const timeBreakdown::timer inner(e, "contact");
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
