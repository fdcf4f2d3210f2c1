/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphereFilling.H"
#include "sphereUnion.H"
#include "triSurfaceSearch.H"
#include <queue>
#include <utility>

Foam::scalar Foam::sphereFilling::volume(const triSurface& surface)
{
    scalar result = 0;
    const point origin(boundBox(surface.points(), false).midpoint());
    for (const labelledTri& f : surface)
    {
        const vector a(surface.points()[f[0]] - origin);
        const vector b(surface.points()[f[1]] - origin);
        const vector c(surface.points()[f[2]] - origin);
        result += (a & (b ^ c))/6;
    }
    return result;
}


Foam::sphereFilling::sphereFilling
(
    const triSurface& surface,
    const scalar error,
    const label maxSpheres
)
:
    surface_(surface),
    volume_(mag(volume(surface))),
    area_(sum(mag(surface.faceAreas())))
{
    // 41 points along the longest side for 5 %, 55 for 2 %
    makeGrid(min(max(2*label(0.5/Foam::cbrt(error)*15) + 1, 21), 81));
    fill(error, maxSpheres);
    if (centres_.size())
    {
        grow();
    }
}


void Foam::sphereFilling::makeGrid(const label n)
{
    const boundBox box(surface_.points(), false);
    spacing_ = cmptMax(box.span())/n;
    const scalar h = spacing_;

    // With a point in the middle
    labelVector half;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        half[d] = label(0.5*box.span()[d]/h);
    }
    DynamicList<point> all;
    for (label i = -half.x(); i <= half.x(); ++i)
    {
        for (label j = -half.y(); j <= half.y(); ++j)
        {
            for (label k = -half.z(); k <= half.z(); ++k)
            {
                all.append(box.midpoint() + h*vector(i, j, k));
            }
        }
    }

    const triSurfaceSearch search(surface_);
    const boolList inside(search.calcInside(pointField(all)));
    DynamicList<point> points;
    DynamicList<scalar> distances;
    const vector span(2*box.span());
    forAll(all, i)
    {
        if (inside[i])
        {
            const pointIndexHit hit(search.nearest(all[i], span));
            const scalar d = mag(hit.hitPoint() - all[i]);
            if (d > 0.25*h)
            {
                points.append(all[i]);
                distances.append(d);
            }
        }
    }
    points_.transfer(points);
    distances_.transfer(distances);
    open_ = identity(points_.size());
}


bool Foam::sphereFilling::allowed
(
    const label candidate,
    const scalar growth
) const
{
    forAll(centres_, i)
    {
        const scalar small = min(radii_[i], distances_[candidate]);
        const scalar large = max(radii_[i], distances_[candidate]);
        if
        (
            magSqr(points_[candidate] - centres_[i])
         <= sqr(large + growth) - sqr(small + growth) + 0.1*sqr(small)
        )
        {
            return false;
        }
    }
    return true;
}


Foam::label Foam::sphereFilling::gain(const label candidate) const
{
    const scalar limit = sqr(distances_[candidate]);
    label n = 0;
    for (const label i : open_)
    {
        n += magSqr(points_[i] - points_[candidate]) <= limit ? 1 : 0;
    }
    return n;
}


void Foam::sphereFilling::fill(const scalar error, const label maxSpheres)
{
    // What a candidate covers can only become less: those with the best bound are
    // looked at again until one keeps its place
    const scalar growth = 1.5*error*volume_/area_;
    std::priority_queue<std::pair<label, label>> best;
    forAll(points_, i)
    {
        // Whole cubes around points of the grid fit into this sphere
        const scalar r = distances_[i]/spacing_ + 0.5*Foam::sqrt(3.0);
        best.push(std::make_pair(label(4.2*pow3(r)), i));
    }
    while
    (
        open_.size() > error*points_.size() && centres_.size() < maxSpheres
     && !best.empty()
    )
    {
        const label i = best.top().second;
        best.pop();
        if (!allowed(i, growth))
        {
            continue;
        }
        const label now = gain(i);
        if (!best.empty() && now < best.top().first)
        {
            if (now > 0)
            {
                best.push(std::make_pair(now, i));
            }
            continue;
        }
        centres_.append(points_[i]);
        radii_.append(distances_[i]);
        DynamicList<label> left(open_.size());
        for (const label k : open_)
        {
            if (magSqr(points_[k] - points_[i]) > sqr(distances_[i]))
            {
                left.append(k);
            }
        }
        open_.transfer(left);
    }
}


void Foam::sphereFilling::grow()
{
    const auto at = [&](const scalar by)
    {
        scalarList radii(radii_);
        for (scalar& r : radii)
        {
            r += by;
        }
        return sphereUnion::volume(centres_, radii);
    };
    scalar low = 0;
    scalar high = Foam::cbrt(volume_);
    for (label n = 0; n < 30; ++n)
    {
        const scalar middle = 0.5*(low + high);
        (at(middle) < volume_ ? low : high) = middle;
    }
    for (scalar& r : radii_)
    {
        r += low;
    }
}


Foam::scalar Foam::sphereFilling::volumeError() const
{
    return sphereUnion::volume(centres_, radii_)/volume_ - 1;
}


namespace
{

using namespace Foam;

//- Distance of a point from the surface of the nearest sphere [m], negative inside
scalar distance
(
    const point& x,
    const UList<point>& centres,
    const UList<scalar>& radii
)
{
    scalar result = GREAT;
    forAll(centres, i)
    {
        result = min(result, mag(x - centres[i]) - radii[i]);
    }
    return result;
}

}


Foam::scalar Foam::sphereFilling::meanDistance() const
{
    scalar sum = 0;
    forAll(surface_, facei)
    {
        const point x(surface_[facei].centre(surface_.points()));
        sum +=
            mag(surface_[facei].areaNormal(surface_.points()))
           *sqr(distance(x, centres_, radii_));
    }
    return Foam::sqrt(sum/area_);
}


Foam::scalar Foam::sphereFilling::largestDistance() const
{
    scalar result = 0;
    for (const point& x : surface_.localPoints())
    {
        result = max(result, mag(distance(x, centres_, radii_)));
    }
    return result;
}


Foam::List<Foam::labelPair> Foam::sphereFilling::tree() const
{
    const label n = centres_.size();
    DynamicList<labelPair> result;
    labelList nearest(n, 0);
    boolList joined(n, false);
    for (label last = 0, k = 1; k < n; ++k)
    {
        // Of those left, the one that is nearest to the tree
        joined[last] = true;
        label next = -1;
        scalar least = GREAT;
        for (label i = 0; i < n; ++i)
        {
            if (joined[i])
            {
                continue;
            }
            if
            (
                mag(centres_[i] - centres_[last])
              < mag(centres_[i] - centres_[nearest[i]])
            )
            {
                nearest[i] = last;
            }
            const scalar d = mag(centres_[i] - centres_[nearest[i]]);
            if (d < least)
            {
                least = d;
                next = i;
            }
        }
        result.append(labelPair(nearest[next], next));
        last = next;
    }
    return List<labelPair>(result);
}
