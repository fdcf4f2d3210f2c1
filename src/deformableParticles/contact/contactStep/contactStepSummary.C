/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStep.H"
#include "mathematicalConstants.H"

Foam::point Foam::contactStep::centre
(
    const label image,
    const label index
) const
{
    const scalarField& m = types_[ghosts_.images()[image].typeId].masses();
    return sum(m*places(image, index))/sum(m);
}


Foam::contactSummary Foam::contactStep::summary() const
{
    contactSummary result;
    for (const label a : clumpOf_)
    {
        for (label k = begins_[a]; k < begins_[a + 1]; ++k)
        {
            const sphereContact& t = sphereContacts_[k];
            const scalar r = type(a).radii()[t.i];
            const bool wall = t.b < 0;
            const vector dx(displacement(t));
            vector n(Zero);
            const scalar overlap = this->overlap(t, n);
            if (wall)
            {
                // A plane beyond the edge of its wall is not touched. Beside an edge the
                // centre may be in the plane of a piece and far from the piece itself
                if (t.hasLaw)
                {
                    const point x(clumps_[a].centres()[t.i] + dx);
                    const bool behind = overlap >= r;
                    const scalar deep =
                        behind
                      ? overlap
                      : min(overlap, r - walls_.surface().distance(x, r));
                    result.deepestOfWall = max(result.deepestOfWall, deep/r);
                }
                continue;
            }

            // Two coupled clumps have half of the contact each
            const scalar half = isCoupled_[t.otherIndex] ? 0.5 : 1;
            if (overlap > 0)
            {
                result.deepest = max(result.deepest, overlap/min(r, otherRadius(t)));
                result.number += half;
            }

            // Forces across gaps are part of it
            result.virial +=
                half*t.w.force*(centre(t.a, t.a) - centre(t.b, t.otherIndex))*t.n;
        }
        for (label k = bondBegins_[a]; k < bondBegins_[a + 1]; ++k)
        {
            const bondEnd& e = bondEnds_[k];
            if (e.b >= 0)
            {
                result.virial +=
                    (isCoupled_[e.otherIndex] ? 0.5 : 1)
                   *(centre(a, a) - centre(e.b, e.otherIndex))*e.spring.force();
            }
        }
    }
    return result;
}


Foam::DynamicList<Foam::pairForces> Foam::contactStep::pairs() const
{
    // Gives walls a normal where nothing but bonds acts [N]
    constexpr scalar negligible = 1e-40;

    DynamicList<pairForces> result;
    for (const label a : clumpOf_)
    {
        const label id = clumps_[a].origId();
        DynamicList<pairForces> own;
        const auto with = [&](const label image) -> pairForces*
        {
            const label other = image < 0 ? -1 : ghosts_.images()[image].id.second();
            // A pair of two coupled clumps is that of the smaller number
            if (other >= 0 && other <= id && !types_[ghosts_.images()[image].typeId].fixed())
            {
                return nullptr;
            }
            for (pairForces& p : own)
            {
                if (p.second == other)
                {
                    return &p;
                }
            }
            own.append(pairForces());
            own.last().first = id;
            own.last().second = other;
            return &own.last();
        };
        for (label k = begins_[a]; k < begins_[a + 1]; ++k)
        {
            const sphereContact& t = sphereContacts_[k];
            const bool acts = t.w.force != 0 || t.d > 0 || t.pressed > 0;
            if (t.b >= 0 && !acts)
            {
                continue;
            }
            pairForces* p = with(t.b);
            if (!p)
            {
                continue;
            }
            scalar attraction = 0;
            if (t.reaches && max(t.d, t.first) > -t.range)
            {
                attraction =
                    t.gapWeight
                   *gaps_.potential
                    (
                        max(-t.d, inPart_ ? scalar(0) : -GREAT), t.gapR, placeOf(t)
                    ).force;
            }
            if (t.hasLaw)
            {
                p->area +=
                    constant::mathematical::pi*t.weight*t.R*max(t.d, scalar(0));
            }
            p->contact += t.pressing*t.n + t.sliding.force;
            p->attraction += attraction*t.n;
            p->film += (t.w.force - t.pressing - attraction)*t.n;
            p->direction +=
                t.b < 0
              ? vector((mag(t.w.force) + negligible)*t.n)
              : vector(centre(t.a, t.a) - centre(t.b, t.otherIndex));
        }
        for (label k = bondBegins_[a]; k < bondBegins_[a + 1]; ++k)
        {
            const bondEnd& e = bondEnds_[k];
            if (pairForces* p = with(e.b))
            {
                ++p->nBonds;
                p->bonds += e.spring.force();
                if (e.b >= 0)
                {
                    p->direction += centre(a, a) - centre(e.b, e.otherIndex);
                }
            }
        }
        for (pairForces& p : own)
        {
            p.direction /= max(mag(p.direction), VSMALL);
            if (p.acts())
            {
                result.append(p);
            }
        }
    }
    return result;
}
