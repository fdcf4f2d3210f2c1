/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "mathematicalConstants.H"
#include "membraneFilm.H"

using namespace Foam;

TEST_CASE("membraneFilm: pressure and stiffness are derivatives of the potential",
    "[membrane][serial]")
{
    const membraneFilm film(0.2, 0.02, 3, 0.5);
    const scalar R = 0.7;
    for (const scalar start : {0.01, 0.05, 0.19, 0.3})
    {
        for (const scalar gap : {-0.1, 0.015, 0.03, 0.12, 0.25})
        {
            INFO(start << " to " << gap);
            const scalar h = 1e-6;
            const auto here = film.step(gap, start, R);
            const auto up = film.step(gap + h, start, R);
            const auto down = film.step(gap - h, start, R);
            CHECK(here.p == Approx(-(up.w - down.w)/(2*h)).epsilon(1e-5).margin(1e-6));
            CHECK(here.k == Approx(-(up.p - down.p)/(2*h)).epsilon(1e-5).margin(1e-6));

            // It resists closing and opening, and takes energy from both
            CHECK(here.w >= -1e-12);
            CHECK(here.p*(gap - start) <= 0);
            CHECK(here.k >= 0);
        }
        CHECK(mag(film.step(start, start, R).p) < 1e-9);
    }
    CHECK(film.step(0.25, 0.3, R).p == 0);
    CHECK(membraneFilm().step(-1, 1, R).p == 0);
}


TEST_CASE("membraneFilm: the impulse does not depend on the step", "[membrane][serial]")
{
    // In one step, and in two of other lengths
    const scalar R = 0.7;
    const membraneFilm whole(0.2, 0.02, 3, 0.5), half(0.2, 0.02, 3, 0.1);
    const scalar impulse = 0.5*whole.step(0.03, 0.15, R).p;
    const scalar parts =
        0.5*whole.step(0.08, 0.15, R).p + 0.1*half.step(0.03, 0.08, R).p;
    CHECK(parts == Approx(impulse).epsilon(1e-12));
}


TEST_CASE("membraneFilm: the force on a sphere at a plane", "[membrane][serial]")
{
    // Lubrication theory: 6 pi mu R^2 V/g, here less the part that the mesh resolves,
    // which leaves (1 - g/g_c)^2 of it. Each ring of the sphere has the gap g + r^2/(2 R)
    const scalar R = 2, mu = 3, V = 0.1, dt = 1e-5, limit = 0.3;
    const membraneFilm film(limit, 1e-4, mu, dt);
    for (const scalar g : {0.01, 0.1, 0.25})
    {
        scalar force = 0;
        const label n = 20000;
        const scalar end = Foam::sqrt(2*R*limit);
        for (label k = 0; k < n; ++k)
        {
            const scalar r = end*(k + 0.5)/n;
            const scalar gap = g + sqr(r)/(2*R);
            force +=
                film.step(gap - V*dt, gap, R).p
               *constant::mathematical::twoPi*r*end/n;
        }
        const scalar expected =
            6*constant::mathematical::pi*mu*sqr(R)*V/g*sqr(1 - g/limit);
        CHECK(force == Approx(expected).epsilon(1e-3));
    }
}
