/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"
#include "faceTriangles.H"
#include "wallPolyPatch.H"
#include "PstreamBuffers.H"
#include "treeBoundBox.H"
#include <map>
#include <tuple>

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

    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    for (const label proci : ghosts.neighbours())
    {
        UOPstream os(proci, buffers);
        os << List<point>(around(proci));
    }
    buffers.finishedSends();
    corners.append(around(Pstream::myProcNo()));
    for (const label proci : ghosts.neighbours())
    {
        UIPstream is(proci, buffers);
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

        out_.setSize(triangles.size());
        boxes_.setSize(triangles.size());
        counts_.clear();
        counts_.resize(triangles.size(), false);
        forAll(triangles, t)
        {
            const point& a = corners[3*t];
            const point& b = corners[3*t + 1];
            const point& c = corners[3*t + 2];
            boxes_[t] = boundBox(min(a, min(b, c)), max(a, max(b, c)));

            const vector area(triPointRef(a, b, c).areaNormal());
            const bool flat = mag(area) < 1e-12*magSqr(boxes_[t].span());
            out_[t] = flat ? vector::zero : vector(area/mag(area));
        }
        findCoplanar(corners);
    }
}


void Foam::wallSurface::findCoplanar(const UList<point>& corners)
{
    typedef std::tuple<scalar, scalar, scalar, scalar, scalar, scalar> edge;
    const auto edgeOf = [](const point& a, const point& b)
    {
        return edge(a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
    };
    std::map<edge, label> open;
    coplanar_ = labelList(corners.size(), -1);
    forAll(corners, k)
    {
        const label t = k/3;
        const point& a = corners[k];
        const point& b = corners[3*t + (k + 1) % 3];

        // The neighbour runs along the edge in the opposite direction
        const auto found = open.find(edgeOf(b, a));
        if (found == open.end())
        {
            open[edgeOf(a, b)] = k;
            continue;
        }
        const label other = found->second;
        if (mag(out_[t] - out_[other/3]) < 1e-6)
        {
            coplanar_[k] = other/3;
            coplanar_[other] = t;
        }
        open.erase(found);
    }
}


Foam::labelList Foam::wallSurface::near(const boundBox& box) const
{
    return
        empty()
      ? labelList()
      : labelList(search_->tree().findBox(treeBoundBox(box)));
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
