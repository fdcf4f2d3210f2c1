/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"
#include "wallPolyPatch.H"
#include "IPstream.H"
#include "OPstream.H"
#include "treeBoundBox.H"

Foam::wallSurface::wallSurface
(
    const polyMesh& mesh,
    const ghostExchange& ghosts
)
{
    // Triangles as three points each
    DynamicList<point> corners;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!isA<wallPolyPatch>(pp))
        {
            continue;
        }
        for (const face& f : pp.localFaces())
        {
            const pointField& points = pp.localPoints();
            const point centre(f.centre(points));
            forAll(f, k)
            {
                corners.append(points[f[k]]);
                corners.append(points[f.nextLabel(k)]);
                corners.append(centre);
            }
        }
    }

    // All neighbours' walls; the octree leaves the far ones out of every search
    const List<point> own(corners);
    for (const label proci : ghosts.neighbours())
    {
        OPstream os(Pstream::commsTypes::blocking, proci);
        os << own;
    }
    for (const label proci : ghosts.neighbours())
    {
        IPstream is(Pstream::commsTypes::blocking, proci);
        corners.append(List<point>(is));
    }

    const List<point> unshifted(corners);
    for (label s = 1; s < ghosts.shifts().size(); ++s)
    {
        for (const point& p : unshifted)
        {
            corners.append(p + ghosts.shifts()[s]);
        }
    }

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

    // As deep as a radius behind the wall is still recognised
    const auto& tree = search_->tree();
    const pointIndexHit nearest(tree.findNearest(x, sqr(radius)));
    if (!nearest.hit())
    {
        return result;
    }

    const auto append = [&](const point& foot, const label triangle)
    {
        // Normals point out of the mesh
        const vector out(normalised(surface_->faceNormals()[triangle]));
        const vector away(x - foot);
        const scalar gap = mag(away);
        const scalar side = (away & out) < 0 ? 1 : -1;
        const vector n(gap > SMALL*radius ? side*away/gap : -out);

        for (const contact& c : result)
        {
            if ((c.normal & n) > 0.9)
            {
                return;
            }
        }
        result.append({n, radius - side*gap});
    };

    append(nearest.rawPoint(), nearest.index());

    const labelList others
    (
        tree.findBox(treeBoundBox(x - radius*vector::one, x + radius*vector::one))
    );
    for (const label t : others)
    {
        const triPointRef tri
        (
            surface_->points()[(*surface_)[t][0]],
            surface_->points()[(*surface_)[t][1]],
            surface_->points()[(*surface_)[t][2]]
        );
        const point foot(tri.nearestPoint(x).rawPoint());
        const vector out(normalised(surface_->faceNormals()[t]));
        const scalar gap = mag(x - foot);

        if (gap < radius && mag((x - foot) & out) > 0.999*gap)
        {
            append(foot, t);
        }
    }

    return result;
}
