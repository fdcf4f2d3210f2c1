/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactShares.H"

void Foam::contactShares::set
(
    UList<pair>& pairs,
    const UList<point>& xA,
    const UList<scalar>& rA,
    const UList<point>& xB,
    const UList<scalar>& rB
)
{
    for (pair& p : pairs)
    {
        scalar sum = 0;
        scalar depth = 0;

        for (const pair& q : pairs)
        {
            if (q.overlap <= 0)
            {
                continue;
            }
            const scalar W =
                kernel(xA[p.i], xA[q.i], rA[p.i], rA[q.i])
               *kernel(xB[p.j], xB[q.j], rB[p.j], rB[q.j]);

            sum += sqr(q.overlap)*W;
            depth = max(depth, q.overlap*Foam::sqrt(W));
        }
        if (p.overlap > 0)
        {
            p.share = sqr(p.overlap)/max(sum, VSMALL);
            p.depth = depth;
        }
        else
        {
            p.share = depth > 0 ? sqr(depth)/(sqr(depth) + sum) : 1;
            p.depth = p.overlap;
        }
    }
}


Foam::DynamicList<Foam::contactShares::wallContact>
Foam::contactShares::ofWalls
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
    shareWalls(result, x, r);
    return result;
}


Foam::DynamicList<Foam::contactShares::wallContact>
Foam::contactShares::filmsOfWalls
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
    shareWalls(result, x, r);
    return result;
}


void Foam::contactShares::shareWalls
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

    // Share of a sphere's contacts in a direction, and square of their overlap
    const auto sums = [&](const label k, const vector& n, scalar& share)
    {
        scalar overlap2 = 0;
        share = 0;
        for (label m = first[k]; m < first[k + 1]; ++m)
        {
            const wallSurface::contact& c = contacts[m].wall;
            const scalar s = c.share*sqr(max(n & c.normal, scalar(0)));
            share += s;
            overlap2 += s*sqr(c.overlap);
        }
        return overlap2;
    };

    for (wallContact& c : contacts)
    {
        scalar share;
        const scalar own = sums(c.i, c.wall.normal, share);
        const scalar mean2 = own/share;
        scalar sum = 0;
        scalar deepest = mean2;

        forAll(x, k)
        {
            if (first[k + 1] > first[k])
            {
                const scalar W2 = sqr(kernel(x[c.i], x[k], r[c.i], r[k]));
                const scalar G = sums(k, c.wall.normal, share)*W2;
                sum += G;
                deepest = max(deepest, G);
            }
        }
        c.share = c.wall.share*own/sum;
        c.depth = c.wall.overlap*Foam::sqrt(deepest/mean2);
    }
}


Foam::scalar Foam::contactShares::mass
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
        result += masses[k]*sqr(kernel(x[i], x[k], r[i], r[k]));
    }
    return result;
}
