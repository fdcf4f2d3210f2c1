/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStep.H"

namespace
{

using namespace Foam;

//- What takes the place of the overlap where spheres share a gap: zero at the range of
//  what acts across it, and falling with the gap as fast as that does
scalar closeness(const scalar gap, const scalar range)
{
    const scalar x = 6*gap/range;
    return (x < 0 ? 1 - x : Foam::exp(-x)) - Foam::exp(scalar(-6));
}

}


void Foam::contactStep::sharePairs(UList<touch>& ofTwo) const
{
    List<contactShares::pair> pairs(ofTwo.size());
    forAll(pairs, k)
    {
        const touch& t = ofTwo[k];
        pairs[k] = {t.a, t.i, t.b, t.j, t.n, t.d, 1, t.d};
    }
    setShares(pairs, ofTwo[0]);
    forAll(pairs, k)
    {
        ofTwo[k].share = pairs[k].share;
        ofTwo[k].ratio =
            pairs[k].overlap > 0 ? pairs[k].depth/pairs[k].overlap : 1;
    }
}


void Foam::contactStep::shareGaps(UList<touch>& ofTwo) const
{
    List<contactShares::pair> pairs(ofTwo.size());
    forAll(pairs, k)
    {
        const touch& t = ofTwo[k];
        pairs[k] =
        {
            t.a, t.i, t.b, t.j, t.n, closeness(-t.d, t.range), 1, 0
        };
    }
    setShares(pairs, ofTwo[0]);
    forAll(pairs, k)
    {
        ofTwo[k].gapShare = pairs[k].share;
    }
}


void Foam::contactStep::setShares
(
    UList<contactShares::pair>& pairs,
    const touch& t
) const
{
    const clumpImage& A = ghosts_.images()[t.a];
    const clumpImage& B = ghosts_.images()[t.b];
    contactShares::set
    (
        pairs,
        pointField(A.x + moved_[t.a]), types_[A.typeId].radii(),
        pointField(B.x + moved_[t.slot]), types_[B.typeId].radii()
    );
}


void Foam::contactStep::shareWalls
(
    const label a,
    DynamicList<touch>& ofClump
) const
{
    const clumpParcel& p = clumps_[a];
    const scalarField& r = type(a).radii();
    const pointField x(p.centres() + moved_[a]);

    // Films and planes that do not act yet stay; what seemed to act by a plane continued
    // beyond the wall does not. A part of a step may end where a contact begins
    const scalar least = inPart_ ? 1e-9*min(r) : 0;
    DynamicList<touch> result;
    for (const touch& t : ofClump)
    {
        if (t.d <= least || !t.touches)
        {
            result.append(t);
        }
    }
    for
    (
        const auto& c
      : contactShares::ofWalls(walls_.surface(), wallsNear_[a], x, r)
    )
    {
        if (c.wall.overlap <= least)
        {
            continue;
        }
        touch t(ofWall(a, c.i, x[c.i], c.wall, c.wall.overlap));
        t.touches = true;
        t.law = &walls_.laws()(p.typeId(), c.wall.patch);
        t.radii = t.d + fromWall(t, moved_[a][c.i]);
        t.first =
            t.radii - (inPart_ ? fromWall(t, before_[a][c.i]) : 0);
        t.share = c.share;
        t.ratio = c.depth/c.wall.overlap;
        // The mass that the sphere had there before
        scalar m = GREAT;
        for (const touch& former : ofClump)
        {
            if (former.touches && former.i == t.i)
            {
                m = min(m, former.m);
            }
        }
        t.m = m < GREAT ? m : t.m;
        result.append(t);
    }
    ofClump.transfer(result);
}


void Foam::contactStep::distribute(const bool all)
{
    DynamicList<touch> result;
    for (label a = 0; a < clumps_.size(); ++a)
    {
        const label end = begins_[a + 1];
        label k = begins_[a];
        begins_[a] = result.size();
        while (k < end)
        {
            label next = k + 1;
            while (next < end && touches_[next].b == touches_[k].b)
            {
                ++next;
            }
            DynamicList<touch> ofOne;
            ofOne.append(UList<touch>(&touches_[k], next - k));
            if ((all || isMember_[a]) && ofOne[0].b < 0)
            {
                shareWalls(a, ofOne);
            }
            else if (all || isMember_[a])
            {
                sharePairs(ofOne);
                if (ofOne[0].reaches)
                {
                    shareGaps(ofOne);
                }
            }
            result.append(ofOne);
            k = next;
        }
    }
    begins_.last() = result.size();
    touches_.transfer(result);
}


bool Foam::contactStep::redistribute()
{
    // Change of the forces relative to their sum over the clump
    const scalar tolerance = 0.01;

    formerTouches_ = touches_;
    formerBegins_ = begins_;
    const List<vectorField> forces(forces_);

    bool changed = rubs_ && smoothing_ > 1;
    smoothing_ = max(0.1*smoothing_, scalar(1));
    distribute(false);
    renew_ = true;
    renewForces();
    if (rubs_)
    {
        setPressed();
        renew_ = true;
        renewForces();
    }
    forAll(forces_, m)
    {
        changed =
            changed
         || sum(mag(forces_[m] - forces[m])) > tolerance*sum(mag(forces[m]));
    }
    return changed;
}


void Foam::contactStep::restore()
{
    touches_.transfer(formerTouches_);
    begins_ = formerBegins_;
    renew_ = true;
    renewForces();
}
