/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "outline.H"
#include "bitSet.H"
#include "DynamicList.H"
#include <algorithm>
#include <cmath>

namespace
{

using namespace Foam;

using constant::mathematical::pi;
using constant::mathematical::twoPi;

//- How far the camera is turned [rad]
constexpr scalar turned = 1e-7;

scalar twiceArea(const vector2D& a, const vector2D& b)
{
    return a.x()*b.y() - a.y()*b.x();
}

vector2D unit(const scalar angle)
{
    return vector2D(Foam::cos(angle), Foam::sin(angle));
}

//- The angle plus whole turns, from 0 to 2 pi
scalar withinTurn(const scalar angle)
{
    const scalar within = std::fmod(angle, twoPi);
    return within < 0 ? within + twoPi : within;
}

outline::piece straight(const vector2D& from, const vector2D& to)
{
    return {from, to, Zero, 0, 0, 0};
}

outline::piece arc
(
    const vector2D& centre, const scalar radius, const scalar start, const scalar angle
)
{
    return
    {
        centre + radius*unit(start),
        centre + radius*unit(start + angle),
        centre, radius, start, angle
    };
}

//- A part of a circle, from one angle to a larger one
struct range
{
    scalar from, to;
};

}


void Foam::outline::sums::add(const piece& p)
{
    // The triangle between the piece and the origin
    const scalar twice = twiceArea(p.from, p.to);
    const auto squares = [&](const direction d)
    {
        return sqr(p.from[d]) + p.from[d]*p.to[d] + sqr(p.to[d]);
    };
    area += 0.5*twice;
    first += twice/6*(p.from + p.to);
    second += twice/12*vector2D(squares(0), squares(1));
    if (p.angle == 0)
    {
        length += mag(p.to - p.from);
        return;
    }

    // Between an arc and its chord, from the centre of the circle, along and across the
    // direction of the middle of the arc
    const scalar r2 = sqr(p.radius);
    const scalar s = Foam::sin(p.angle);
    const scalar s2 = sqr(Foam::sin(0.5*p.angle));
    const scalar triangle = 0.5*r2*s;
    const scalar A = 0.5*r2*p.angle - triangle;
    const scalar along = r2*r2/8*(p.angle + s) - 0.5*triangle*r2*(1 - s2);
    const scalar across = r2*r2/8*(p.angle - s) - triangle*r2*s2/6;
    const scalar middle = p.start + 0.5*p.angle;
    const vector2D e(Foam::cos(middle), Foam::sin(middle));
    const vector2D M(2.0/3.0*pow3(p.radius*Foam::sin(0.5*p.angle))*e);

    length += p.radius*p.angle;
    area += A;
    first += A*p.centre + M;
    for (direction d = 0; d < 2; ++d)
    {
        second[d] +=
            A*sqr(p.centre[d]) + 2*p.centre[d]*M[d]
          + along*sqr(e[d]) + across*(1 - sqr(e[d]));
    }
}


Foam::outline::outline(const UList<piece>& pieces)
{
    // Every piece begins where another one ends
    bitSet taken(pieces.size());
    forAll(pieces, begin)
    {
        if (taken.test(begin))
        {
            continue;
        }
        sums curve;
        label last = begin;
        while (last >= 0)
        {
            taken.set(last);
            curve.add(pieces[last]);
            label next = -1;
            scalar nearest = magSqr(pieces[begin].from - pieces[last].to);
            forAll(pieces, k)
            {
                const scalar distance = magSqr(pieces[k].from - pieces[last].to);
                if (!taken.test(k) && distance < nearest)
                {
                    nearest = distance;
                    next = k;
                }
            }
            last = next;
        }
        if (curve.area > 0)
        {
            sums_.area += curve.area;
            sums_.length += curve.length;
            sums_.first += curve.first;
            sums_.second += curve.second;
        }
    }
}


Foam::outline Foam::outline::ofDiscs
(
    const UList<vector2D>& centres,
    const UList<scalar>& radii
)
{
    DynamicList<piece> pieces;
    forAll(centres, i)
    {
        // What other discs cover, beginning with the one that begins first
        DynamicList<range> covered;
        bool hidden = false;
        forAll(centres, j)
        {
            const vector2D apart(centres[j] - centres[i]);
            const scalar d = mag(apart);
            const bool same = d == 0 && radii[j] == radii[i];
            if (i == j || d >= radii[i] + radii[j] || d + radii[j] < radii[i])
            {
                continue;
            }
            if (d + radii[i] <= radii[j])
            {
                hidden = hidden || !same || j < i;
                continue;
            }
            const scalar k =
                (sqr(radii[i]) + sqr(d) - sqr(radii[j]))/(2*radii[i]*d);
            const scalar half = std::acos(min(max(k, scalar(-1)), scalar(1)));
            const scalar from =
                withinTurn(std::atan2(apart.y(), apart.x()) - half);
            const scalar to = from + 2*half;
            covered.append(range{from, min(to, twoPi)});
            if (to > twoPi)
            {
                covered.append(range{0, to - twoPi});
            }
        }
        if (hidden)
        {
            continue;
        }
        std::sort
        (
            covered.begin(), covered.end(),
            [](const range& a, const range& b) { return a.from < b.from; }
        );
        scalar free = 0;
        for (const range& c : covered)
        {
            if (c.from > free)
            {
                pieces.append(arc(centres[i], radii[i], free, c.from - free));
            }
            free = max(free, c.to);
        }
        if (free < twoPi)
        {
            pieces.append(arc(centres[i], radii[i], free, twoPi - free));
        }
    }
    return outline(pieces);
}


