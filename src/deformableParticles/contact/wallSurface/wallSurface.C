/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"
#include "faceTriangles.H"
#include "wallPolyPatch.H"
#include "IPstream.H"
#include "OPstream.H"
#include "treeBoundBox.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

//- Part of the force of an unbounded plane at a height h that comes from within
//  the distance s of the centre
scalar shareWithin(const scalar s, const scalar h, const scalar r)
{
    if (s >= r)
    {
        return 1;
    }
    const scalar e = (r - s)/max(r - h, VSMALL);
    return 1 - h/s*e*Foam::sqrt(e);
}


//- Integral of shareWithin over the angle at the foot of the centre, along a
//  line that passes the foot at a distance p, from its nearest point to t
scalar angleShare
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
                result += half*w[k]*shareWithin(s, h, r)/c;
            }
        }
    }

    return t < 0 ? -result : result;
}


//- Part of the force of an unbounded plane that a triangle of it takes
scalar shareOf
(
    const triPointRef& triangle,
    const vector& normal,
    const point& centre,
    const scalar height,
    const scalar r
)
{
    const point corners[] = {triangle.a(), triangle.b(), triangle.c()};
    const scalar h = max(height, 1e-9*r);
    scalar result = 0;

    for (label k = 0; k < 3; ++k)
    {
        const vector a(corners[k] - centre);
        const vector b(corners[(k + 1) % 3] - centre);
        const scalar length = mag(b - a);
        if (length < 1e-12*r)
        {
            continue;
        }
        const vector along((b - a)/length);
        const scalar p = (a ^ along) & normal;
        if (mag(p) > 1e-9*r)
        {
            result += sign(p)
               *(
                    angleShare(b & along, mag(p), h, r)
                  - angleShare(a & along, mag(p), h, r)
                );
        }
    }

    return max(result/constant::mathematical::twoPi, scalar(0));
}

}

Foam::wallSurface::wallSurface
(
    const polyMesh& mesh,
    const ghostExchange& ghosts
)
{
    DynamicList<face> walls;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<wallPolyPatch>(pp))
        {
            walls.append(pp);
        }
    }
    collect(walls, mesh.points(), ghosts);
}


Foam::wallSurface::wallSurface
(
    const UList<face>& faces,
    const UList<point>& points,
    const ghostExchange& ghosts
)
{
    collect(faces, points, ghosts);
}


void Foam::wallSurface::collect
(
    const UList<face>& faces,
    const UList<point>& points,
    const ghostExchange& ghosts
)
{
    // Triangles as three points each
    DynamicList<point> corners;

    for (const face& f : faces)
    {
        corners.append(faceTriangles(f, points));
    }

    // What a clump on another processor, or behind a periodic boundary, may feel
    const auto around = [&](const label proci)
    {
        DynamicList<point> found;
        const scalar width = 20*ghosts.reach();
        boundBox box(ghosts.box(proci));
        box.min() -= width*vector::one;
        box.max() += width*vector::one;
        forAll(ghosts.shifts(), s)
        {
            if (proci == Pstream::myProcNo() && s == 0)
            {
                continue;
            }
            for (label t = 0; t < corners.size(); t += 3)
            {
                const vector& shift = ghosts.shifts()[s];
                const point a(corners[t] + shift);
                const point b(corners[t + 1] + shift);
                const point c(corners[t + 2] + shift);
                if (box.overlaps(boundBox(min(a, min(b, c)), max(a, max(b, c)))))
                {
                    found.append(a);
                    found.append(b);
                    found.append(c);
                }
            }
        }
        return found;
    };

    for (const label proci : ghosts.neighbours())
    {
        OPstream os(Pstream::commsTypes::blocking, proci);
        os << List<point>(around(proci));
    }
    corners.append(around(Pstream::myProcNo()));
    for (const label proci : ghosts.neighbours())
    {
        IPstream is(Pstream::commsTypes::blocking, proci);
        corners.append(List<point>(is));
    }

    makeSearch(corners);
}


Foam::wallSurface::wallSurface(const UList<point>& corners)
{
    makeSearch(corners);
}


