/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondKinetics.H"
#include <cmath>

namespace
{
    //- Part of the rest length over which a bond tightens
    constexpr Foam::scalar tightening = 0.1;
}


Foam::scalar Foam::bondKinetics::tension(const scalar length) const
{
    const scalar c = tightening*values().restLength;
    const scalar s = max(length - values().restLength, scalar(0));
    return values().stiffness*(s < c ? sqr(s)/(2*c) : s - 0.5*c);
}


Foam::scalar Foam::bondKinetics::energy(const scalar length) const
{
    const scalar c = tightening*values().restLength;
    const scalar s = max(length - values().restLength, scalar(0));
    return
        values().stiffness
       *(s < c ? pow3(s)/(6*c) : 0.5*s*(s - c) + sqr(c)/6);
}


Foam::scalar Foam::bondKinetics::stiffness(const scalar length) const
{
    const scalar c = tightening*values().restLength;
    const scalar s = max(length - values().restLength, scalar(0));
    return values().stiffness*(s < c ? s/c : 1);
}


Foam::scalar Foam::bondKinetics::toBreak
(
    const scalar offRate,
    const scalar dt
) const
{
    return -std::expm1(-offRate*dt);
}


Foam::scalar Foam::bondKinetics::toForm
(
    const scalar offRate,
    const scalar dt
) const
{
    const scalar k = values().onRate + offRate;
    return k > 0 ? -values().onRate/k*std::expm1(-k*dt) : 0;
}


Foam::scalar Foam::bondKinetics::toFormAnew
(
    const scalar offRate,
    const scalar dt
) const
{
    const scalar q = toBreak(offRate, dt);
    const scalar k = values().onRate + offRate;
    return q > 0 ? max(1 + offRate/k*std::expm1(-k*dt)/q, scalar(0)) : 0;
}
