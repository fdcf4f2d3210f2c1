/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "patchInjection.H"
#include "FlatOutput.H"
#include "foamCompat.H"
#include "givenRotation.H"
#include "placement.H"
#include "randomSeed.H"
#include "surfaceFields.H"
#include "volFields.H"
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


Foam::patchInjection::patchInjection
(
    const dictionary& dict,
    const site& s,
    const bool ofTypes
)
:
    injection(dict, s),
    patches_(openPatches("patches")),
    lines_(s.mesh, patches_),
    box_(lines_.box()),
    places_
    (
        s.mesh, s.ghosts, s.types, patches_, around(lines_.box()),
        getNonNegativeOrDefault(dict, "minGap", 0)
    ),
    fractions_
    (
        ofTypes
      ? placement::fractions(dict, s.types, s.typeIds)
      : scalarList(s.types.size(), Zero)
    ),
    byFlux_(readWeighting(dict)),
    nTries_
    (
        getNumberOrDefault(dict, "nTries", 100, 1, 100000)
    ),
    turned_(dict.found("axis") || dict.found("angle")),
    turn_(givenRotation(dict)),
    seed_(getEntry<label>(dict, "seed")),
    due_(0),
    nBatches_(0),
    nAtOnce_(1)
{
    needVelocity(dict);
    forAll(fractions_, typei)
    {
        if (fractions_[typei] > 0 && s.types[typei].fixed())
        {
            FatalIOErrorInFunction(dict)
                << "Clumps of type " << s.types[typei].name()
                << " do not move; they cannot be injected." << exit(FatalIOError);
        }
        if
        (
            fractions_[typei] > 0
         && s.types[typei].hasTriangles()
         && dict.found("velocity")
        )
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'velocity': " << s.types[typei].name() << " is a membrane, which"
                << " has no inertia and enters with the velocity of the flow. Remove"
                << " the entry." << exit(FatalIOError);
        }
    }
}


Foam::wordList Foam::patchInjection::placeEntries(const wordList& others)
{
    wordList all({"patches", "weighting", "nTries", "axis", "angle", "seed"});
    all.append(others);
    return injection::entries(all);
}


Foam::wordList Foam::patchInjection::entries(const wordList& others)
{
    wordList all({"clumpType", "fractions"});
    all.append(others);
    return placeEntries(all);
}


Foam::Random Foam::patchInjection::random
(
    const label purpose,
    const label counter
) const
{
    return Random(randomSeed(name(), seed_, purpose, counter));
}


Foam::label Foam::patchInjection::typeOf(const label number) const
{
    return placement::typeAt
    (
        fractions_, random(0, number).sample01<scalar>()
    );
}


Foam::clumpState Foam::patchInjection::shapeOf
(
    const label,
    const clumpType& type,
    const quaternion& turn
) const
{
    return clumpState(type, turn);
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

    // Of several patches each one has its part of the inflow, also one through which
    // fluid leaves elsewhere
    const scalar all = sum(flows_);
    if (byFlux_ && phi && flows_.size() > 1 && all > 0)
    {
        largest = 0;
        label k = 0;
        for (const label patchi : patches_)
        {
            const polyPatch& patch = mesh.boundaryMesh()[patchi];
            SubList<scalar> ofPatch(result, patch.size(), patch.start() - first);
            scalar gross = 0;
            forAll(patch, i)
            {
                gross += ofPatch[i]*mag(mesh.faceAreas()[patch.start() + i]);
            }
            reduce(gross, sumOp<scalar>());
            const scalar part = gross > 0 ? flows_[k]/gross : scalar(0);
            for (scalar& chance : ofPatch)
            {
                chance *= part;
                largest = max(largest, chance);
            }
            ++k;
        }
        reduce(largest, maxOp<scalar>());
    }
    if (largest > 0)
    {
        result /= largest;
    }
    return result;
}


void Foam::patchInjection::findFlows()
{
    const auto* phi = site_.mesh.findObject<surfaceScalarField>("phi");
    flows_.setSize(patches_.size());
    label k = 0;
    for (const label patchi : patches_)
    {
        flows_[k++] = phi ? -sum(phi->boundaryField()[patchi]) : scalar(0);
    }
    reduceList(flows_, plusEqOp<scalar>());
    for (scalar& flow : flows_)
    {
        flow = max(flow, scalar(0));
    }
}


Foam::scalar Foam::patchInjection::meanVolume() const
{
    scalar result = 0;
    forAll(fractions_, typei)
    {
        result += fractions_[typei]*site_.types[typei].nominalVolume();
    }
    return result;
}


Foam::label Foam::patchInjection::nWaiting() const
{
    // A sum of rates over the steps is a little below the whole number
    return max(label(std::floor(due_ + 1e-6)) - nInjected(), 0);
}


void Foam::patchInjection::checkFlow()
{
    const auto* U = site_.mesh.findObject<volVectorField>("U");
    if (!byFlux_ || !U || activeTime() <= 0 || nStill_ < 0)
    {
        return;
    }
    if (inflow() > 0)
    {
        nStill_ = -1;
        return;
    }
    wordList names;
    bool closed = true;
    for (const label patchi : patches_)
    {
        const fvPatchVectorField& u = U->boundaryField()[patchi];
        const word& type = u.type();
        closed = closed
         && (type == "noSlip" || type == "slip" || type == "fixedValue")
         && gMax(scalarField(-(u & u.patch().nf()))) <= 0;
        names.append(u.patch().name());
    }
    if (closed)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'patches': the velocity that 0/U gives on " << flatOutput(names)
            << " does not enter the mesh, so that no clump can ever come in. With the"
            << " weighting uniform and a velocity they need no inflow."
            << exit(FatalIOError);
    }
    if (++nStill_ == 10)
    {
        IOWarningInFunction(dict_)
            << "Injection " << name() << ": in its first " << nStill_ << " steps there"
            << " was no flow into the mesh through " << flatOutput(names) << ", and no"
            << " clump can come in. Check the boundary conditions, and that the driving"
            << " of the flow points inwards there." << endl;
    }
}


