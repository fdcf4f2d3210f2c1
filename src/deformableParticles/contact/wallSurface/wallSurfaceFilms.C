/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"
#include "mathematicalConstants.H"
#include <Eigen/Dense>

namespace
{

using namespace Foam;

//- Least cosine of an angle between faces that is no edge of the wall, and of that
//  between the normals of one part of the wall
const scalar smooth = 0.8;
const scalar facing = 0.5;

}


void Foam::wallSurface::appendVertices
(
    const label t,
    DynamicList<label>& vertices
) const
{
    const labelledTri& corner = (*surface_)[t];
    if (!centred_)
    {
        vertices.append(corner);
        return;
    }
    for (const label part : pointTriangles_[corner[2]])
    {
        vertices.append((*surface_)[part][0]);
    }
}


Foam::symmTensor Foam::wallSurface::curvature
(
    const label t,
    const point& at,
    const scalar width
) const
{
    const vector& out = out_[t];
    const pointField& points = surface_->points();

    // Vertices, and how many of them belong to the face and the faces around it
    DynamicList<label> vertices;
    labelHashSet known;
    const auto append = [&](const label other)
    {
        DynamicList<label> more;
        appendVertices(other, more);
        for (const label v : more)
        {
            if (known.insert(v))
            {
                vertices.append(v);
            }
        }
    };
    append(t);
    const label own = vertices.size();
    for (label k = 0; k < vertices.size(); ++k)
    {
        if (k >= own && magSqr(points[vertices[k]] - at) > sqr(width))
        {
            continue;
        }
        for (const label other : pointTriangles_[vertices[k]])
        {
            if ((out_[other] & out) > smooth)
            {
                append(other);
            }
        }
    }

    // Along the plane of the face
    vector e1(points[vertices[1]] - points[vertices[0]]);
    e1 -= (e1 & out)*out;
    e1.normalise();
    const vector e2(out ^ e1);
    scalar size = 0;
    for (const label v : vertices)
    {
        size = max(size, mag(points[v] - at));
    }

    // Where the vertices do not determine all coefficients, as in a strip of faces, those
    // of least size are taken, with the plane before the curvature
    const scalar plane = 1e3;
    Eigen::MatrixXd A(vertices.size(), 6);
    Eigen::VectorXd z(vertices.size());
    forAll(vertices, k)
    {
        const vector d((points[vertices[k]] - at)/size);
        const scalar x = d & e1;
        const scalar y = d & e2;
        A.row(k) << plane, plane*x, plane*y, 0.5*sqr(x), x*y, 0.5*sqr(y);
        z[k] = d & out;
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-9);
    const Eigen::VectorXd c(solver.compute(A).solve(z));
    return
        (
            c[3]*sqr(e1) + c[4]*twoSymm(e1*e2) + c[5]*sqr(e2)
        )/size;
}


Foam::DynamicList<Foam::wallSurface::film> Foam::wallSurface::films
(
    const point& x,
    const scalar radius,
    const scalar range,
    const scalar reach,
    const UList<label>& triangles
) const
{
    DynamicList<film> result;
    const scalar limit = radius + reach;

    struct facet
    {
        scalar distance;
        label triangle;
        point nearest;
    };
    DynamicList<facet> facets;
    for (const label t : triangles)
    {
        const triPointRef piece(triangle(t));
        if
        (
            ((piece.a() - x) & out_[t]) > 0
         && magSqr(boxes_[t].nearest(x) - x) < sqr(limit)
        )
        {
            const pointHit hit(piece.nearestPoint(x));
            if (hit.distance() < limit && hit.distance() > SMALL*limit)
            {
                facets.append({hit.distance(), t, hit.rawPoint()});
                counts_[t] = true;
            }
        }
    }

    // Where two facets are equally near, on an edge, their normals decide, so that the
    // order of the triangles does not
    const auto before = [&](const facet& f, const facet& g)
    {
        if (mag(f.distance - g.distance) > 1e-9*limit)
        {
            return f.distance < g.distance;
        }
        const vector turn(out_[f.triangle] - out_[g.triangle]);
        for (direction k = 0; k < 3; ++k)
        {
            if (mag(turn[k]) > 1e-6)
            {
                return turn[k] < 0;
            }
        }
        return false;
    };

    while (true)
    {
        label nearest = -1;
        forAll(facets, k)
        {
            if
            (
                counts_[facets[k].triangle]
             && (nearest < 0 || before(facets[k], facets[nearest]))
            )
            {
                nearest = k;
            }
        }
        if (nearest < 0)
        {
            break;
        }
        const facet& first = facets[nearest];

        // The part of the wall around it, and its outline
        const vector& out = out_[first.triangle];
        DynamicList<label> part;
        labelHashSet inPart;
        const auto append = [&](const label t)
        {
            counts_[t] = false;
            inPart.insert(t);
            part.append(t);
        };
        append(first.triangle);
        DynamicList<vector> outline;
        for (label p = 0; p < part.size(); ++p)
        {
            const triPointRef piece(triangle(part[p]));
            const point corners[] = {piece.a(), piece.b(), piece.c()};
            for (label k = 0; k < 3; ++k)
            {
                const label other = beyond(part[p], k, smooth);
                if (other < 0 || !inPart.found(other))
                {
                    if (other >= 0 && counts_[other] && (out_[other] & out) > facing)
                    {
                        append(other);
                    }
                    else
                    {
                        outline.append(corners[k] - x);
                        outline.append(corners[(k + 1) % 3] - x);
                    }
                }
            }
        }

        // Beside the nearest point, the part continues to all sides unless the outline
        // passes it
        const vector d(first.nearest - x);
        const vector away(-d/first.distance);
        bool onOutline = false;
        for (label k = 0; k < outline.size(); k += 2)
        {
            const vector along(outline[k + 1] - outline[k]);
            const scalar at =
                ((d - outline[k]) & along)/max(magSqr(along), VSMALL);
            const vector closest
            (
                outline[k] + min(max(at, scalar(0)), scalar(1))*along
            );
            onOutline = onOutline || magSqr(d - closest) < sqr(1e-6*limit);
        }
        const vector normal(onOutline ? vector(-out) : away);
        const scalar height = d & -normal;
        scalar share = 0;
        for (label k = 0; k < outline.size(); k += 2)
        {
            const auto inPlane = [&](const vector& a)
            {
                return vector(a - (a & normal)*normal);
            };
            share += edgeShare
            (
                inPlane(outline[k]), inPlane(outline[k + 1]), -normal, height,
                radius + range
            );
        }
        share /= constant::mathematical::twoPi;
        if (share >= 1e-9)
        {
            result.append
            (
                {
                    {away, limit - first.distance, share, 0},
                    curvature(first.triangle, first.nearest, 0.5*radius)
                }
            );
        }
    }

    return result;
}
