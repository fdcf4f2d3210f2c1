/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "anyNumber.H"
#include "clumpInjector.H"
#include "clumpProperties.H"
#include "FlatOutput.H"
#include "functionObject.H"
#include "sceneScales.H"

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
    // No floating point trap while the base class reads the files
    Cloud<clumpParcel>((anyNumber(), mesh), name, false),
    mesh_(mesh),
    dict_(completeClumpProperties(mesh, dict)),
    membranes_(mesh, types_, dict_),
    g_(gravityOf(mesh)),
    effects_(dict_),
    ghosts_(mesh),
    integrator_(selectModel<integrator>(getDict(dict_, "integrator"))),
    loads_(mesh, types_),
    contacts_(readModels(), dict_),
    walls_(mesh, types_, dict_),
    gaps_(dict_),
    contacting_(mesh, types_, bonds_, contacts_, walls_, gaps_),
    decisions_(mesh, dict_, types_, effects_, contacts_, walls_, gaps_),
    nSolves_(0),
    openPatches_(mesh, dict_),
    count_(mesh, types_, name)
{
    loads_.read
    (
        effects_.active("loads") ? &getDict(dict_, "loads") : nullptr, typeIds_
    );
    decisions_.refuseIdle(g_, integrator_->implicit());

    if (effects_.active("fluid"))
    {
        coupling_.reset
        (
            new fluidCoupling
            (
                mesh, types_, dict_,
                effects_.active("feedback"),
                effects_.active("rotation"),
                effects_.frozen()
            )
        );
    }
    if (surfaceImmersion::wanted(types_) && !coupled())
    {
        FatalIOErrorInFunction(getDict(dict_, "types"))
            << "Entry 'types': a membrane has no inertia of its own and needs a fluid"
            << " that feels it; without a fluid, or with feedback off or a frozen"
            << " flow, there are only clumps of spheres." << exit(FatalIOError);
    }
    if (surfaceImmersion::wanted(types_) && decisions_.clumpsMayTouch())
    {
        membranes_.contacts().refuseSmallSpheres(getDict(dict_, "types"));
    }

    reportScales(*this);
    const bool restarts = start_.begin(*this, typeIds_, count_);
    injector_.reset
    (
        new clumpInjector
        (
            name, dict_,
            injection::site{mesh, ghosts_, types_, typeIds_, hasFluid()}
        )
    );
    injector_->begin(*this);

    openPatches_.report();
    updateGhosts();
    if (!restarts && nClumps())
    {
        const dictionary& placement = getDict(dict_, "placement");
        if (contacts_.active() && effects_.active("contact"))
        {
            contacts_.refuseOverlaps(ghosts_.images(), ghosts_.nOwn(), placement);
        }
        if (decisions_.clumpsMayTouch())
        {
            membranes_.contacts().refuseOverlaps(ghosts_, placement);
        }
        clumpStart::refuseOutside(mesh_, types_, ghosts_, placement);
    }
    if (dict_.found("injection"))
    {
        // Before the first of them is there
        ghostExchange::checkPatches(mesh.boundaryMesh());
    }
    if (coupled())
    {
        coupling_->boundary().checkResolution(ghosts_.images());
    }
    decideEffects();
}


Foam::deformableCloud::~deformableCloud()
{}


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


void Foam::deformableCloud::readTypes()
{
    const dictionary& types = getDict(dict_, "types");
    const wordList names(types.toc());
    if (names.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'types' must contain at least one clump type."
            << exit(FatalIOError);
    }
    types_.setSize(names.size());
    bonds_.setSize(names.size());

    forAll(names, i)
    {
        dictionary type(getDict(types, names[i]));
        if (effects_.switchedOff("damping"))
        {
            type.subDictOrAdd("dampingModel").clear();
            type.subDict("dampingModel").set("type", word("none"));
        }
        if (effects_.switchedOff("conservation"))
        {
            type.remove("conservationModel");
            type.remove("conservationModels");
        }
        types_.set(i, new clumpType(names[i], type));
        bonds_.set(i, new clumpBonds(types_[i], type));
        membranes_.read(i, type);
        typeIds_.insert(names[i], i);
    }
}


const Foam::PtrList<Foam::clumpType>& Foam::deformableCloud::readModels()
{
    effects_.decide(dict_, mesh_);
    readTypes();
    for (const word family : {"contactModel", "wallContactModel"})
    {
        if (!dict_.found(family))
        {
            string reason;
            const scalar stress = contactStress
            (
                mesh_, dict_, effects_, g_, types_, bonds_, reason
            );
            dictionary law;
            law.set("type", "hertz");
            law.set("allowedOverlap", 0.05);
            law.set("stress", min(stress, largestEntry));
            law.set("restitution", 0.5);
            dict_.add(family, law);
            Info<< family << ": hertz, with an overlap of 5 % of a radius under "
                << stress << " Pa, " << reason.c_str() << endl;
        }
    }
    if
    (
        membranes_.contacts().needsStress() && surfaceImmersion::wanted(types_)
     && effects_.active("fluid")
    )
    {
        string reason;
        const scalar stress = contactStress
        (
            mesh_, dict_, effects_, g_, types_, bonds_, reason
        );
        membranes_.setContactStress(stress, reason);
    }
    return types_;
}
