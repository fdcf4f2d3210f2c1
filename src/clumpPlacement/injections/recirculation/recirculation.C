/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "recirculation.H"
#include "checkedEntries.H"

namespace Foam
{
namespace clumpInjections
{
    defineTypeNameAndDebug(recirculation, 0);
    addToRunTimeSelectionTable(injection, recirculation, dictionary);
}
}


Foam::clumpInjections::recirculation::recirculation
(
    const dictionary& dict,
    const site& s
)
:
    patchInjection(dict, s, false),
    from_(openPatches("from"))
{
    checkEntries(dict, placeEntries({"from"}));
    for (const clumpType& type : s.types)
    {
        if (type.hasTriangles() && dict.found("velocity"))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'velocity': " << type.name() << " is a membrane, which has no"
                << " inertia and enters with the velocity of the flow. Remove the entry."
                << exit(FatalIOError);
        }
    }
}


Foam::List<Foam::clumpCandidate> Foam::clumpInjections::recirculation::leaving
(
    const clumpCount& count
) const
{
    List<clumpCandidate> result;
    for (const clumpPassage& p : count.here())
    {
        const clumpType& type = site_.types[p.typeId];
        if (!p.entered && from_.found(p.patchi) && !type.isPiece())
        {
            clumpCandidate c;
            c.typeId = p.typeId;
            c.index = p.id;
            c.state.x = p.state.x - p.state.centre(type);
            c.state.q = p.state.q;
            c.state.broken = p.state.broken;
            result.append(c);
        }
    }
    gatherByIndex(result);
    return result;
}


Foam::clumpState Foam::clumpInjections::recirculation::shapeOf
(
    const label number,
    const clumpType& type,
    const quaternion& turn
) const
{
    const clumpCandidate& c = waiting_[number - first_];
    clumpState result(type, turn);
    forAll(result.x, i)
    {
        result.x[i] = turn.transform(c.state.x[i]);
        result.q[i] = turn*c.state.q[i];
    }
    result.broken = c.state.broken;
    return result;
}


Foam::scalar Foam::clumpInjections::recirculation::due
(
    const Cloud<clumpParcel>&,
    const clumpCount& count,
    const scalar
)
{
    DynamicList<clumpCandidate> waiting;
    for (label k = nInjected() - first_; k < waiting_.size(); ++k)
    {
        waiting.append(waiting_[k]);
    }
    first_ = nInjected();
    if (activeTime() > 0)
    {
        waiting.append(leaving(count));
    }
    waiting_.transfer(waiting);
    return nInjected() + waiting_.size();
}


void Foam::clumpInjections::recirculation::readState(const dictionary& state)
{
    patchInjection::readState(state);
    first_ = nInjected();
    waiting_.clear();
    const dictionary& shapes = state.subOrEmptyDict("shapes");
    for (const word& name : state.get<wordList>("waiting"))
    {
        clumpCandidate c;
        c.typeId = site_.typeIds[name];
        c.state = clumpState(site_.types[c.typeId]);
        const word shape("shape" + Foam::name(waiting_.size()));
        if (shapes.found(shape))
        {
            ITstream& is = shapes.lookup(shape);
            is.format(IOstream::ASCII);
            is >> c.state;
        }
        waiting_.append(c);
    }
}


void Foam::clumpInjections::recirculation::writeState(dictionary& state) const
{
    patchInjection::writeState(state);
    wordList waiting;
    dictionary shapes;
    for (label k = nInjected() - first_; k < waiting_.size(); ++k)
    {
        const clumpCandidate& c = waiting_[k];
        setExact(shapes, "shape" + Foam::name(waiting.size()), c.state);
        waiting.append(site_.types[c.typeId].name());
    }
    state.set("waiting", waiting);
    state.set("shapes", shapes);
}
