/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "injection.H"
#include "DynamicList.H"
#include "FlatOutput.H"
#include "openPatches.H"

namespace Foam
{
    defineTypeNameAndDebug(injection, 0);
    defineRunTimeSelectionTable(injection, dictionary);
}


Foam::injection::injection(const dictionary& dict, const site& s)
:
    nInjected_(0),
    start_(getFiniteOrDefault<scalar>(dict, "start", -GREAT)),
    end_(getFiniteOrDefault<scalar>(dict, "end", GREAT)),
    velocity_(getFiniteOrDefault<vector>(dict, "velocity", Zero)),
    dict_(dict),
    site_(s)
{
    if (end_ < start_)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'end' is " << end_ << "; it must not be before start, "
            << start_ << '.' << exit(FatalIOError);
    }
}


void Foam::injection::warnOfEarlyStart() const
{
    const Time& time = site_.mesh.time();
    if
    (
        dict_.found("start")
     && start_ < time.value() - 1e-6*time.deltaTValue()
    )
    {
        IOWarningInFunction(dict_)
            << "Entry 'start' is " << start_ << " s, but the run starts at "
            << time.timeName() << " s: the injection begins then, and the clumps of"
            << " the time before are not made up for." << endl;
    }
}


Foam::wordList Foam::injection::entries(const wordList& others)
{
    wordList all({"type", "start", "end", "velocity", "minGap"});
    all.append(others);
    return all;
}


Foam::scalar Foam::injection::activeTime() const
{
    const scalar t = site_.mesh.time().value();
    const scalar before = t - site_.mesh.time().deltaTValue();
    return max(min(t, end_) - max(before, start_), scalar(0));
}


Foam::clumpCandidate Foam::injection::candidate
(
    const label typeId,
    const point& position,
    const clumpState& shape
) const
{
    const clumpType& type = site_.types[typeId];
    clumpCandidate c(newClump(type, typeId, position));
    c.state = shape;
    if (dict_.found("velocity"))
    {
        c.setVelocity(type, velocity_);
    }
    return c;
}


Foam::label Foam::injection::put
(
    const clumpCandidate& c,
    const label owner,
    const putAction& action
)
{
    ++nInjected_;
    return action(c, owner);
}


void Foam::injection::needVelocity(const dictionary& dict) const
{
    if (!site_.hasFluid && !dict.found("velocity"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'velocity' is missing, and there is no fluid whose velocity"
            << " the clumps could take." << exit(FatalIOError);
    }
}


Foam::labelHashSet Foam::injection::openPatches(const word& entry) const
{
    const polyBoundaryMesh& patches = site_.mesh.boundaryMesh();
    const label nPatches = patches.nNonProcessor();

    DynamicList<word> valid;
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const polyPatch& pp = patches[patchi];
        if (Foam::openPatches::isOpen(pp))
        {
            valid.append(pp.name());
        }
    }

    labelHashSet result;
    for (const word& name : getEntry<wordList>(dict_, entry))
    {
        if (!valid.found(name))
        {
            FatalIOErrorInFunction(dict_)
                << "Entry '" << entry << "': " << name << " is no open patch of"
                << " the mesh. Valid names: " << flatOutput(valid)
                << (valid.empty() ? ", as the mesh has no patch of type patch" : "")
                << exit(FatalIOError);
        }
        result.insert(patches.findPatchID(name));
    }
    if (result.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "Entry '" << entry << "' names no patch. Valid names: "
            << flatOutput(valid) << exit(FatalIOError);
    }
    return result;
}


Foam::boundBox Foam::injection::around(const boundBox& box) const
{
    scalar reach = 0;
    for (const clumpType& type : site_.types)
    {
        if (type.isPiece())
        {
            // Not injected
            continue;
        }
        reach = max(reach, type.reach());
    }
    return boundBox
    (
        box.min() - 4*reach*vector::one, box.max() + 4*reach*vector::one
    );
}


void Foam::injection::refuseMotion
(
    const boundBox& before,
    const boundBox& now
) const
{
    const scalar moved = max(mag(now.min() - before.min()), mag(now.max() - before.max()));
    if (moved > 1e-6*before.mag())
    {
        FatalIOErrorInFunction(dict_)
            << "At time " << site_.mesh.time().timeName() << " the points of the patches of"
            << " injection " << name() << " have moved by " << moved << " m. Clumps are"
            << " injected through patches that stand: let the motion of the mesh"
            << " (constant/dynamicMeshDict) leave them where they are."
            << exit(FatalIOError);
    }
}


Foam::labelList Foam::injection::storedLabels
(
    const dictionary& state,
    const word& entry
)
{
    ITstream& is = state.lookup(entry);
    is.format(IOstream::ASCII);
    return labelList(is);
}


void Foam::injection::readState(const dictionary& state)
{
    nInjected_ = state.get<label>("injected");
}


void Foam::injection::writeState(dictionary& state) const
{
    state.set("injected", nInjected_);
}