void Foam::patchInjection::checkDemand(const scalar nDue)
{
    const scalar volume = inflow()*activeTime();
    if (!steady() || volume <= 0 || nDense_ >= 10)
    {
        return;
    }

    // The densest packing of equal spheres
    const scalar fraction = nDue*meanVolume()/volume;
    if (fraction > 0.74 && ++nDense_ == 10)
    {
        IOWarningInFunction(dict_)
            << "Injection " << name() << ": the clumps that are due have "
            << fraction << " times the volume of the flow through the patches, which has"
            << " no room for them: most of them will wait. Reduce the rate or the"
            << " haematocrit." << endl;
    }
}


void Foam::patchInjection::checkWaiting()
{
    const label nDue = nInjected() + nWaiting();
    if (!steady() || behind_ || nWaiting() < 3 || nWaiting() < 0.1*nDue)
    {
        return;
    }
    behind_ = true;
    IOWarningInFunction(dict_)
        << "Injection " << name() << ": " << nWaiting() << " of the " << nDue << " clumps that"
        << " were due until time " << site_.mesh.time().timeName() << " have found no free"
        << " place and wait: fewer enter than is asked for. Use a preInlet or a wider inlet,"
        << " or ask for fewer." << endl;
}


void Foam::patchInjection::checkWidth(const label nPlaces)
{
    fits_ = fits_ || places_.nFitting() > 0;
    if (fits_ || nTried_ >= 300)
    {
        return;
    }
    nTried_ += nPlaces;
    if (nTried_ >= 300)
    {
        scalar widest = 0;
        forAll(fractions_, typei)
        {
            if (fractions_[typei] > 0)
            {
                const clumpType& type = site_.types[typei];
                widest = max(widest, boundBox(type.centres(), false).mag());
                widest = max(widest, 2*max(type.radii()));
            }
        }
        IOWarningInFunction(dict_)
            << "Injection " << name() << ": a clump did not fit between the walls at"
            << " any of the first " << nTried_ << " places at the patches, whose box has"
            << " the sides " << lines_.box().span() << " m; the largest clump is about "
            << widest << " m wide. It has to be smaller, or to enter in another"
            << " orientation (axis and angle)." << endl;
    }
}


void Foam::patchInjection::inject
(
    Cloud<clumpParcel>& clumps,
    const clumpCount& count,
    const putAction& action
)
{
    findFlows();
    checkFlow();
    const scalar before = due_;
    due_ = due(clumps, count, before);
    checkDemand(due_ - before);
    label sum = 0;
    while (nWaiting() > 0)
    {
        const label number = min(nWaiting(), nAtOnce_);
        const label n = injectSome(clumps, action, number);
        sum += n;
        if (n < number)
        {
            break;
        }
        nAtOnce_ = max(nAtOnce_, sum + 1);
    }
    nAtOnce_ = sum + 1;
    checkWaiting();
}


Foam::label Foam::patchInjection::injectSome
(
    Cloud<clumpParcel>& clumps,
    const putAction& action,
    const label number
)
{
    const scalarField weights(chances());
    const label first = site_.mesh.nInternalFaces();

    List<Random> numbers(number, Random(0));
    List<patchLines::hit> hits(number*nTries_);
    for (label n = 0; n < number; ++n)
    {
        numbers[n] = random(1, nBatches_ + n);
        SubList<patchLines::hit>(hits, nTries_, n*nTries_) = lines_.shoot
        (
            nTries_, numbers[n],
            [&](const label facei) { return weights[facei - first]; }
        );
    }
    patchLines::combine(hits);

    // Touching the plane of the face; freePlaces moves it farther where the patch
    // is curved
    DynamicList<clumpCandidate> candidates;
    labelList starts(number + 1, Zero);
    for (label n = 0; n < number; ++n)
    {
        const label typeId = typeOf(nInjected() + n);
        const clumpType& type = site_.types[typeId];
        const scalarField& radii = type.radii();
        for (label k = n*nTries_; k < (n + 1)*nTries_; ++k)
        {
            const patchLines::hit& h = hits[k];
            const quaternion turn(turned_ ? turn_ : uniformRotation(numbers[n]));
            if (h.place < GREAT)
            {
                candidates.append
                (
                    candidate(typeId, h.x, shapeOf(nInjected() + n, type, turn))
                );
                clumpCandidate& c = candidates.last();
                c.patchi = h.patchi;
                c.inwards = h.inwards;
                scalar behind = 0;
                forAll(radii, i)
                {
                    behind = max(behind, radii[i] - (c.state.x[i] & c.inwards));
                }
                c.position += behind*c.inwards;
            }
        }
        starts[n + 1] = candidates.size();
    }

    const labelList owners(places_.find(candidates, clumps, false));
    checkWidth(candidates.size());
    DynamicList<label> taken;
    for (label n = 0; n < number; ++n)
    {
        ++nBatches_;
        label k = starts[n];
        const auto isFree = [&]()
        {
            bool result = owners[k] >= 0;
            for (const label other : taken)
            {
                result = result && !places_.conflict(candidates[other], candidates[k]);
            }
            return result;
        };
        while (k < starts[n + 1] && !isFree())
        {
            ++k;
        }
        if (k == starts[n + 1])
        {
            return n;
        }
        put(candidates[k], owners[k], action);
        taken.append(k);
    }
    return number;
}


void Foam::patchInjection::meshChanged()
{
    lines_.update();
    places_.clear();
    refuseMotion(box_, lines_.box());
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
