/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

//- Part of the force of an unbounded plane at a height h that comes from within
//  the distance s of the centre
scalar weightWithin(const scalar s, const scalar h, const scalar r)
{
    if (s >= r)
    {
        return 1;
    }
    const scalar e = (r - s)/max(r - h, VSMALL);
    return 1 - h/s*e*Foam::sqrt(e);
}


//- Integral of weightWithin over the angle at the foot of the centre, along a
//  line that passes the foot at a distance p, from its nearest point to t
scalar angleWeight
(
    const scalar t,
    const scalar p,
    const scalar h,
    const scalar r
)
{
    // Gauss points of eight in [0, 1], twice
    static const scalar x[] =
    {
        0.183434642495650, 0.525532409916329, 0.796666477413627,
        0.960289856497536
    };
    static const scalar w[] =
    {
        0.362683783378362, 0.313706645877887, 0.222381034453374,
        0.101228536290376
    };

    const scalar length = mag(t);
    const scalar chord2 = sqr(r) - sqr(h) - sqr(p);
    const scalar within =
        chord2 > 0 ? min(length, Foam::sqrt(chord2)) : scalar(0);

    // Outside the sphere all lies within
    scalar result = std::atan2(length, p);
    if (within <= 0)
    {
        return t < 0 ? -result : result;
    }
    result -= std::atan2(within, p);

    // t = p sinh(v) takes the peak at the foot out
    const scalar half = 0.25*std::asinh(within/p);
    for (const label part : {1, 3})
    {
        for (label k = 0; k < 4; ++k)
        {
            for (const scalar at : {part - x[k], part + x[k]})
            {
                const scalar c = std::cosh(half*at);
                const scalar s = Foam::sqrt(sqr(h) + sqr(p*c));
                result += half*w[k]*weightWithin(s, h, r)/c;
            }
        }
    }

    return t < 0 ? -result : result;
}


//- Add a piece of a plane to the piece of the same plane and patch, if there is one. The
//  plane moves as the piece that is nearest to the sphere, at this distance [m]
void addPiece
(
    const wallSurface::contact& piece,
    const scalar distance,
    const scalar tolerance,
    DynamicList<wallSurface::contact>& planes,
    DynamicList<scalar>& distances
)
{
    forAll(planes, k)
    {
        wallSurface::contact& other = planes[k];
        if
        (
            other.patch == piece.patch
         && mag(other.normal - piece.normal) < 1e-6
         && mag(other.overlap - piece.overlap) < tolerance
        )
        {
            other.weight += piece.weight;
            if (distance < distances[k])
            {
                other.moved = piece.moved;
                distances[k] = distance;
            }
            return;
        }
    }
    planes.append(piece);
    distances.append(distance);
}

}


Foam::scalar Foam::wallSurface::edgeWeight
(
    const vector& a,
    const vector& b,
    const vector& normal,
    const scalar height,
    const scalar r
)
{
    const scalar length = mag(b - a);
    if (length < 1e-12*r)
    {
        return 0;
    }
    const vector along((b - a)/length);
    const scalar side = (a ^ along) & normal;
    const scalar p = mag(side);
    if (p <= 1e-9*r)
    {
        return 0;
    }
    const scalar from = a & along;
    const scalar to = b & along;

    // Outside the sphere, all of the force lies within
    const scalar chord2 = sqr(r) - sqr(height) - sqr(p);
    const bool outside =
        chord2 <= 0 || (from*to > 0 && min(sqr(from), sqr(to)) >= chord2);

    return sign(side)
       *(
            outside
          ? std::atan2(to, p) - std::atan2(from, p)
          : angleWeight(to, p, height, r) - angleWeight(from, p, height, r)
        );
}


Foam::DynamicList<Foam::wallSurface::facet> Foam::wallSurface::touching
(
    const point& x,
    const scalar radius,
    const UList<label>& triangles,
    bool& behind
) const
{
    DynamicList<facet> facets;

    // Is the centre behind the wall? If several triangles have the same nearest
    // point (on an edge or a corner), the one whose plane is farthest from the
    // centre decides
    scalar nearest = radius;
    scalar side = 0;

    for (const label t : triangles)
    {
        const vector& out = out_[t];
        const triPointRef piece(triangle(t));
        const scalar height = (piece.a() - x) & out;
        if
        (
            mag(height) >= radius || out == vector::zero
         || magSqr(boxes_[t].nearest(x) - x) >= sqr(radius)
        )
        {
            continue;
        }
        const scalar gap = piece.nearestPoint(x).distance();
        if (gap >= radius)
        {
            continue;
        }
        facets.append({t, out, height});

        if (gap < nearest - 1e-9*radius)
        {
            nearest = gap;
            side = height;
        }
        else if
        (
            gap < nearest + 1e-9*radius
         && mag(height) > mag(side)*(1 - sign(height)*1e-9)
        )
        {
            side = height;
        }
    }
    behind = side < -1e-9*radius;
    return facets;
}


Foam::DynamicList<Foam::wallSurface::contact> Foam::wallSurface::contacts
(
    const point& x,
    const scalar radius,
    const UList<label>& triangles
) const
{
    bool behind;
    const DynamicList<facet> facets(touching(x, radius, triangles, behind));
    for (const facet& f : facets)
    {
        counts_[f.triangle] = behind ? f.height <= 0 : f.height >= 0;
    }

    DynamicList<contact> planes;
    DynamicList<scalar> distances;
    for (const facet& f : facets)
    {
        if (!counts_[f.triangle])
        {
            continue;
        }

        // What two pieces of one plane have from the edge between them adds up to zero
        const triPointRef piece(triangle(f.triangle));
        const point corners[] = {piece.a(), piece.b(), piece.c()};
        const scalar height = max(mag(f.height), 1e-9*radius);
        scalar weight = 0;
        for (label k = 0; k < 3; ++k)
        {
            const label other = coplanar(f.triangle, k);
            if (other < 0 || !counts_[other])
            {
                weight += edgeWeight
                (
                    corners[k] - x, corners[(k + 1) % 3] - x, f.out, height,
                    radius
                );
            }
        }
        const pointHit hit(piece.nearestPoint(x));
        addPiece
        (
            {
                -f.out, radius - f.height, weight, patch(f.triangle),
                moved(f.triangle, hit.rawPoint())
            },
            hit.distance(), 1e-6*radius, planes, distances
        );
    }
    for (const facet& f : facets)
    {
        counts_[f.triangle] = false;
    }

    DynamicList<contact> result;
    for (contact& c : planes)
    {
        c.weight /= constant::mathematical::twoPi;
        if (c.weight >= 1e-9)
        {
            result.append(c);
        }
    }
    return result;
}
