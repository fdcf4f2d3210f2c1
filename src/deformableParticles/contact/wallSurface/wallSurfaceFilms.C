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

//- A triangle in front of a sphere
struct frontFacet
{
    scalar distance;
    label triangle;
    vector out;
    point nearest;
};


//- Whether f is nearer than g. Where both are equally near, on an edge, their normals
//  decide, so that the order of the triangles does not
bool before(const frontFacet& f, const frontFacet& g, const scalar limit)
{
    if (mag(f.distance - g.distance) > 1e-9*limit)
    {
        return f.distance < g.distance;
    }
    const vector turn(f.out - g.out);
    for (direction k = 0; k < 3; ++k)
    {
        if (mag(turn[k]) > 1e-6)
        {
            return turn[k] < 0;
        }
    }
    return false;
}


//- Whether one of the edges, from each second point to the next, passes a point
bool passes
(
    const UList<vector>& edges,
    const vector& at,
    const scalar tolerance
)
{
    for (label k = 0; k < edges.size(); k += 2)
    {
        const vector along(edges[k + 1] - edges[k]);
        const scalar part =
            ((at - edges[k]) & along)/max(magSqr(along), VSMALL);
        const vector closest
        (
            edges[k] + min(max(part, scalar(0)), scalar(1))*along
        );
        if (magSqr(at - closest) < sqr(tolerance))
        {
            return true;
        }
    }
    return false;
}

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


Foam::DynamicList<Foam::vector> Foam::wallSurface::outline
(
    const point& x,
    const label first
) const
{
    DynamicList<vector> edges;
    DynamicList<label> part;
    labelHashSet inPart;
    const auto append = [&](const label t)
    {
        counts_[t] = false;
        inPart.insert(t);
        part.append(t);
    };
    append(first);
    for (label p = 0; p < part.size(); ++p)
    {
        const triPointRef piece(triangle(part[p]));
        const point corners[] = {piece.a(), piece.b(), piece.c()};
        for (label k = 0; k < 3; ++k)
        {
            const label other = beyond(part[p], k, smooth);
            if (other >= 0 && inPart.found(other))
            {
                continue;
            }
            if (other >= 0 && counts_[other] && (out_[other] & out_[first]) > facing)
            {
                append(other);
            }
            else
            {
                edges.append(corners[k] - x);
                edges.append(corners[(k + 1) % 3] - x);
            }
        }
    }
    return edges;
}


Foam::scalar Foam::wallSurface::weightWithin
(
    const UList<vector>& outline,
    const vector& normal,
    const scalar height,
    const scalar radius
)
{
    const auto inPlane = [&](const vector& a)
    {
        return vector(a - (a & normal)*normal);
    };
    scalar weight = 0;
    for (label k = 0; k < outline.size(); k += 2)
    {
        weight += edgeWeight
        (
            inPlane(outline[k]), inPlane(outline[k + 1]), -normal, height, radius
        );
    }
    return weight/constant::mathematical::twoPi;
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
    const scalar limit = radius + reach;
    DynamicList<frontFacet> facets;
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
                facets.append({hit.distance(), t, out_[t], hit.rawPoint()});
                counts_[t] = true;
            }
        }
    }

    // Part by part of the wall, from the nearest facet that is in none yet
    DynamicList<film> result;
    while (true)
    {
        const frontFacet* first = nullptr;
        for (const frontFacet& f : facets)
        {
            if (counts_[f.triangle] && (!first || before(f, *first, limit)))
            {
                first = &f;
            }
        }
        if (!first)
        {
            break;
        }
        const DynamicList<vector> edges(outline(x, first->triangle));

        // Beside the nearest point, the part continues to all sides unless the outline
        // passes it
        const vector d(first->nearest - x);
        const vector away(-d/first->distance);
        const vector normal
        (
            passes(edges, d, 1e-6*limit) ? vector(-first->out) : away
        );
        const scalar weight = weightWithin(edges, normal, d & -normal, radius + range);
        if (weight >= 1e-9)
        {
            result.append
            (
                {
                    {
                        away, limit - first->distance, weight, patch(first->triangle),
                        moved(first->triangle, first->nearest)
                    },
                    curvature(first->triangle, first->nearest, 0.5*radius)
                }
            );
        }
    }
    return result;
}
