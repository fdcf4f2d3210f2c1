/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStep.H"

Foam::point Foam::contactStep::centre
(
    const label image,
    const UList<point>& x
) const
{
    const scalarField& m = types_[ghosts_.images()[image].typeId].masses();
    return sum(m*pointField(x))/sum(m);
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
            const scalar overlap =
                t.radii - (wall ? fromWall(t, dx) : mag(before(t) + dx));
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
            const pointField own(ghosts_.images()[t.a].x + moved_[t.a]);
            result.virial +=
                half*t.w.force*(centre(t.a, own) - centre(t.b, ofOther(t)))*t.n;
        }
    }
    return result;
}
