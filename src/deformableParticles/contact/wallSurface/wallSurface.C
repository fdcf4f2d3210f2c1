/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"
#include "faceTriangles.H"
#include "foamCompat.H"
#include "wallDisplacement.H"
#include "wallPolyPatch.H"
#include "PstreamBuffers.H"
#include "ListOps.H"
#include "mergePoints.H"
#include "treeBoundBox.H"

Foam::wallSurface::wallSurface
(
    const polyMesh& mesh,
    const ghostExchange& ghosts
)
:
    centred_(true),
    known_(0)
{
    // Patches that are not those of processors have the same index everywhere
    DynamicList<face> walls;
    DynamicList<label> patches;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<wallPolyPatch>(pp))
        {
            walls.append(pp);
            patches.append(labelList(pp.size(), pp.index()));
            if (mesh.moving() && pointsSlide(pp))
            {
                sliding_.insert(pp.index());
            }
        }
    }
    collect
    (
        walls,
        mesh.points(),
        mesh.moving() ? mesh.oldPoints() : pointField(),
        patches,
        ghosts
    );
}


Foam::wallSurface::wallSurface
(
    const UList<face>& faces,
    const UList<point>& points,
    const ghostExchange& ghosts
)
:
    centred_(true),
    known_(0)
{
    collect(faces, points, pointField(), labelList(faces.size(), Zero), ghosts);
}


void Foam::wallSurface::collect
(
    const UList<face>& faces,
    const UList<point>& points,
    const UList<point>& oldPoints,
    const UList<label>& patches,
    const ghostExchange& ghosts
)
{
    known_ = 3*ghosts.reach(Pstream::myProcNo());

    // Triangles as three points each, and how these have moved
    DynamicList<point> corners;
    DynamicList<vector> moves;
    DynamicList<label> patchOf;
    const bool move = returnReduce(oldPoints.size(), sumOp<label>()) > 0;

    forAll(faces, facei)
    {
        const List<point> now(faceTriangles(faces[facei], points));
        corners.append(now);
        patchOf.append(labelList(faces[facei].size(), patches[facei]));
        if (move)
        {
            const List<point> before(faceTriangles(faces[facei], oldPoints));
            forAll(now, k)
            {
                moves.append(now[k] - before[k]);
            }
        }
    }
    const boundBox all(corners, false);

    // What lies in a plane of symmetry, such as an edge of a region to fill, has no image
    boolList inPlane(corners.size()/3, false);
    for (const imageTransform& image : ghosts.transforms())
    {
        for (label t = 0; image.mirrors() && t < corners.size(); t += 3)
        {
            const scalar size = mag(corners[t + 1] - corners[t]);
            bool stays = true;
            for (label k = t; k < t + 3; ++k)
            {
                stays =
                    stays
                 && mag(image.position(corners[k]) - corners[k]) < 1e-6*size;
            }
            inPlane[t/3] = inPlane[t/3] || stays;
        }
    }

    // What a clump on another processor, or behind a periodic boundary or a plane of
    // symmetry, may feel
    const auto around = [&]
    (
        const label proci,
        DynamicList<label>& patchIds,
        DynamicList<vector>& movesOf
    )
    {
        DynamicList<point> found;
        const boundBox box(grown(ghosts.box(proci), 4*ghosts.reach(proci)));
        forAll(ghosts.transforms(), s)
        {
            const imageTransform& image = ghosts.transforms()[s];
            const bool itself = proci == Pstream::myProcNo() && s == 0;
            if (itself || !box.overlaps(image.box(all)))
            {
                continue;
            }
            for (label t = 0; t < corners.size(); t += 3)
            {
                // A mirror image is seen from its other side
                const label second = image.invertsHands() ? 2 : 1;
                const point a(image.position(corners[t]));
                const point b(image.position(corners[t + second]));
                const point c(image.position(corners[t + 3 - second]));
                if
                (
                    !(image.mirrors() && inPlane[t/3])
                 && box.overlaps(boundBox(min(a, min(b, c)), max(a, max(b, c))))
                )
                {
                    found.append(a);
                    found.append(b);
                    found.append(c);
                    patchIds.append(patchOf[t/3]);
                    if (move)
                    {
                        movesOf.append(image.polar(moves[t]));
                        movesOf.append(image.polar(moves[t + second]));
                        movesOf.append(image.polar(moves[t + 3 - second]));
                    }
                }
            }
        }
        return found;
    };

    // Walls may be farther away than clumps that meet
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    DynamicList<point> imageCorners;
    DynamicList<label> patchOfImages;
    DynamicList<vector> imageMoves;
    for (label proci = 0; proci < Pstream::nProcs(); ++proci)
    {
        DynamicList<label> patchIds;
        DynamicList<vector> movesOf;
        const DynamicList<point> found(around(proci, patchIds, movesOf));
        if (proci == Pstream::myProcNo())
        {
            imageCorners = found;
            patchOfImages = patchIds;
            imageMoves = movesOf;
        }
        else if (found.size())
        {
            UOPstream os(proci, buffers);
            os << List<point>(found) << labelList(patchIds) << List<vector>(movesOf);
        }
    }
    labelList sizes;
    buffers.finishedSends(sizes);
    corners.append(imageCorners);
    patchOf.append(patchOfImages);
    moves.append(imageMoves);
    forAll(sizes, proci)
    {
        if (proci != Pstream::myProcNo() && sizes[proci])
        {
            UIPstream is(proci, buffers);
            corners.append(List<point>(is));
            patchOf.append(labelList(is));
            moves.append(List<vector>(is));
        }
    }

    makeSearch(corners, patchOf, moves);
}


