/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "recirculation.H"

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


Foam::labelList Foam::clumpInjections::recirculation::left
(
    const clumpCount& count
) const
{
    labelList result(site_.types.size(), Zero);
    forAll(result, typei)
    {
        const clumpType& type = site_.types[typei];
        for (const label patchi : from_)
        {
            const word& patch = site_.mesh.boundaryMesh()[patchi].name();
            result[typei] += type.isPiece() ? 0 : count.left(patch, type.name());
        }
    }
    return result;
}


Foam::scalar Foam::clumpInjections::recirculation::due
(
    const Cloud<clumpParcel>&,
    const clumpCount& count,
    const scalar
)
{
    DynamicList<label> waiting;
    for (label k = nInjected() - first_; k < waiting_.size(); ++k)
    {
        waiting.append(waiting_[k]);
    }
    first_ = nInjected();

    // Types of pieces come during the run
    const labelList now(left(count));
    const bool counts = counted_.size() && activeTime() > 0;
    counted_.setSize(now.size(), 0);
    forAll(now, typei)
    {
        for (label k = counted_[typei]; counts && k < now[typei]; ++k)
        {
            waiting.append(typei);
        }
    }
    counted_ = now;
    waiting_.transfer(waiting);
    return nInjected() + waiting_.size();
}


void Foam::clumpInjections::recirculation::readState(const dictionary& state)
{
    patchInjection::readState(state);
    const dictionary& counted = state.subDict("counted");
    counted_.setSize(site_.types.size());
    forAll(counted_, typei)
    {
        counted_[typei] =
            counted.getOrDefault<label>(site_.types[typei].name(), 0);
    }
    first_ = nInjected();
    waiting_.clear();
    for (const word& name : state.get<wordList>("waiting"))
    {
        waiting_.append(site_.typeIds[name]);
    }
}


void Foam::clumpInjections::recirculation::writeState(dictionary& state) const
{
    patchInjection::writeState(state);
    dictionary counted;
    forAll(counted_, typei)
    {
        counted.set(site_.types[typei].name(), counted_[typei]);
    }
    state.set("counted", counted);

    wordList waiting;
    for (label k = nInjected() - first_; k < waiting_.size(); ++k)
    {
        waiting.append(site_.types[waiting_[k]].name());
    }
    state.set("waiting", waiting);
}
