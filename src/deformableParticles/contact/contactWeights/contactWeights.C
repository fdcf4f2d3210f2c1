/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactWeights.H"
#include "nearPoints.H"

namespace
{

using namespace Foam;

//- Exponent beyond which a product of kernels is zero
constexpr scalar largestExponent = 74;

//- Distance [m] beyond which the kernel is below exp(-exponent)
scalar reach(const scalar r, const scalar largest, const scalar exponent)
{
    return 1.001*Foam::sqrt(exponent*r*largest);
}

}


Foam::label Foam::contactWeights::set
(
    UList<pair>& pairs,
    const UList<point>& xA,
    const UList<scalar>& rA,
    const UList<point>& xB,
    const UList<scalar>& rB
)
{
    DynamicList<label> touching;
    DynamicList<point> at;
    forAll(pairs, k)
    {
        if (pairs[k].overlap > 0)
        {
            touching.append(k);
            at.append(xA[pairs[k].i]);
        }
    }
    nearPoints near(at);
    const scalar largest = max(rA);
    label nKernels = 0;

    for (pair& p : pairs)
    {
        scalar sum = 0;
        scalar depth = 0;

        const scalar within = reach(rA[p.i], largest, largestExponent);
        for (const label k : near(xA[p.i], within))
        {
            const pair& q = pairs[touching[k]];
            const scalar exponentA = exponent(xA[p.i], xA[q.i], rA[p.i], rA[q.i]);
            const scalar exponentB = exponent(xB[p.j], xB[q.j], rB[p.j], rB[q.j]);
            if (exponentA + exponentB > largestExponent)
            {
                continue;
            }
            const scalar W = Foam::exp(-exponentA)*Foam::exp(-exponentB);
            ++nKernels;

            sum += sqr(q.overlap)*W;
            depth = max(depth, q.overlap*Foam::sqrt(W));
        }
        if (p.overlap > 0)
        {
            p.weight = sqr(p.overlap)/max(sum, VSMALL);
            p.depth = depth;
        }
        else
        {
            p.weight = depth > 0 ? sqr(depth)/(sqr(depth) + sum) : 1;
            p.depth = p.overlap;
        }
    }
    return nKernels;
}


Foam::DynamicList<Foam::contactWeights::wallContact>
Foam::contactWeights::findWallContacts
(
    const wallSurface& walls,
    const UList<label>& triangles,
    const UList<point>& x,
    const UList<scalar>& r
)
{
    DynamicList<wallContact> result;
    forAll(x, i)
    {
        for
        (
            const wallSurface::contact& c
          : walls.contacts(x[i], r[i], triangles)
        )
        {
            result.append({i, c, symmTensor::zero, 0, 0});
        }
    }
    setWallWeights(result, x, r);
    return result;
}


Foam::DynamicList<Foam::contactWeights::wallContact>
Foam::contactWeights::findWallFilms
(
    const wallSurface& walls,
    const UList<label>& triangles,
    const UList<point>& x,
    const UList<scalar>& r,
    const scalar range,
    const scalar reach
)
{
    DynamicList<wallContact> result;
    forAll(x, i)
    {
        for
        (
            const wallSurface::film& f
          : walls.films(x[i], r[i], range, reach, triangles)
        )
        {
            result.append({i, f.nearest, f.curvature, 0, 0});
        }
    }
    setWallWeights(result, x, r);
    return result;
}


Foam::label Foam::contactWeights::setWallWeights
(
    UList<wallContact>& contacts,
    const UList<point>& x,
    const UList<scalar>& r
)
{
    // Where the contacts of a sphere begin
    labelList first(x.size() + 1, Zero);
    for (const wallContact& c : contacts)
    {
        ++first[c.i + 1];
    }
    forAll(x, i)
    {
        first[i + 1] += first[i];
    }

    // Squares and fourth powers of the overlaps of a sphere in a direction
    const auto sums = [&](const label k, const vector& n, scalar& overlap4)
    {
        scalar overlap2 = 0;
        overlap4 = 0;
        for (label m = first[k]; m < first[k + 1]; ++m)
        {
            const wallSurface::contact& c = contacts[m].wall;
            const scalar s = c.weight*sqr(max(n & c.normal, scalar(0)));
            overlap2 += s*sqr(c.overlap);
            overlap4 += s*pow4(c.overlap);
        }
        return overlap2;
    };

    DynamicList<label> touching;
    DynamicList<point> at;
    forAll(x, k)
    {
        if (first[k + 1] > first[k])
        {
            touching.append(k);
            at.append(x[k]);
        }
    }
    nearPoints near(at);
    const scalar largest = max(r);
    label nKernels = 0;

    for (wallContact& c : contacts)
    {
        scalar own4, other4;
        const scalar own = sums(c.i, c.wall.normal, own4);
        const scalar mean2 = own4/own;
        scalar sum = 0;
        scalar deepest = mean2;

        const scalar within = reach(r[c.i], largest, 0.5*largestExponent);
        for (const label m : near(x[c.i], within))
        {
            const label k = touching[m];
            const scalar e = exponent(x[c.i], x[k], r[c.i], r[k]);
            if (2*e > largestExponent)
            {
                continue;
            }
            const scalar G =
                sums(k, c.wall.normal, other4)*sqr(Foam::exp(-e));
            ++nKernels;
            sum += G;
            deepest = max(deepest, G);
        }
        c.weight = c.wall.weight*own/sum;
        c.depth = c.wall.overlap*Foam::sqrt(deepest/mean2);
    }
    return nKernels;
}


Foam::scalar Foam::contactWeights::mass
(
    const label i,
    const UList<point>& x,
    const UList<scalar>& r,
    const UList<scalar>& masses
)
{
    scalar result = 0;
    forAll(x, k)
    {
        const scalar e = exponent(x[i], x[k], r[i], r[k]);
        if (2*e <= largestExponent)
        {
            result += masses[k]*sqr(Foam::exp(-e));
        }
    }
    return result;
}
