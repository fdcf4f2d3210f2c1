/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pointGrid.H"
#include <algorithm>

Foam::pointGrid::pointGrid()
:
    n_(1, 1, 1),
    perLength_(Zero)
{
    update(pointField());
}


Foam::labelVector Foam::pointGrid::place(const point& p) const
{
    labelVector result;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        const scalar i = (p[d] - box_.min()[d])*perLength_[d];
        result[d] = label(min(max(i, scalar(0)), scalar(n_[d] - 1)));
    }
    return result;
}


void Foam::pointGrid::update(const UList<point>& points, const label nBins)
{
    const label wanted = nBins ? nBins : points.size();
    n_ = labelVector(1, 1, 1);
    perLength_ = Zero;
    box_ = boundBox::invertedBox;
    for (const point& p : points)
    {
        box_.add(p);
    }

    if (points.size())
    {
        // Bins as wide in all directions; the outermost points stand in their
        // middles, half a bin from the sides of the space that is theirs
        const vector span(box_.span());
        scalar width = cmptMax(span);
        for (label pass = 0; pass < 20; ++pass)
        {
            const vector space(span + width*vector::one);
            width = Foam::cbrt(cmptProduct(space)/wanted);
        }

        for (direction d = 0; d < vector::nComponents; ++d)
        {
            if (span[d] > width/2)
            {
                n_[d] = label(span[d]/width + 0.5) + 1;
                perLength_[d] = n_[d]/span[d];
            }
        }
    }

    // Count, then fill
    start_ = labelList(n_.x()*n_.y()*n_.z() + 1, Zero);
    for (const point& p : points)
    {
        ++start_[bin(place(p)) + 1];
    }
    for (label b = 1; b < start_.size(); ++b)
    {
        start_[b] += start_[b - 1];
    }

    labelList end(start_);
    points_.setSize(points.size());
    forAll(points, i)
    {
        points_[end[bin(place(points[i]))]++] = i;
    }
}


void Foam::pointGrid::find
(
    const boundBox& box,
    DynamicList<label>& found
) const
{
    found.clear();
    if (!box_.overlaps(box))
    {
        return;
    }

    const labelVector first(place(box.min()));
    const labelVector last(place(box.max()));
    labelVector i(first);
    for (i.z() = first.z(); i.z() <= last.z(); ++i.z())
    {
        for (i.y() = first.y(); i.y() <= last.y(); ++i.y())
        {
            i.x() = first.x();
            const label row = bin(i);
            const label end = start_[row + last.x() - first.x() + 1];
            for (label k = start_[row]; k < end; ++k)
            {
                found.append(points_[k]);
            }
        }
    }
    if (!std::is_sorted(found.begin(), found.end()))
    {
        std::sort(found.begin(), found.end());
    }
}
