/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceDistance.H"
#include "triSurfaceTools.H"
#include <cmath>

Foam::List<Foam::labelledTri> Foam::surfaceDistance::trianglesOf
(
    const closedSurface& surface,
    const bool mirrored
)
{
    List<labelledTri> result(surface.triangles().size());
    forAll(result, n)
    {
        const triFace& t = surface.triangles()[n];
        result[n] =
            mirrored
          ? labelledTri(t[0], t[2], t[1], 0) : labelledTri(t[0], t[1], t[2], 0);
    }
    return result;
}


Foam::label Foam::surfaceDistance::depth(const label nTriangles)
{
    constexpr scalar perBox = 20;
    return max(label(1), label(std::round(0.5*std::log2(nTriangles/perBox))));
}


Foam::surfaceDistance::surfaceDistance
(
    const closedSurface& surface,
    const pointField& x,
    const bool mirrored
)
:
    // Without nodes inside
    surface_
    (
        trianglesOf(surface, mirrored),
        pointField(SubField<point>(x, surface.nNodes()))
    ),
    // With the default tolerance
    search_(surface_, -1, depth(surface_.size()))
{}


Foam::List<Foam::surfaceDistance::place> Foam::surfaceDistance::nearest
(
    const pointField& points,
    const scalar limit
) const
{
    List<pointIndexHit> hits;
    search_.findNearest(points, scalarField(points.size(), sqr(limit)), hits);

    List<place> result(points.size());
    forAll(points, i)
    {
        place& p = result[i];
        p.found = hits[i].hit();
        if (!p.found)
        {
            continue;
        }
        p.triangle = hits[i].index();
        p.at = hits[i].rawPoint();
        const vector away(points[i] - p.at);
        const bool inside =
            triSurfaceTools::surfaceSide(surface_, points[i], p.triangle)
         == triSurfaceTools::INSIDE;
        p.distance = inside ? -mag(away) : mag(away);

        // On the surface itself there is no way to it
        const vector normal
        (
            surface_[p.triangle].areaNormal(surface_.points())
        );
        p.outwards =
            magSqr(away) > 1e-16*mag(normal)
          ? vector(away/p.distance) : vector(normal/mag(normal));
    }
    return result;
}


Foam::boolList Foam::surfaceDistance::inside
(
    const pointField& points,
    const UList<place>& places
) const
{
    boolList result(points.size());
    forAll(points, i)
    {
        const place& p = places[i];
        result[i] =
            p.found
          ? p.distance < 0
          : search_.tree().bb().contains(points[i])
         && search_.tree().getVolumeType(points[i]) == volumeType::INSIDE;
    }
    return result;
}
