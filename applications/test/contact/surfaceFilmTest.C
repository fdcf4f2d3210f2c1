/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCase.H"
#include "testCatch.H"
#include "mathematicalConstants.H"
#include "squeezeFilm.H"

using namespace Foam;

namespace
{

//- A film between surfaces in a gap with the given limit and roughness
struct surfaceFilm
{
    const gapModels::squeezeFilm law;
    const gapModel::layer between;
    const scalar dt;

    surfaceFilm
    (
        const scalar limit,
        const scalar roughness,
        const scalar mu,
        const scalar dt
    )
    :
        law(dictOf("type squeezeFilm;")),
        between({mu, limit, roughness}),
        dt(dt)
    {}

    contactModel::pressure step
    (
        const scalar gap, const scalar start, const scalar R
    ) const
    {
        return law.surfacePressure(gap, start, dt, R, between);
    }
};

}

TEST_CASE("film between surfaces: pressure and stiffness are derivatives of the potential",
    "[membrane][serial]")
{
    const surfaceFilm film(0.2, 0.02, 3, 0.5);
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
            const scalar p = -(up.energy - down.energy)/(2*h);
            const scalar k = -(up.value - down.value)/(2*h);
            CHECK(here.value == Approx(p).epsilon(1e-5).margin(1e-6));
            CHECK(here.stiffness == Approx(k).epsilon(1e-5).margin(1e-6));

            // It resists closing and opening, and takes energy from both
            CHECK(here.energy >= -1e-12);
            CHECK(here.value*(gap - start) <= 0);
            CHECK(here.stiffness >= 0);
        }
        CHECK(mag(film.step(start, start, R).value) < 1e-9);
    }
    CHECK(film.step(0.25, 0.3, R).value == 0);
}


TEST_CASE("film between surfaces: the impulse does not depend on the step", "[membrane][serial]")
{
    // In one step, and in two of other lengths
    const scalar R = 0.7;
    const surfaceFilm whole(0.2, 0.02, 3, 0.5), half(0.2, 0.02, 3, 0.1);
    const scalar impulse = 0.5*whole.step(0.03, 0.15, R).value;
    const scalar parts =
        0.5*whole.step(0.08, 0.15, R).value + 0.1*half.step(0.03, 0.08, R).value;
    CHECK(parts == Approx(impulse).epsilon(1e-12));
}


TEST_CASE("film between surfaces: the force on a sphere at a plane", "[membrane][serial]")
{
    // Lubrication theory: 6 pi mu R^2 V/g, here less the part that the mesh resolves,
    // which leaves (1 - g/g_c)^2 of it. Each ring of the sphere has the gap g + r^2/(2 R)
    const scalar R = 2, mu = 3, V = 0.1, dt = 1e-5, limit = 0.3;
    const surfaceFilm film(limit, 1e-4, mu, dt);
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
                film.step(gap - V*dt, gap, R).value
               *constant::mathematical::twoPi*r*end/n;
        }
        const scalar expected =
            6*constant::mathematical::pi*mu*sqr(R)*V/g*sqr(1 - g/limit);
        CHECK(force == Approx(expected).epsilon(1e-3));
    }
}
