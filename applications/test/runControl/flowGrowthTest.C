/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "catch2/catch.hpp"
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
