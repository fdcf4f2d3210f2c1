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


Foam::scalar Foam::surfaceKernel::twice(const scalar r) const
{
    constexpr label nPlaces = 200;
    const scalar step = 2*support()/nPlaces;
    scalar sum = 0;
    for (label n = 0; n < nPlaces; ++n)
    {
        const scalar s = (n + 0.5)*step - support();
        sum += step*(*this)(s)*(*this)(r - s);
    }
    return sum;
}


Foam::surfaceKernel::plane Foam::surfaceKernel::planeAt(const bool angle) const
{
    constexpr label nPlaces = 200;
    constexpr label reach = 5;
    const scalar spacing = angle ? Foam::sqrt(0.5) : 1;

    plane result{0, 0, 0};
    FixedList<scalar, 2*reach + 1> W;
    for (label n = 0; n < nPlaces; ++n)
    {
        const scalar y = (n + 0.5)/nPlaces;
        for (label c = -reach; c <= reach; ++c)
        {
            W[c + reach] = angle ? twice(c - y) : (*this)(c - y);
        }
        scalar J = 0;
        for (label c = reach; c >= -reach; --c)
        {
            const scalar d = spacing*(c - y);
            const scalar part = W[c + reach]*spacing/nPlaces;
            J += W[c + reach];
            result.correlation +=
                J*(1 - 0.5*(beyond(d) + beyond(d - spacing)))*spacing/nPlaces;
            result.variance += part*sqr(d)/spacing;
            for (label e = -reach; e <= reach; ++e)
            {
                result.meanDistance += part*W[e + reach]*mag(c - e);
            }
        }
    }
    return result;
}


Foam::surfaceKernel::surfaceKernel(const form f)
:
    form_(f)
{
    constexpr label nPlaces = 200;

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
    along_ = planeAt(false);
    at45_ = planeAt(true);
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


Foam::scalar Foam::surfaceKernel::oblique(const vector& n)
{
    return 2*(1 - magSqr(cmptMultiply(n, n)));
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
