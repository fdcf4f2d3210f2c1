/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "timeStepControl.H"

using namespace Foam;

namespace
{

//- The time of the box with another controlDict and step, as long as it lives
class controlledTime
{
    dictionary& dict_;
    const dictionary before_;
    const scalar deltaT_;


public:

    controlledTime(const string& entries, const scalar deltaT)
    :
        dict_(const_cast<dictionary&>(testTime().controlDict())),
        before_(dict_),
        deltaT_(testTime().deltaTValue())
    {
        dict_.merge(dictOf(entries));
        testTime().setDeltaT(deltaT, false);

        // They would start with the change of the step
        testTime().functionObjects().off();
    }

    ~controlledTime()
    {
        dict_ = before_;
        testTime().setDeltaT(deltaT_, false);
        testTime().functionObjects().on();
    }
};

//- The next step in parts of the present one, of 1e-4 s
scalar next
(
    const string& limits,
    const scalar Courant,
    const scalar viscous,
    const scalar displacementRate = 0,
    const scalar shortening = 0
)
{
    const controlledTime time("adjustTimeStep yes;" + limits, 1e-4);
    timeStepControl control(testTime());
    control.measure(Courant, viscous, 12);
    control.adjust(displacementRate, shortening);
    return testTime().deltaTValue()/1e-4;
}

const string wide("maxCo 2; maxDisplacement 0.5;");

}

TEST_CASE("timeStepControl: every limit alone", "[timeStep][serial]")
{
    // Twice too large: halved at once
    CHECK(next(wide, 4, 0) == Approx(0.5));
    CHECK(next(wide, 0, 24) == Approx(0.5));
    CHECK(next(wide, 0, 0, 1e4) == Approx(0.5));
    CHECK(next(wide, 0, 0, 0, 2) == Approx(0.5));
    CHECK(next(wide + "maxDeltaT 5e-5;", 0, 0) == Approx(0.5));
    CHECK(next(wide + "maxViscousNumber 6;", 0, 12) == Approx(0.5));
}

TEST_CASE("timeStepControl: the tightest limit counts", "[timeStep][serial]")
{
    CHECK(next(wide, 8, 24, 1e4, 2) == Approx(0.25));
    CHECK(next(wide, 4, 48, 1e4, 2) == Approx(0.25));
    CHECK(next(wide, 4, 24, 2e4, 2) == Approx(0.25));
    CHECK(next(wide, 4, 24, 1e4, 4) == Approx(0.25));
    CHECK(next(wide + "maxDeltaT 1e-5;", 4, 24, 1e4, 2) == Approx(0.1));

    // maxDeltaT is no permission
    CHECK(next(wide + "maxDeltaT 1;", 8, 0) == Approx(0.25));
}

TEST_CASE("timeStepControl: growth", "[timeStep][serial]")
{
    CHECK(next(wide, 0, 0) == Approx(1.2));
    CHECK(next(wide, 2, 0) == Approx(1));
    CHECK(next(wide, 0.95*2, 0) == Approx(1/0.95));
    CHECK(next(wide, 0.8*2, 0) == Approx(1.125));

    // To the limit in steps that never pass it
    scalar dt = 1e-3;
    for (label i = 0; i < 50; ++i)
    {
        dt *= next(wide, 2*dt, 0);
        CHECK(dt <= 1 + 1e-12);
    }
    CHECK(dt == Approx(1));
}

TEST_CASE("timeStepControl: a step that is not adjusted", "[timeStep][serial]")
{
    const controlledTime time("adjustTimeStep no; maxDeltaT 1e-6;", 1e-4);
    timeStepControl control(testTime());
    CHECK(!control.adjusts());
    control.measure(100, 100, 12);
    control.adjust(1e9, 2);
    CHECK(testTime().deltaTValue() == 1e-4);
}

TEST_CASE("timeStepControl: the limit of PISO", "[timeStep][serial]")
{
    CHECK(timeStepControl::viscousLimit(true, 1) == GREAT);
    CHECK(timeStepControl::viscousLimit(false, 3) == 12);
    CHECK(timeStepControl::viscousLimit(false, 4) == 37);
}

TEST_CASE("timeStepControl: impossible entries", "[timeStep][serial]")
{
    for (const char* entry : {"maxCo 0;", "maxDisplacement -1;", "maxDeltaT 0;"})
    {
        INFO(entry);
        const controlledTime time(entry, 1e-4);
        CHECK_THROWS(timeStepControl(testTime()));
    }
}
