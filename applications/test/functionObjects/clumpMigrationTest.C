/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "clumpMigration.H"

using namespace Foam;
using functionObjects::clumpMigration;
using functionObjects::pathWindow;

TEST_CASE("migration: velocities of a straight path", "[tables][serial]")
{
    // Steps that are much shorter than the window, about as long, and longer
    const scalar dt = GENERATE(1e-5, 3e-3, 0.7, 5.0);
    const scalar window = 1;
    pathWindow path;
    path.add(vector(0, 3, -2), window);
    CHECK(std::isnan(path.along()));
    CHECK_FALSE(path.full(window));

    for (label n = 1; n*dt < 3; ++n)
    {
        path.add(vector(n*dt, 3 + 2*n*dt, -2 - 1e-4*n*dt), window);
    }
    path.add(vector(20, 43, -2 - 2e-3), window);
    CHECK(path.along() == Approx(2));
    CHECK(path.across() == Approx(-1e-4));
    CHECK(path.begin() == vector(0, 3, -2));
    CHECK(path.full(window));
}


TEST_CASE("migration: the window forgets what was before it", "[tables][serial]")
{
    const scalar window = 0.5;
    const scalar dt = 1e-3;
    pathWindow path;
    for (label n = 0; n <= 2000; ++n)
    {
        // It turns at t = 1
        path.add(vector(n*dt, n*dt, mag(n*dt - 1)), window);
        if (n == 499)
        {
            CHECK_FALSE(path.full(window + 0.01));
        }
        if (n == 1000)
        {
            CHECK(path.across() == Approx(-1));
        }
    }
    CHECK(path.across() == Approx(1));
    CHECK(path.state().size() < 130);
    CHECK(path.last() == vector(2, 2, 1));
}


TEST_CASE("migration: an oscillation averages out over its periods", "[tables][serial]")
{
    pathWindow path;
    for (label n = 0; n <= 4000; ++n)
    {
        const scalar t = 1e-3*n;
        path.add(vector(t, t, 0.1*t + 0.01*std::sin(50*t)), 3);
    }
    CHECK(path.across() == Approx(0.1).epsilon(0.01));
}


TEST_CASE("migration: a restart continues a path", "[tables][serial]")
{
    pathWindow whole, first;
    const auto point = [](const label n)
    {
        const scalar t = 0.01*n;
        return vector(t, t*t, std::exp(-t));
    };
    for (label n = 0; n < 150; ++n)
    {
        whole.add(point(n), 1);
        first.add(point(n), 1);
    }
    pathWindow second(first.state());
    for (label n = 150; n < 220; ++n)
    {
        whole.add(point(n), 1);
        second.add(point(n), 1);
    }
    CHECK(whole.state() == second.state());
    CHECK(whole.across() == second.across());
}


TEST_CASE("migration: modes among posts", "[tables][serial]")
{
    CHECK(clumpMigration::mode(1.1, 10, 10) == "displaced");
    CHECK(clumpMigration::mode(0.5, 10, 10) == "between");
    CHECK(clumpMigration::mode(0, 12, 10) == "withFlow");
    CHECK(clumpMigration::mode(-0.2, 10, 10) == "withFlow");

    // It may not have met the post yet that lets it cross
    const scalar displacement = GENERATE(1.0, 0.5, 0.0, -3.0);
    CHECK(clumpMigration::mode(displacement, 9.9, 10) == "undecided");
}


TEST_CASE("migration: with the flow among posts at any time", "[tables][serial]")
{
    // Along a row for nine periods, then across it in one: withFlow over whole tens of
    // periods, and never displaced
    const scalar e = 0.1;
    pathWindow path;
    for (label n = 0; n <= 3000; ++n)
    {
        const scalar x = 0.01*n;
        const scalar way = std::fmod(x, 10);
        path.add(vector(x, x, way < 9 ? -e*way : -0.9 + 0.9*(way - 9)), 12);
        if (n > 1)
        {
            const word mode
            (
                clumpMigration::mode
                (
                    -path.inclination(path.way() < 1/e ? GREAT : 1/e)/e,
                    path.way(), 1/e
                )
            );
            INFO(x << ' ' << mode);
            REQUIRE(mode == (path.way() < 1/e ? "undecided" : "withFlow"));
        }
    }
}
