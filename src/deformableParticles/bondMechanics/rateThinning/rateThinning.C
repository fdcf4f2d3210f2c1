/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "rateThinning.H"

Foam::rateThinning::rateThinning()
:
    rateThinning(1, GREAT, 1)
{}


Foam::rateThinning::rateThinning
(
    const scalar fraction,
    const scalar rate,
    const scalar exponent
)
:
    fraction_(fraction),
    rate_(rate),
    exponent_(exponent)
{}


Foam::scalar Foam::rateThinning::factor(const scalar s) const
{
    return fraction_ + (1 - fraction_)*Foam::pow(1 + s, 0.5*(exponent_ - 1));
}


Foam::scalar Foam::rateThinning::slope(const scalar s) const
{
    return
        0.5*(1 - fraction_)*(exponent_ - 1)
       *Foam::pow(1 + s, 0.5*(exponent_ - 3));
}


Foam::scalar Foam::rateThinning::mean(const scalar s) const
{
    if (s < SMALL)
    {
        return 1;
    }
    const scalar p = 0.5*(exponent_ + 1);
    return fraction_ + (1 - fraction_)*std::expm1(p*std::log1p(s))/(p*s);
}
