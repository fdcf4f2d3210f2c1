/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceShape.H"
#include "closedSurface.H"
#include "EdgeMap.H"

void Foam::clumpShapes::surfaceShape::setIcosphere(const label nSubdivisions)
{
    const scalar g = 0.5*(1 + Foam::sqrt(5.0));
    centres_ =
    {
        {-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
        {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
        {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}
    };
    centres_ /= mag(centres_);
    const label corners[][3] =
    {
        {0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11},
        {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
        {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8}, {3, 8, 9},
        {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}
    };
    triangles_.clear();
    for (const auto& c : corners)
    {
        triangles_.append(triFace(c[0], c[1], c[2]));
    }

    for (label n = 0; n < nSubdivisions; ++n)
    {
        EdgeMap<label> middles(2*triangles_.size());
        DynamicList<point> points(centres_);
        const auto middle = [&](const label i, const label j)
        {
            if (middles.insert(edge(i, j), points.size()))
            {
                const vector m(points[i] + points[j]);
                points.append(m/mag(m));
            }
            return middles[edge(i, j)];
        };
        DynamicList<triFace> finer(4*triangles_.size());
        for (const triFace& t : triangles_)
        {
            const label a = middle(t[0], t[1]);
            const label b = middle(t[1], t[2]);
            const label c = middle(t[2], t[0]);
            finer.append(triFace(t[0], a, c));
            finer.append(triFace(t[1], b, a));
            finer.append(triFace(t[2], c, b));
            finer.append(triFace(a, b, c));
        }
        centres_ = pointField(points);
        triangles_.transfer(finer);
    }
}


void Foam::clumpShapes::surfaceShape::setRadii(const dictionary& dict)
{
    const closedSurface surface(centres_, triangles_, dict);
    radii_ = scalarField(centres_.size(), 0.5*surface.edgeLength(centres_));
}
