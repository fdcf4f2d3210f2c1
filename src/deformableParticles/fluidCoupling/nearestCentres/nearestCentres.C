/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "nearestCentres.H"
#include "pointGrid.H"

namespace
{

using namespace Foam;

//- The centres that may be nearest to a point within d of x and are not beyond the
//  reach of it. width: of the first search [m]
void findCandidates
(
    const UList<point>& centres,
    const pointGrid& grid,
    const point& x,
    const scalar d,
    const scalar reach,
    const scalar width,
    DynamicList<label>& candidates,
    label& nCompared
)
{
    const auto search = [&](const scalar r)
    {
        const vector half(r*vector::one);
        grid.find(boundBox(x - half, x + half), candidates);
        nCompared += candidates.size();
    };

    // The nearest of those in a box is the nearest of all when it is not farther
    // than the sides of the box
    const scalar farthest = (reach + d)*(1 + SMALL);
    scalar least = GREAT;
    for (scalar r = min(width, farthest); ; r = min(2*r, farthest))
    {
        search(r);
        for (const label i : candidates)
        {
            least = min(least, mag(centres[i] - x));
        }
        if (least <= r || r >= farthest)
        {
            break;
        }
    }
    if (least > farthest)
    {
        candidates.clear();
        return;
    }

    search((least + 2*d)*(1 + 10*SMALL));
    label n = 0;
    for (const label i : candidates)
    {
        if (mag(centres[i] - x) <= least + 2*d*(1 + SMALL))
        {
            candidates[n++] = i;
        }
    }
    candidates.setSize(n);
}

}


Foam::labelList Foam::nearestCentres
(
    const UList<point>& points,
    const UList<point>& centres,
    const scalar reach,
    label* nCompared
)
{
    label n = 0;
    labelList result(points.size(), -1);
    if (nCompared)
    {
        *nCompared = 0;
    }
    if (centres.empty())
    {
        return result;
    }
    pointGrid grid, ofCentres;
    grid.update(points, 4*centres.size());
    ofCentres.update(centres);
    const boundBox around(centres, false);
    const scalar width = Foam::cbrt
    (
        cmptProduct(max(around.span(), 1e-3*reach*vector::one))/centres.size()
    );
    DynamicList<label> near;

    for (label b = 0; b < grid.nBins(); ++b)
    {
        const SubList<label> inBin(grid.inBin(b));
        if (inBin.empty())
        {
            continue;
        }
        boundBox box(boundBox::invertedBox);
        for (const label k : inBin)
        {
            box.add(points[k]);
        }
        findCandidates
        (
            centres, ofCentres, box.midpoint(), 0.5*mag(box.span()), reach, width,
            near, n
        );
        n += near.size()*inBin.size();

        for (const label k : inBin)
        {
            scalar least = sqr(reach);
            for (const label i : near)
            {
                const scalar d = magSqr(centres[i] - points[k]);
                if (d < least)
                {
                    least = d;
                    result[k] = i;
                }
            }
        }
    }
    if (nCompared)
    {
        *nCompared = n;
    }
    return result;
}
