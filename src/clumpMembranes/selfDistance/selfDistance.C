/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "selfDistance.H"
#include "mathematicalConstants.H"
#include "pointGrid.H"
#include "triangle.H"
#include <algorithm>

namespace
{

//- Cosine of the least angle between the normals of parts that face each other
const Foam::scalar facing = -0.5;

}


Foam::selfDistance::selfDistance
(
    const closedSurface& surface,
    const pointField& x
)
:
    surface_(surface),
    triangles_(surface.nNodes()),
    near_(surface.nodesAround(2)),
    thickness_(GREAT)
{
    forAll(surface.triangles(), n)
    {
        for (const label i : surface.triangles()[n])
        {
            triangles_[i].append(n);
        }
    }

    // Not far below the least distance of nodes
    for (const place& p : find(x, 1.001*nodeDistance(x)))
    {
        thickness_ = min(thickness_, p.gap);
    }
}


bool Foam::selfDistance::isNear(const label i, const label j) const
{
    return std::binary_search(near_[i].begin(), near_[i].end(), j);
}


Foam::tmp<Foam::vectorField> Foam::selfDistance::normals(const pointField& x) const
{
    const vectorField S(surface_.areaVectors(x));
    return S/max(mag(S), VSMALL);
}


Foam::scalar Foam::selfDistance::nodeDistance(const pointField& x) const
{
    const vectorField n(normals(x));
    scalar least = Foam::sqrt(GREAT);
    forAll(x, i)
    {
        for (label j = 0; j < i; ++j)
        {
            if ((n[i] & n[j]) < facing && !isNear(i, j))
            {
                least = min(least, mag(x[i] - x[j]));
            }
        }
    }
    return least;
}


Foam::scalar Foam::selfDistance::windingNumber
(
    const pointField& x,
    const point& p
) const
{
    // Solid angles of triangles: Van Oosterom and Strackee 1983
    scalar sum = 0;
    for (const triFace& t : surface_.triangles())
    {
        const vector a(x[t[0]] - p);
        const vector b(x[t[1]] - p);
        const vector c(x[t[2]] - p);
        const scalar A = mag(a);
        const scalar B = mag(b);
        const scalar C = mag(c);
        sum += 2*Foam::atan2
        (
            a & (b ^ c), A*B*C + (a & b)*C + (b & c)*A + (c & a)*B
        );
    }
    return sum/(4*constant::mathematical::pi);
}


Foam::DynamicList<Foam::selfDistance::place> Foam::selfDistance::find
(
    const pointField& x,
    const scalar limit
) const
{
    const vectorField n(normals(x));
    scalar longest = 0;
    for (const closedSurface::hinge& h : surface_.hinges())
    {
        longest = max(longest, mag(x[h.j] - x[h.i]));
    }
    const vector reach((limit + longest)*vector::one);

    pointGrid grid;
    grid.update(x);
    DynamicList<label> candidates;
    DynamicList<place> result;
    forAll(x, i)
    {
        // On the inner and on the outer side of the node
        place nearest[] = {{i, -1, Zero, limit, Zero}, {i, -1, Zero, limit, Zero}};
        grid.find(boundBox(x[i] - reach, x[i] + reach), candidates);
        for (const label j : candidates)
        {
            if ((n[i] & n[j]) >= facing || isNear(i, j))
            {
                continue;
            }
            for (const label k : triangles_[j])
            {
                const triFace& t = surface_.triangles()[k];
                const pointHit hit
                (
                    triPointRef(x[t[0]], x[t[1]], x[t[2]]).nearestPoint(x[i])
                );
                place& p = nearest[((hit.rawPoint() - x[i]) & n[i]) > 0];
                if (hit.distance() < p.gap)
                {
                    p.triangle = k;
                    p.at = hit.rawPoint();
                    p.gap = hit.distance();
                }
            }
        }
        for (place& p : nearest)
        {
            if (p.triangle < 0)
            {
                continue;
            }

            // The inside lies between them where the winding number is odd
            const scalar w = windingNumber(x, 0.5*(x[i] + p.at));
            const bool passed = w < -0.5 || w > 1.5;
            const bool inside = mag(mag(w) - 1) < 0.5;
            const vector away(x[i] - p.at);
            if (passed)
            {
                p.gap = -p.gap;
            }
            p.opens =
                mag(away) > 1e-6*longest
              ? vector(away/p.gap)
              : vector(inside ? n[i] : -n[i]);
            result.append(p);
        }
    }
    return result;
}