Foam::wallSurface::wallSurface(const UList<point>& corners)
:
    centred_(false),
    known_(GREAT)
{
    makeSearch(corners, labelList(corners.size()/3, Zero));
}


void Foam::wallSurface::makeSearch
(
    const UList<point>& corners,
    const UList<label>& patches,
    const UList<vector>& moves
)
{
    if (corners.empty())
    {
        return;
    }

    // Periodic images and other processors have the same points to rounding only. The
    // origin of the search is where few points have the same distance from it
    const pointField all(corners);
    const boundBox box(all, false);
    labelList pointMap;
    const label nPoints = mergePoints
    (
        all, 1e-9*box.mag(), false, pointMap,
        box.min() - cmptMultiply(vector(1, 1.1, 1.3), box.span())
    );
    pointField points(nPoints);
    forAll(all, k)
    {
        points[pointMap[k]] = all[k];
    }
    moves_.setSize(moves.size() ? nPoints : 0);
    forAll(moves, k)
    {
        moves_[pointMap[k]] = moves[k];
    }

    List<labelledTri> triangles(corners.size()/3);
    forAll(triangles, t)
    {
        triangles[t] = labelledTri
        (
            pointMap[3*t], pointMap[3*t + 1], pointMap[3*t + 2], patches[t]
        );
    }
    invertManyToMany(nPoints, triangles, pointTriangles_);
    surface_.reset(new triSurface(triangles, points));
    search_.reset(new triSurfaceSearch(*surface_));

    out_.setSize(triangles.size());
    boxes_.setSize(triangles.size());
    counts_.clear();
    counts_.resize(triangles.size(), false);
    forAll(triangles, t)
    {
        const triPointRef corner(triangle(t));
        const point& a = corner.a();
        const point& b = corner.b();
        const point& c = corner.c();
        boxes_[t] = boundBox(min(a, min(b, c)), max(a, max(b, c)));

        const vector area(corner.areaNormal());
        const bool flat = mag(area) < 1e-12*magSqr(boxes_[t].span());
        out_[t] = flat ? vector::zero : vector(area/mag(area));
    }
    findNeighbours();
}


Foam::triPointRef Foam::wallSurface::triangle(const label t) const
{
    const labelledTri& corner = (*surface_)[t];
    const pointField& points = surface_->points();
    return triPointRef(points[corner[0]], points[corner[1]], points[corner[2]]);
}


Foam::vector Foam::wallSurface::moved(const label t, const point& at) const
{
    if (moves_.empty())
    {
        return vector::zero;
    }
    const labelledTri& corner = (*surface_)[t];
    const barycentric2D part(triangle(t).pointToBarycentric(at));
    const vector way
    (
        part.a()*moves_[corner[0]] + part.b()*moves_[corner[1]]
      + part.c()*moves_[corner[2]]
    );
    return sliding_.found(patch(t)) ? vector((way & out_[t])*out_[t]) : way;
}


void Foam::wallSurface::findNeighbours()
{
    neighbours_ = labelList(3*surface_->size(), -1);
    forAll(*surface_, t)
    {
        const labelledTri& corner = (*surface_)[t];
        for (label k = 0; k < 3; ++k)
        {
            // It runs along the edge in the opposite direction. A wall without
            // thickness has two of them, of which one continues its side
            scalar best = -GREAT;
            for (const label other : pointTriangles_[corner[k]])
            {
                const scalar cosine = out_[t] & out_[other];
                if
                (
                    other != t
                 && (*surface_)[other].edgeDirection
                    (
                        edge(corner[k], corner[(k + 1) % 3])
                    ) < 0
                 && cosine > best
                )
                {
                    best = cosine;
                    neighbours_[3*t + k] = other;
                }
            }
        }
    }
}


Foam::label Foam::wallSurface::beyond
(
    const label t,
    const label k,
    const scalar cosine
) const
{
    const label other = neighbours_[3*t + k];
    return
        other >= 0 && (out_[t] & out_[other]) >= cosine ? other : -1;
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
    nearPlace& place
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
    place.patch = patch(hit.index());
    place.moved = moved(hit.index(), hit.rawPoint());
    const vector d(x - hit.rawPoint());
    const scalar distance = mag(d);

    // On an edge, the triangle whose plane is farthest from the point decides
    // which side of the wall this is
    const scalar small = 1e-6*limit;
    scalar side = 0;
    place.inwards = Zero;
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
        const triPointRef corner(triangle(t));
        const vector area(corner.areaNormal());
        if
        (
            mag(area) > VSMALL
         && mag(corner.nearestPoint(hit.rawPoint()).distance()) <= small
        )
        {
            const vector n(-area/mag(area));
            const scalar h = d & n;
            if (mag(h) >= mag(side)*(1 - SMALL))
            {
                side = h;
                place.inwards = n;
            }
        }
    }
    place.height = side < 0 ? -distance : distance;
    place.away =
        distance > 1e-3*small ? d*sign(place.height)/distance
      : place.inwards;
    return true;
}