void Foam::wallSurface::makeSearch(const UList<point>& corners)
{
    if (corners.size())
    {
        List<labelledTri> triangles(corners.size()/3);
        forAll(triangles, t)
        {
            triangles[t] = labelledTri(3*t, 3*t + 1, 3*t + 2, 0);
        }
        surface_.reset(new triSurface(triangles, pointField(corners)));
        search_.reset(new triSurfaceSearch(*surface_));
    }
}


Foam::scalar Foam::wallSurface::distance
(
    const point& x,
    const scalar limit
) const
{
    if (empty())
    {
        return limit;
    }
    const pointIndexHit hit(search_->tree().findNearest(x, sqr(limit)));
    return hit.hit() ? mag(hit.rawPoint() - x) : limit;
}


bool Foam::wallSurface::nearest
(
    const point& x,
    const scalar limit,
    scalar& height,
    vector& away,
    vector& inwards
) const
{
    if (empty())
    {
        return false;
    }
    const pointIndexHit hit(search_->tree().findNearest(x, sqr(limit)));
    if (!hit.hit())
    {
        return false;
    }
    const vector d(x - hit.rawPoint());
    const scalar distance = mag(d);

    // On an edge, the triangle whose plane is farthest from the point decides
    // which side of the wall this is
    const scalar small = 1e-6*limit;
    scalar side = 0;
    inwards = Zero;
    const labelList near
    (
        search_->tree().findBox
        (
            treeBoundBox
            (
                hit.rawPoint() - small*vector::one,
                hit.rawPoint() + small*vector::one
            )
        )
    );
    for (const label t : near)
    {
        const labelledTri& corner = (*surface_)[t];
        const pointField& points = surface_->points();
        const triPointRef triangle
        (
            points[corner[0]], points[corner[1]], points[corner[2]]
        );
        const vector area(triangle.areaNormal());
        if
        (
            mag(area) > VSMALL
         && mag(triangle.nearestPoint(hit.rawPoint()).distance()) <= small
        )
        {
            const vector n(-area/mag(area));
            const scalar h = d & n;
            if (mag(h) >= mag(side)*(1 - SMALL))
            {
                side = h;
                inwards = n;
            }
        }
    }
    height = side < 0 ? -distance : distance;
    away =
        distance > 1e-3*small ? d*sign(height)/distance
      : inwards;
    return true;
}


Foam::DynamicList<Foam::wallSurface::contact> Foam::wallSurface::contacts
(
    const point& x,
    const scalar radius
) const
{
    DynamicList<contact> result;

    if (empty())
    {
        return result;
    }

    struct facet
    {
        label triangle;
        vector out;         // unit, out of the fluid
        scalar height;      // of the centre over its plane, into the fluid
    };
    DynamicList<facet> facets;

    // Is the centre behind the wall? If several triangles share the nearest
    // point (on an edge or a corner), the one whose plane is farthest from the
    // centre decides
    scalar nearest = radius;
    scalar side = 0;

    const auto triangleOf = [&](const label t)
    {
        const labelledTri& corner = (*surface_)[t];
        const pointField& points = surface_->points();
        return triPointRef
        (
            points[corner[0]], points[corner[1]], points[corner[2]]
        );
    };

    const labelList near
    (
        search_->tree().findBox
        (
            treeBoundBox(x - radius*vector::one, x + radius*vector::one)
        )
    );
    for (const label t : near)
    {
        const triPointRef triangle(triangleOf(t));
        const vector area(triangle.areaNormal());
        if (mag(area) < 1e-12*sqr(radius))
        {
            continue;
        }
        const vector out(area/mag(area));
        const scalar height = (triangle.a() - x) & out;
        const scalar gap = triangle.nearestPoint(x).distance();
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
    const bool behind = side < -1e-9*radius;

    for (const facet& f : facets)
    {
        if (behind ? f.height > 0 : f.height < 0)
        {
            continue;
        }
        const scalar share =
            shareOf(triangleOf(f.triangle), f.out, x, mag(f.height), radius);
        if (share < 1e-9)
        {
            continue;
        }

        // The pieces of one plane are one contact
        const contact c{-f.out, radius - f.height, share};
        bool known = false;
        for (contact& other : result)
        {
            if
            (
                mag(other.normal - c.normal) < 1e-6
             && mag(other.overlap - c.overlap) < 1e-6*radius
            )
            {
                other.share += share;
                known = true;
                break;
            }
        }
        if (!known)
        {
            result.append(c);
        }
    }

    return result;
}
