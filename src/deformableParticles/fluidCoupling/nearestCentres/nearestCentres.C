/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "nearestCentres.H"
#include "pointGrid.H"

namespace
{

using namespace Foam;

//- The centres that may be nearest to a point within d of x
void findCandidates
(
    const UList<point>& centres,
    const point& x,
    const scalar d,
    DynamicList<label>& candidates
)
{
    scalar least = GREAT;
    for (const point& c : centres)
    {
        least = min(least, mag(c - x));
    }
    candidates.clear();
    forAll(centres, i)
    {
        if (mag(centres[i] - x) <= least + 2*d*(1 + SMALL))
        {
            candidates.append(i);
        }
    }
}

}


Foam::labelList Foam::nearestCentres
(
    const UList<point>& points,
    const UList<point>& centres,
    const scalar reach
)
{
    labelList result(points.size(), -1);
    if (centres.empty())
    {
        return result;
    }
    pointGrid grid;
    grid.update(points, 4*centres.size());
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
        findCandidates(centres, box.midpoint(), 0.5*mag(box.span()), near);

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
    return result;
}
