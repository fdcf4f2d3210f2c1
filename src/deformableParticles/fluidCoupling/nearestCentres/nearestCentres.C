/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "nearestCentres.H"
#include "boundBox.H"
#include "DynamicList.H"

namespace
{

using namespace Foam;

//- Equal boxes that divide the box of all points
class bins
{
    const boundBox box_;
    Vector<label> n_;
    vector width_;

public:

    bins(const UList<point>& points, const label nCentres)
    :
        box_(points, false),
        n_(1, 1, 1),
        width_(box_.span())
    {
        const vector span(max(width_, 1e-3*cmptMax(width_)*vector::one));
        const scalar wanted =
            Foam::cbrt(cmptProduct(span)/(4*max(nCentres, label(1))));
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            n_[d] = max(label(1), label(width_[d]/max(wanted, VSMALL)));
            width_[d] /= n_[d];
        }
    }

    label size() const { return cmptProduct(n_); }

    scalar halfDiagonal() const { return 0.5*mag(width_); }

    Vector<label> find(const point& x) const
    {
        Vector<label> i;
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            const scalar at = (x[d] - box_.min()[d])/max(width_[d], VSMALL);
            i[d] = min(max(label(at), label(0)), n_[d] - 1);
        }
        return i;
    }

    label number(const Vector<label>& i) const
    {
        return i.x() + n_.x()*(i.y() + n_.y()*i.z());
    }

    point centre(const Vector<label>& i) const
    {
        const vector at(i.x() + 0.5, i.y() + 0.5, i.z() + 0.5);
        return box_.min() + cmptMultiply(at, width_);
    }
};


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
    if (points.empty() || centres.empty())
    {
        return result;
    }
    const bins b(points, centres.size());
    List<DynamicList<label>> candidates(b.size());

    forAll(points, k)
    {
        const Vector<label> bin(b.find(points[k]));
        DynamicList<label>& near = candidates[b.number(bin)];
        if (near.empty())
        {
            findCandidates(centres, b.centre(bin), b.halfDiagonal(), near);
        }
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
    return result;
}
