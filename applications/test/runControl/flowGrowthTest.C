/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "flowGrowth.H"

using namespace Foam;

namespace
{

//- Speed of a flow from rest whose records are many
scalar speedAt(const label step)
{
    return 1e-6*Foam::pow(scalar(1.02), step);
}

}

TEST_CASE("flowGrowth: a restart goes on as the run does", "[growth][serial]")
{
    flowGrowth run(0, 0);
    for (label step = 1; step <= 400; ++step)
    {
        run.add(1e-5*step, speedAt(step), 0);
    }

    for (const auto format : {IOstream::ASCII, IOstream::BINARY})
    {
        dictionary state;
        run.write(state);
        OStringStream os(format);
        state.write(os, false);
        IStringStream is(os.str(), format);
        flowGrowth restarted{dictionary(is)};
        flowGrowth goesOn(run);

        for (label step = 401; step <= 500; ++step)
        {
            const scalar growth = goesOn.add(1e-5*step, speedAt(step), 0);
            CHECK(growth > 1);
            CHECK(restarted.add(1e-5*step, speedAt(step), 0) == growth);
        }
    }
}


TEST_CASE("flowGrowth: a start that blows up is seen", "[growth][serial]")
{
    // Nearly doubled in every step: 8000 times as fast after fifteen
    flowGrowth run(0, 0);
    scalar most = 0;
    for (label step = 1; step <= 15; ++step)
    {
        most = max(most, run.add(1e-4*step, 1e-3*Foam::pow(1.9, step), 0));
    }
    CHECK(most > 30);

    // A constant force on a fluid at rest: the third step has three times the
    // velocity of the first
    flowGrowth start(0, 0);
    for (label step = 1; step <= 100; ++step)
    {
        CHECK(start.add(1e-4*step, 1e-3*step, 0) < 3.001);
    }
}
