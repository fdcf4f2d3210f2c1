/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStep.H"

void Foam::contactStep::sharePairs(UList<touch>& ofTwo) const
{
    List<contactShares::pair> pairs(ofTwo.size());
    forAll(pairs, k)
    {
        const touch& t = ofTwo[k];
        pairs[k] = {t.a, t.i, t.b, t.j, t.n, t.d, 1, t.d};
    }
    const clumpImage& A = ghosts_.images()[ofTwo[0].a];
    const clumpImage& B = ghosts_.images()[ofTwo[0].b];
    contactShares::set
    (
        pairs,
        pointField(A.x + moved_[ofTwo[0].a]), types_[A.typeId].radii(),
        pointField(B.x + moved_[ofTwo[0].slot]), types_[B.typeId].radii()
    );
    forAll(pairs, k)
    {
        ofTwo[k].share = pairs[k].share;
        ofTwo[k].ratio =
            pairs[k].overlap > 0 ? pairs[k].depth/pairs[k].overlap : 1;
    }
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

    // Planes that do not act yet stay; what seemed to act by a plane continued
    // beyond the wall does not
    DynamicList<touch> result;
    for (const touch& t : ofClump)
    {
        if (t.d <= 0)
        {
            result.append(t);
        }
    }
    for (const auto& c : contactShares::ofWalls(walls_.surface(), x, r))
    {
        touch t = touch();
        t.a = a;
        t.i = c.i;
        t.b = -1;
        t.j = -1;
        t.slot = -1;
        t.n = c.wall.normal;
        t.d = c.wall.overlap;
        t.radii = t.d + (t.n & moved_[a][c.i]);
        t.first = t.radii;
        t.R = r[c.i];
        t.m = massAt(a, c.i);
        t.share = c.share;
        t.ratio = c.depth/c.wall.overlap;
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

    evaluate();
    const DynamicList<touch> touches(touches_);
    const labelList begins(begins_);
    const List<vectorField> forces(forces_);

    distribute(false);
    evaluate();
    bool changed = false;
    forAll(forces_, m)
    {
        changed =
            changed
         || sum(mag(forces_[m] - forces[m])) > tolerance*sum(mag(forces[m]));
    }
    if (returnReduce(changed, orOp<bool>()))
    {
        return true;
    }
    touches_ = touches;
    begins_ = begins;
    evaluate();
    return false;
}
