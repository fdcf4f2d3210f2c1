/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceKernel.H"

const Foam::Enum<Foam::surfaceKernel::form> Foam::surfaceKernel::names
({
    { form::hat, "hat" },
    { form::threePoint, "threePoint" },
    { form::fourPoint, "fourPoint" },
});


Foam::surfaceKernel::surfaceKernel(const form f)
:
    form_(f),
    variance_(0),
    meanDistance_(0),
    overlap_(0)
{
    constexpr label nPlaces = 200;
    constexpr label reach = 3;

    // By the trapezoidal rule, from the middle
    beyond_ = scalarList(nPlaces + 1, 0.5);
    const scalar step = support()/nPlaces;
    for (label n = 0; n < nPlaces; ++n)
    {
        beyond_[n + 1] =
            beyond_[n] - 0.5*step*((*this)(n*step) + (*this)((n + 1)*step));
    }
    const scalar rest = beyond_.last();
    for (scalar& b : beyond_)
    {
        b = 0.5*(b - rest)/(0.5 - rest);
    }

    for (label n = 0; n < nPlaces; ++n)
    {
        const scalar y = (n + 0.5)/nPlaces;
        scalar J = 0;
        for (label c = reach; c >= -reach; --c)
        {
            const scalar K = (*this)(c - y);
            J += K;
            overlap_ += J*(1 - 0.5*(beyond(c - y) + beyond(c - 1 - y)))/nPlaces;
            variance_ += K*sqr(c - y)/nPlaces;
            for (label d = -reach; d <= reach; ++d)
            {
                meanDistance_ += K*(*this)(d - y)*mag(c - d)/nPlaces;
            }
        }
    }
}


Foam::surfaceKernel::surfaceKernel(const dictionary& dict)
:
    surfaceKernel(names.getOrDefault("kernel", dict, form::threePoint))
{}


Foam::scalar Foam::surfaceKernel::beyond(const scalar r) const
{
    const label last = beyond_.size() - 1;
    const scalar place = mag(r)/support()*last;
    scalar result = 0;
    if (place < last)
    {
        const label n = label(place);
        result = beyond_[n] + (place - n)*(beyond_[n + 1] - beyond_[n]);
    }
    return r < 0 ? 1 - result : result;
}


Foam::scalar Foam::surfaceKernel::deficit(const scalar ratio) const
{
    const label last = beyond_.size() - 1;
    scalar sum = 0;
    forAll(beyond_, n)
    {
        const scalar b = beyond_[n];
        const scalar outside = 1/(1 + (1/ratio - 1)*b);
        const scalar inside = 1/(1 + (1/ratio - 1)*(1 - b));
        const scalar part = n == 0 || n == last ? 0.5 : 1;
        sum += part*(1 + ratio - outside - inside);
    }
    return sum*support()/last;
}


Foam::scalar Foam::surfaceKernel::operator()(const scalar r) const
{
    const scalar a = mag(r);
    if (a >= support())
    {
        return 0;
    }
    switch (form_)
    {
        case form::hat:
            return 1 - a;

        case form::threePoint:
            return
                a < 0.5
              ? (1 + Foam::sqrt(1 - 3*sqr(a)))/3
              : (5 - 3*a - Foam::sqrt(max(1 - 3*sqr(1 - a), scalar(0))))/6;

        default:
            return
                a < 1
              ? (3 - 2*a + Foam::sqrt(1 + 4*a - 4*sqr(a)))/8
              : (5 - 2*a - Foam::sqrt(max(-7 + 12*a - 4*sqr(a), scalar(0))))/8;
    }
}
