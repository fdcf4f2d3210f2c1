/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneFilm.H"

Foam::membraneFilm::membraneFilm()
:
    membraneFilm(0, 0, 0, 1)
{}


Foam::membraneFilm::membraneFilm
(
    const scalar limit,
    const scalar rough,
    const scalar mu,
    const scalar dt
)
:
    limit_(limit),
    rough_(min(rough, limit)),
    factor_(3*mu/dt)
{}


Foam::membraneFilm::integrals Foam::membraneFilm::at(const scalar gap) const
{
    const scalar g = min(max(gap, rough_), limit_);
    const scalar beyond = gap - g;
    const scalar c = gap < limit_ ? 1/sqr(g) - 1/sqr(limit_) : 0;
    const scalar C = -1/g - g/sqr(limit_);
    return
    {
        c,
        C + c*beyond,
        -Foam::log(g/limit_) - 0.5*sqr(g/limit_) + (C + 0.5*c*beyond)*beyond
    };
}


Foam::membraneFilm::response Foam::membraneFilm::step
(
    const scalar gap,
    const scalar start,
    const scalar R
) const
{
    if (limit_ <= 0 || R <= 0 || min(gap, start) >= limit_)
    {
        return {0, 0, 0};
    }
    const integrals from(at(start));
    const integrals to(at(gap));
    const scalar K = factor_*R;
    return
    {
        K*(to.sum - from.sum - from.C*(gap - start)), -K*(to.C - from.C), K*to.c
    };
}
