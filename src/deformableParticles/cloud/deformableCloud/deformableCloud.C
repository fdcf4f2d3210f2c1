/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "clumpMotion.H"
#include "clumpProperties.H"
#include "clumpSource.H"
#include "FlatOutput.H"
#include "fluidCoupling.H"
#include "functionObject.H"

namespace Foam
{
    defineTypeNameAndDebug(deformableCloud, 0);
}


Foam::deformableCloud::deformableCloud(const fvMesh& mesh, const word& name)
:
    deformableCloud
    (
        mesh, readClumpProperties(mesh), name
    )
{}


Foam::deformableCloud::deformableCloud
(
    const fvMesh& mesh,
    const dictionary& dict,
    const word& name
)
:
    clumpSuspension(mesh, dict, name),
    motion_(new clumpMotion(*this))
{
    const bool restarts = readOrPlace();
    if (!restarts && nClumps())
    {
        const dictionary& placement = getDict(dict_, "placement");
        motion().refuseOverlaps(placement);
        source_->refuseOutside();
    }
    motion().decideEffects();
}


Foam::deformableCloud::~deformableCloud()
{}


const Foam::clumpMotion& Foam::deformableCloud::motion() const
{
    return *motion_;
}


Foam::clumpMotion& Foam::deformableCloud::motion()
{
    return *motion_;
}


void Foam::deformableCloud::accept()
{
    motion().accept(flowChange_);
    followedFlow_ = false;
}


void Foam::deformableCloud::refuse()
{
    motion().refuse();
}


const Foam::deformableCloud& Foam::deformableCloud::find
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    const word name(dict.getOrDefault<word>("cloud", "clumps"));
    const auto* cloud = mesh.findObject<deformableCloud>(name);
    if (!cloud)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'cloud' is " << name << ", but there is no cloud of this"
            << " name. Valid names: "
            << flatOutput(mesh.sortedNames<deformableCloud>())
            << exit(FatalIOError);
    }
    return *cloud;
}


Foam::word Foam::deformableCloud::findName
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    return
        functionObject::postProcess
      ? dict.getOrDefault<word>("cloud", "clumps")
      : find(mesh, dict).name();
}


void Foam::deformableCloud::evolve
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu
)
{
    if (!coupled())
    {
        extrapolatePositions();
        ghosts_.setRange(motion().decisions().gapRange());
        updateGhosts();
    }
    gatherForces(U, p, nu);
    motion().decideEffects();
    motion().solve(true);

    flowChange_ = Zero;
    if (coupled())
    {
        flowChange_ =
            (U() - U.oldTime()())().weightedAverage(mesh_.V()).value();
    }
}


void Foam::deformableCloud::evolve()
{
    ghosts_.setRange(motion().decisions().gapRange());
    updateGhosts();
    motion().decideEffects();
    motion().solve(true);
}


void Foam::deformableCloud::moveParcels()
{
    if (transfer())
    {
        motion().newClumps();
        if (hasFluid())
        {
            giveFlow(mesh_.lookupObject<volVectorField>("U"));
        }
    }
    count_.endStep(size());
    timing_.endStep
    (
        [&](const char* part) { return effects_.takesPart(part); }
    );
}


void Foam::deformableCloud::prepareMeshChange()
{
    updateGhosts();
    coupling_->boundary().setCloseness(ghosts_.images());
    storeGlobalPositions();
}


void Foam::deformableCloud::meshChanged()
{
    ghosts_.meshChanged();
    motion().meshChanged();
    if (hasFluid())
    {
        coupling_->boundary().meshChanged();
    }
    for (clumpKind& kind : kinds_)
    {
        kind.meshChanged();
    }
    source_->meshChanged();
    openPatches_.clear();
}


void Foam::deformableCloud::pointsMoved(const UList<point>& places)
{
    meshChanged();
    stay(places);
}
