/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "halfSpaces.H"
#include <utility>

namespace
{

using namespace Foam;
using halfSpaces::heights;
using halfSpaces::set;

//- Put two in ascending order
inline void order(scalar& a, scalar& b)
{
    if (b < a)
    {
        std::swap(a, b);
    }
}


//- Fraction outside of one half space
scalar outsideOne(heights a)
{
    scalar* h = a.h;
    order(h[0], h[1]);
    order(h[2], h[3]);
    order(h[0], h[2]);
    order(h[1], h[3]);
    order(h[1], h[2]);

    if (h[0] >= 0)
    {
        return 1;
    }
    if (h[3] <= 0)
    {
        return 0;
    }

    // Share of the edge from corner i outside to corner j inside
    const auto t = [h](const label i, const label j)
    {
        return h[i]/(h[i] - h[j]);
    };

    if (h[1] >= 0)
    {
        return 1 - (1 - t(1, 0))*(1 - t(2, 0))*(1 - t(3, 0));
    }
    if (h[2] <= 0)
    {
        return t(3, 0)*t(3, 1)*t(3, 2);
    }

    // Two and two: cut along the edge from 2 to 0 first
    return
        t(2, 0)*(t(2, 1) + (1 - t(2, 1))*t(3, 1))
      + (1 - t(2, 0))*t(3, 0)*t(3, 1);
}


//- Fraction outside of the half spaces from the k-th on
scalar outside(const set& s, const label k)
{
    if (k == s.size - 1)
    {
        return outsideOne(s.spaces[k]);
    }

    const scalar* h = s.spaces[k].h;
    label high = 0, low = 0;
    for (label i = 1; i < 4; ++i)
    {
        high = h[i] > h[high] ? i : high;
        low = h[i] < h[low] ? i : low;
    }

    if (h[high] <= 0)
    {
        return 0;
    }
    if (h[low] >= 0)
    {
        return outside(s, k + 1);
    }

    // Split the edge between them where the height is zero
    const scalar t = h[high]/(h[high] - h[low]);
    set outer, inner;
    outer.size = inner.size = s.size;
    for (label j = k; j < s.size; ++j)
    {
        heights& out = outer.spaces[j];
        heights& in = inner.spaces[j];
        out = in = s.spaces[j];
        out.h[low] = in.h[high] = (1 - t)*in.h[high] + t*out.h[low];
    }
    outer.spaces[k].h[low] = inner.spaces[k].h[high] = 0;

    return t*outside(outer, k) + (1 - t)*outside(inner, k);
}

}


void Foam::halfSpaces::set::add(const heights& space)
{
    label kept = 0;
    for (label k = 0; k < size; ++k)
    {
        bool above = true, below = true;
        for (label i = 0; i < 4; ++i)
        {
            above = above && space.h[i] >= spaces[k].h[i];
            below = below && space.h[i] <= spaces[k].h[i];
        }
        if (above)
        {
            return;
        }
        if (!below)
        {
            spaces[kept++] = spaces[k];
        }
    }
    size = kept;
    if (size < maxSize)
    {
        spaces[size++] = space;
    }
}


Foam::scalar Foam::halfSpaces::outsideFraction(const set& spaces)
{
    return spaces.size ? outside(spaces, 0) : 1;
}
