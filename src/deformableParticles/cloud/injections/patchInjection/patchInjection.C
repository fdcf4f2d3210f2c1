/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "patchInjection.H"
#include "givenRotation.H"
#include "Hasher.H"
#include "placement.H"
#include "surfaceFields.H"
#include "uniformRotation.H"
#include <cmath>

namespace
{

using namespace Foam;

//- True for flux, false for uniform
bool readWeighting(const dictionary& dict)
{
    const word given(dict.getOrDefault<word>("weighting", "flux"));
    const HashTable<label> choices({{"uniform", 0}, {"flux", 1}});
    if (!choices.found(given))
    {
        FatalIOErrorInLookup(dict, "weighting", given, choices)
            << exit(FatalIOError);
    }
    return choices[given];
}

}


Foam::patchInjection::patchInjection(const dictionary& dict, const site& s)
:
    injection(dict, s),
    patches_(openPatches("patches")),
    lines_(s.mesh, patches_),
    places_
    (
        s.mesh, s.ghosts, s.types, patches_, around(lines_.box()),
        getNonNegativeOrDefault(dict, "minGap", 0)
    ),
    shares_(placement::shares(dict, s.types, s.typeIds)),
    byFlux_(readWeighting(dict)),
    nTries_
    (
        getNumberOrDefault(dict, "nTries", 100, 1, 100000)
    ),
    turned_(dict.found("axis") || dict.found("angle")),
    turn_(givenRotation(dict)),
    seed_(dict.get<label>("seed")),
    due_(0),
    nBatches_(0)
{
    needVelocity(dict);
    forAll(shares_, typei)
    {
        if (shares_[typei] > 0 && s.types[typei].fixed())
        {
            FatalIOErrorInFunction(dict)
                << "Clumps of type " << s.types[typei].name()
                << " do not move; they cannot be injected." << exit(FatalIOError);
        }
    }
}


Foam::wordList Foam::patchInjection::entries(const wordList& others)
{
    wordList all
    ({
        "patches", "weighting", "nTries", "clumpType", "fractions", "axis",
        "angle", "seed"
    });
    all.append(others);
    return injection::entries(all);
}


Foam::Random Foam::patchInjection::random
(
    const label purpose,
    const label counter
) const
{
    const label numbers[] = {seed_, purpose, counter};
    const word me(name());
    const unsigned hash = Hasher
    (
        numbers, sizeof(numbers), Hasher(me.c_str(), me.size())
    );
    return Random(label(hash & 0x7fffffff));
}


Foam::label Foam::patchInjection::nextType() const
{
    return placement::typeAt
    (
        shares_, random(0, nInjected()).sample01<scalar>()
    );
}


Foam::scalarField Foam::patchInjection::chances() const
{
    const polyMesh& mesh = site_.mesh;
    const label first = mesh.nInternalFaces();
    scalarField result(mesh.nFaces() - first, Zero);
    const auto* phi = mesh.findObject<surfaceScalarField>("phi");

    scalar largest = 0;
    for (const label patchi : patches_)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            scalar& chance = result[facei - first];
            chance =
                byFlux_ && phi
              ? max(-phi->boundaryField()[patchi][i], scalar(0))
               /mag(mesh.faceAreas()[facei])
              : scalar(1);
            largest = max(largest, chance);
        }
    }
    reduce(largest, maxOp<scalar>());
    if (largest > 0)
    {
        result /= largest;
    }
    return result;
}


Foam::scalar Foam::patchInjection::inflow() const
{
    const auto* phi = site_.mesh.findObject<surfaceScalarField>("phi");
    scalar sum = 0;
    for (const label patchi : patches_)
    {
        sum -= phi ? Foam::sum(phi->boundaryField()[patchi]) : scalar(0);
    }
    return max(returnReduce(sum, sumOp<scalar>()), scalar(0));
}


Foam::scalar Foam::patchInjection::meanVolume() const
{
    scalar result = 0;
    forAll(shares_, typei)
    {
        result += shares_[typei]*site_.types[typei].nominalVolume();
    }
    return result;
}


Foam::label Foam::patchInjection::nWaiting() const
{
    // A sum of rates over the steps is a little below the whole number
    return max(label(std::floor(due_ + 1e-6)) - nInjected(), 0);
}


void Foam::patchInjection::inject
(
    Cloud<clumpParcel>& clumps,
    const putAction& action
)
{
    due_ = due(clumps, due_);
    while (nWaiting() > 0 && injectOne(clumps, action))
    {}
}


bool Foam::patchInjection::injectOne
(
    Cloud<clumpParcel>& clumps,
    const putAction& action
)
{
    const label typeId = nextType();
    const clumpType& type = site_.types[typeId];
    Random numbers(random(1, nBatches_++));

    const scalarField weights(chances());
    const label first = site_.mesh.nInternalFaces();
    const List<patchLines::hit> hits
    (
        lines_.shoot
        (
            nTries_, numbers,
            [&](const label facei) { return weights[facei - first]; }
        )
    );

    // Touching the plane of the face; freePlaces moves it farther where the patch
    // is curved
    DynamicList<clumpCandidate> candidates;
    for (const patchLines::hit& h : hits)
    {
        const quaternion turn(turned_ ? turn_ : uniformRotation(numbers));
        if (h.place < GREAT)
        {
            candidates.append
            (
                candidate(typeId, h.x, turn)
            );
            clumpCandidate& c = candidates.last();
            c.patchi = h.patchi;
            c.inwards = h.inwards;
            c.position += max(type.radii() - (c.state.x & c.inwards))*c.inwards;
        }
    }

    const labelList owners(places_.find(candidates, clumps, false));
    forAll(owners, k)
    {
        if (owners[k] >= 0)
        {
            put(candidates[k], owners[k], action);
            return true;
        }
    }
    return false;
}


void Foam::patchInjection::meshChanged()
{
    lines_.update();
    places_.clear();
}


void Foam::patchInjection::readState(const dictionary& state)
{
    injection::readState(state);
    due_ = state.get<scalar>("due");
    nBatches_ = state.get<label>("batches");
}


void Foam::patchInjection::writeState(dictionary& state) const
{
    injection::writeState(state);
    setExact(state, "due", due_);
    state.set("batches", nBatches_);
}
