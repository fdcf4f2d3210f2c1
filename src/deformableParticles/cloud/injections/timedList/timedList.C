/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "timedList.H"
#include "givenRotation.H"
#include "placement.H"
#include "treeDataCell.H"

namespace Foam
{
namespace clumpInjections
{
    defineTypeNameAndDebug(timedList, 0);
    addToRunTimeSelectionTable(injection, timedList, dictionary);
}
}


Foam::clumpInjections::timedList::timedList
(
    const dictionary& dict,
    const site& s
)
:
    injection(dict, s),
    nWaiting_(0)
{
    checkEntries(dict, {"type", "clumps", "minGap"});

    boundBox box(boundBox::invertedBox);
    s.mesh.cellTree();
    for (const dictionary& d : getDictList(dict, "clumps"))
    {
        checkEntries(d, {"type", "time", "position", "axis", "angle", "velocity"});
        needVelocity(d);
        const label typeId =
            placement::typeId(d, d.get<word>("type"), s.typeIds);
        const point position(getFinite<point>(d, "position"));
        clump c
        {
            getFinite<scalar>(d, "time"),
            candidate(typeId, position, givenRotation(d))
        };
        c.candidate.state.setRigidMotion
        (
            s.types[typeId], getFiniteOrDefault<vector>(d, "velocity", Zero), Zero
        );
        c.candidate.followsFlow = !d.found("velocity");
        if (returnReduce(s.mesh.findCell(position) < 0, andOp<bool>()))
        {
            FatalIOErrorInFunction(d)
                << "Entry 'position' is " << position << ", which lies outside"
                << " the mesh." << exit(FatalIOError);
        }
        c.candidate.index = clumps_.size();
        pending_.append(clumps_.size());
        clumps_.append(c);
        box.add(position);
    }
    places_.reset
    (
        new freePlaces
        (
            s.mesh, s.ghosts, s.types, labelHashSet(), around(box),
            getNonNegativeOrDefault(dict, "minGap", 0)
        )
    );
}


void Foam::clumpInjections::timedList::inject
(
    Cloud<clumpParcel>& clumps,
    const putAction& action
)
{
    // A sum of steps may end a little before a time that it should reach
    const scalar now =
        site_.mesh.time().value() + 1e-6*site_.mesh.time().deltaTValue();

    List<clumpCandidate> due;
    DynamicList<label> later;
    for (const label k : pending_)
    {
        if (clumps_[k].time <= now)
        {
            due.append(clumps_[k].candidate);
        }
        else
        {
            later.append(k);
        }
    }
    nWaiting_ = 0;
    if (due.empty())
    {
        return;
    }

    const labelList owners(places_->find(due, clumps, true));
    pending_.clear();
    forAll(due, k)
    {
        if (owners[k] >= 0)
        {
            put(due[k], owners[k], action);
        }
        else
        {
            pending_.append(due[k].index);
            ++nWaiting_;
        }
    }
    pending_.append(later);
}


void Foam::clumpInjections::timedList::begin(const Cloud<clumpParcel>&)
{
    const Time& time = site_.mesh.time();
    for (const clump& c : clumps_)
    {
        if (c.time < time.value() - 1e-6*time.deltaTValue())
        {
            FatalIOErrorInFunction(dict_)
                << "Entry 'time' is " << c.time << " s, before the start of the run"
                << " at " << time.timeName() << " s: the clump would enter late,"
                << " with the first step." << exit(FatalIOError);
        }
    }
}


void Foam::clumpInjections::timedList::readState(const dictionary& state)
{
    injection::readState(state);
    const labelList pending(storedLabels(state, "pending"));
    pending_.clear();
    for (const label k : pending)
    {
        if (k >= 0 && k < clumps_.size())
        {
            pending_.append(k);
        }
    }
}


void Foam::clumpInjections::timedList::writeState(dictionary& state) const
{
    injection::writeState(state);
    setExact(state, "pending", labelList(pending_));
}
