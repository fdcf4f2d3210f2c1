/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpInjector.H"
#include "addToRunTimeSelectionTable.H"
#include "placement.H"
#include "surfaceCrossing.H"
#include "treeDataCell.H"

namespace Foam
{
    defineTypeNameAndDebug(clumpInjector, 0);
    addToRunTimeSelectionTable(clumpSource, clumpInjector, cloud);
}


Foam::clumpInjector::clumpInjector
(
    const word& cloudName,
    const dictionary& clumpProperties,
    const site& s
)
:
    clumpProperties_(clumpProperties),
    site_(s),
    state_
    (
        IOobject
        (
            cloudName + "Injection", s.mesh.time().timeName(), "uniform",
            s.mesh.time(), IOobject::READ_IF_PRESENT, IOobject::NO_WRITE
        )
    ),
    nextNumber_(state_.getOrDefault<label>("nextNumber", 0))
{
    if (!clumpProperties.found("injection"))
    {
        if (state_.size())
        {
            // Only the next number counts
            state_.clear();
            state_.set("nextNumber", nextNumber_);
            state_.writeOpt() = IOobject::AUTO_WRITE;
        }
        return;
    }
    const dictionary& all = getDict(clumpProperties, "injection");
    for (const word& name : all.toc())
    {
        injections_.append(selectModel<injection>(getDict(all, name), s));
    }
    waited_.setSize(injections_.size(), 0);
    state_.writeOpt() = IOobject::AUTO_WRITE;
}


void Foam::clumpInjector::place
(
    Cloud<clumpParcel>& clumps,
    labelHashSet& followFlow
) const
{
    selectModel<placement>
    (
        getDict(clumpProperties_, "placement"), site_.types, site_.typeIds
    )->place(site_.mesh, clumps, followFlow);
}


void Foam::clumpInjector::refuseOutside() const
{
    const dictionary& placement = getDict(clumpProperties_, "placement");
    const surfaceCrossing crossing(site_.mesh, site_.types, site_.ghosts, 0.01);
    if (crossing.outside())
    {
        FatalIOErrorInFunction(placement)
            << "Entry 'position': " << crossing.description().c_str()
            << exit(FatalIOError);
    }
    if (crossing.wide().size())
    {
        FatalIOErrorInFunction(placement)
            << "Entry 'position': " << crossing.wide().c_str() << " Spheres are rigid,"
            << " and this one can go nowhere. Check the units of the shape and the"
            << " scale of the mesh." << exit(FatalIOError);
    }
    if (crossing.nClumps())
    {
        IOWarningInFunction(placement)
            << crossing.nClumps() << " clumps start across a wall, a plane of"
            << " symmetry or an open patch; " << crossing.description().c_str() << endl;
    }
}


void Foam::clumpInjector::begin(const Cloud<clumpParcel>& clumps)
{
    label largest = -1;
    for (const clumpParcel& p : clumps)
    {
        largest = max(largest, p.origId());
    }
    nextNumber_ = max(nextNumber_, returnReduce(largest, maxOp<label>()) + 1);
    if (!injects())
    {
        return;
    }

    for (injection& i : injections_)
    {
        if (state_.found(i.name()))
        {
            i.readState(state_.subDict(i.name()));
        }
        else
        {
            i.warnOfEarlyStart();
            i.begin(clumps);
        }
    }
    writeState();
}


void Foam::clumpInjector::writeState()
{
    state_.set("nextNumber", nextNumber_);
    for (const injection& i : injections_)
    {
        dictionary state;
        i.writeState(state);
        state_.set(i.name(), state);
    }
}


Foam::label Foam::clumpInjector::newNumbers(const label n)
{
    const label first = nextNumber_;
    nextNumber_ += n;
    state_.writeOpt() = IOobject::AUTO_WRITE;
    writeState();
    return first;
}


Foam::label Foam::clumpInjector::add
(
    Cloud<clumpParcel>& clumps,
    const clumpCandidate& c,
    const label owner,
    clumpCount& count,
    labelHashSet& followFlow
)
{
    if (owner == Pstream::myProcNo())
    {
        const clumpParcel& p =
            c.enter(clumps, site_.mesh.findCell(c.position), nextNumber_);
        count.enter(p, c.patchi);
        if (c.followsFlow)
        {
            followFlow.insert(nextNumber_);
        }
    }
    return nextNumber_++;
}


Foam::label Foam::clumpInjector::inject
(
    Cloud<clumpParcel>& clumps,
    clumpCount& count,
    labelHashSet& followFlow
)
{
    if (!injects())
    {
        return 0;
    }
    const label before = nInjected();
    forAll(injections_, i)
    {
        injection& by = injections_[i];
        by.inject
        (
            clumps,
            count,
            [&](const clumpCandidate& c, const label owner)
            {
                return add(clumps, c, owner, count, followFlow);
            }
        );
        if (by.nWaiting() != waited_[i])
        {
            Info<< "Injection " << by.name() << ": ";
            if (by.nWaiting())
            {
                Info<< by.nWaiting() << " clumps wait for a free place" << endl;
            }
            else
            {
                Info<< "no clump waits any more" << endl;
            }
            waited_[i] = by.nWaiting();
        }
    }
    writeState();
    return nInjected() - before;
}


void Foam::clumpInjector::meshChanged()
{
    for (injection& i : injections_)
    {
        i.meshChanged();
    }
}


Foam::label Foam::clumpInjector::nInjected() const
{
    label n = 0;
    for (const injection& i : injections_)
    {
        n += i.nInjected();
    }
    return n;
}


Foam::label Foam::clumpInjector::nWaiting() const
{
    label n = 0;
    for (const injection& i : injections_)
    {
        n += i.nWaiting();
    }
    return n;
}
