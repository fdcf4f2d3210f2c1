/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStep.H"

namespace
{

using namespace Foam;

//- What takes the place of the overlap where the spheres of a clump face one gap: zero
//  at the range of what acts across it, and falling with the gap as fast as that does
scalar closeness(const scalar gap, const scalar range)
{
    const scalar x = 6*gap/range;
    return (x < 0 ? 1 - x : Foam::exp(-x)) - Foam::exp(scalar(-6));
}

}


void Foam::contactStep::setPairWeights(UList<sphereContact>& contacts) const
{
    List<contactWeights::pair> pairs(contacts.size());
    forAll(pairs, k)
    {
        const sphereContact& t = contacts[k];
        pairs[k] = {t.a, t.i, t.b, t.j, t.n, t.d, 1, t.d};
    }
    setWeights(pairs, contacts[0]);
    forAll(pairs, k)
    {
        contacts[k].weight = pairs[k].weight;
        contacts[k].ratio =
            pairs[k].overlap > 0 ? pairs[k].depth/pairs[k].overlap : 1;
    }
}


void Foam::contactStep::setGapWeights(UList<sphereContact>& contacts) const
{
    List<contactWeights::pair> pairs(contacts.size());
    forAll(pairs, k)
    {
        const sphereContact& t = contacts[k];
        pairs[k] =
        {
            t.a, t.i, t.b, t.j, t.n, closeness(-t.d, t.range), 1, 0
        };
    }
    setWeights(pairs, contacts[0]);
    forAll(pairs, k)
    {
        contacts[k].gapWeight = pairs[k].weight;
    }
}


void Foam::contactStep::setWeights
(
    UList<contactWeights::pair>& pairs,
    const sphereContact& t
) const
{
    const clumpImage& A = ghosts_.images()[t.a];
    const clumpImage& B = ghosts_.images()[t.b];
    contactWeights::set
    (
        pairs,
        pointField(A.x + moved_[t.a]), types_[A.typeId].radii(),
        places(t.b, t.otherIndex), types_[B.typeId].radii()
    );
}


void Foam::contactStep::setWallWeights
(
    const label a,
    DynamicList<sphereContact>& contacts
) const
{
    const clumpParcel& p = clumps_[a];
    const scalarField& r = type(a).radii();
    const pointField x(p.centres() + moved_[a]);

    // Films and planes that do not act yet stay; what seemed to act by a plane continued
    // beyond the wall does not. A part of a step may end where a contact begins
    const scalar least = inPart_ ? 1e-9*min(r) : 0;
    DynamicList<sphereContact> result;
    for (const sphereContact& t : contacts)
    {
        if (t.d <= least || !t.hasLaw)
        {
            result.append(t);
        }
    }
    for
    (
        const auto& c
      : contactWeights::findWallContacts(walls_.surface(), wallsNear_[a], x, r)
    )
    {
        if (c.wall.overlap <= least)
        {
            continue;
        }
        sphereContact t(makeWallContact(a, c.i, x[c.i], c.wall, c.wall.overlap));
        t.hasLaw = true;
        t.law = &walls_.laws()(p.typeId(), c.wall.patch);
        t.radii = t.d + fromWall(t, moved_[a][c.i]);
        t.first =
            t.radii
          - (inPart_ ? fromWall(t, before_[a][c.i]) : c.wall.moved & c.wall.normal);
        t.weight = c.weight;
        t.ratio = c.depth/c.wall.overlap;
        // The mass that the sphere had there before
        scalar m = GREAT;
        for (const sphereContact& former : contacts)
        {
            if (former.hasLaw && former.i == t.i)
            {
                m = min(m, former.m);
            }
        }
        t.m = m < GREAT ? m : t.m;
        result.append(t);
    }
    contacts.transfer(result);
}


void Foam::contactStep::distribute(const bool all)
{
    DynamicList<sphereContact> result;
    for (label a = 0; a < clumps_.size(); ++a)
    {
        const label end = begins_[a + 1];
        label k = begins_[a];
        begins_[a] = result.size();
        while (k < end)
        {
            label next = k + 1;
            while (next < end && sphereContacts_[next].b == sphereContacts_[k].b)
            {
                ++next;
            }
            DynamicList<sphereContact> contacts;
            contacts.append(UList<sphereContact>(&sphereContacts_[k], next - k));
            if ((all || isCoupled_[a]) && contacts[0].b < 0)
            {
                setWallWeights(a, contacts);
            }
            else if (all || isCoupled_[a])
            {
                setPairWeights(contacts);
                if (contacts[0].reaches)
                {
                    setGapWeights(contacts);
                }
            }
            result.append(contacts);
            k = next;
        }
    }
    begins_.last() = result.size();
    sphereContacts_.transfer(result);
}


bool Foam::contactStep::redistribute()
{
    // Change of the forces relative to their sum over the clump
    const scalar tolerance = 0.01;

    formerContacts_ = sphereContacts_;
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
    sphereContacts_.transfer(formerContacts_);
    begins_ = formerBegins_;
    renew_ = true;
    renewForces();
}