Foam::outline Foam::outline::ofSurface
(
    const closedSurface& surface,
    const pointField& x,
    const vector& e1,
    const vector& e2
)
{
    const vector e3(e1 ^ e2);
    const vector ex(e1 + turned*e3);
    const vector ey(e2 + 0.618*turned*e3);
    List<vector2D> p(x.size());
    forAll(p, i)
    {
        const vector d(x[i] - x[0]);
        p[i] = vector2D(d & ex, d & ey);
    }

    // The silhouette, with what faces the camera on its left
    DynamicList<edge> edges;
    const auto faces = [&](const label i, const label j, const label k)
    {
        return twiceArea(p[j] - p[i], p[k] - p[i]) > 0;
    };
    for (const closedSurface::hinge& h : surface.hinges())
    {
        const bool left = faces(h.i, h.j, h.left);
        if (left != faces(h.j, h.i, h.right))
        {
            edges.append(left ? edge(h.i, h.j) : edge(h.j, h.i));
        }
    }

    DynamicList<piece> pieces;
    for (const edge& e : edges)
    {
        const vector2D along(p[e.last()] - p[e.first()]);
        if (mag(along) < VSMALL)
        {
            continue;
        }

        // Where others cross it
        DynamicList<scalar> cuts;
        cuts.append(0);
        cuts.append(1);
        for (const edge& o : edges)
        {
            const vector2D other(p[o.last()] - p[o.first()]);
            const vector2D apart(p[o.first()] - p[e.first()]);
            const scalar area = twiceArea(along, other);
            if (area != 0 && e.commonVertex(o) < 0)
            {
                const scalar here = twiceArea(apart, other)/area;
                const scalar there = twiceArea(apart, along)/area;
                if (here > 0 && here < 1 && there >= 0 && there <= 1)
                {
                    cuts.append(here);
                }
            }
        }
        std::sort(cuts.begin(), cuts.end());

        const vector2D t(along/mag(along));
        const vector2D right(t.y(), -t.x());
        for (label k = 1; k < cuts.size(); ++k)
        {
            const vector2D middle
            (
                p[e.first()] + 0.5*(cuts[k - 1] + cuts[k])*along
            );
            label winding = 0;
            for (const edge& o : edges)
            {
                const vector2D a(p[o.first()] - middle);
                const vector2D b(p[o.last()] - middle);
                const scalar ta = a & t;
                const scalar tb = b & t;
                if (&o != &e && (ta > 0) != (tb > 0))
                {
                    const scalar part = ta/(ta - tb);
                    if ((((1 - part)*a + part*b) & right) > 0)
                    {
                        winding += tb > ta ? 1 : -1;
                    }
                }
            }
            if (winding == 0 && cuts[k] > cuts[k - 1])
            {
                pieces.append
                (
                    straight
                    (
                        p[e.first()] + cuts[k - 1]*along,
                        p[e.first()] + cuts[k]*along
                    )
                );
            }
        }
    }
    return outline(pieces);
}


Foam::outline Foam::outline::hull
(
    const UList<vector2D>& centres,
    const UList<scalar>& radii
)
{
    outline result;
    if (centres.empty())
    {
        return result;
    }

    // From the disc that is outermost along x to the one that is it next, in one turn. Of
    // several at once, the farthest follows
    constexpr scalar atOnce = 1e-9;
    label i = 0;
    forAll(centres, k)
    {
        if (centres[k].x() + radii[k] > centres[i].x() + radii[i])
        {
            i = k;
        }
    }
    const auto outermost = [&](const label k, const scalar angle)
    {
        return centres[k] + radii[k]*unit(angle);
    };
    const vector2D begin(outermost(i, 0));
    scalar angle = 0;
    label next = i;
    for (label n = 0; n < 4*centres.size() && next >= 0; ++n)
    {
        next = -1;
        scalar turn = twoPi - angle;
        scalar farthest = 0;
        forAll(centres, k)
        {
            const vector2D apart(centres[k] - centres[i]);
            const scalar d = mag(apart);
            const scalar difference = radii[i] - radii[k];
            if (k == i || d <= (1 + SMALL)*mag(difference))
            {
                continue;
            }
            const scalar entry =
                std::atan2(apart.y(), apart.x()) - std::acos(difference/d);
            scalar needed = withinTurn(entry - angle);
            if (needed > twoPi - atOnce)
            {
                needed = 0;
            }
            const bool atLast = needed < turn + atOnce && next >= 0 && d > farthest;
            if (needed < turn - atOnce || atLast)
            {
                next = k;
                turn = min(turn, needed);
                farthest = d;
            }
        }
        if (turn > 0 && radii[i] > 0)
        {
            result.sums_.add(arc(centres[i], radii[i], angle, turn));
        }
        angle += turn;
        if (next >= 0)
        {
            result.sums_.add(straight(outermost(i, angle), outermost(next, angle)));
            i = next;
        }
    }
    result.sums_.add(straight(outermost(i, 0), begin));
    return result;
}
