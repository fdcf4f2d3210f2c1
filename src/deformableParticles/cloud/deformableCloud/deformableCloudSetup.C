/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "accuracyLevel.H"
#include "anyNumber.H"
#include "clumpFields.H"
#include "clumpInjector.H"
#include "FlatOutput.H"
#include "foamCompat.H"
#include "functionObject.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "placement.H"
#include "sizeClasses.H"
#include "surfaceCrossing.H"
#include "unreadEntries.H"
#include "uniformDimensionedFields.H"

namespace Foam
{
    defineTypeNameAndDebug(deformableCloud, 0);
}

namespace
{

using namespace Foam;

//- constant/clumpProperties. A number too large for the machine becomes
//  infinite, and is refused where it is read.
IOdictionary readProperties(const fvMesh& mesh)
{
    const anyNumber overflow;
    return IOdictionary
    (
        IOobject
        (
            "clumpProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    );
}


//- constant/g, zero where it is absent
vector gravityOf(const fvMesh& mesh)
{
    const anyNumber overflow;
    const uniformDimensionedVectorField g
    (
        IOobject
        (
            "g", mesh.time().constant(), mesh, IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE, false
        ),
        dimensionedVector(dimAcceleration, Zero)
    );
    if (g.dimensions() != dimAcceleration || !physical(g.value()))
    {
        FatalErrorInFunction
            << "The acceleration in " << g.objectPath() << " is "
            << g.dimensions() << ' ' << g.value() << "; it must be finite and"
            << " have the dimensions " << dimAcceleration << exit(FatalError);
    }
    return g.value();
}


//- The models of a case that does not choose others
dictionary accurateModels()
{
    IStringStream is
    (
        "integrator { type implicitEuler; tolerance 1e-9; maxIterations 100; }"
        "rotation { type wholeClump; }"
        "couplingScheme { type robin; }"
        "immersedBoundary"
        "{"
        "    solidFraction { type signedDistance; }"
        "    forcing { type sharp; }"
        "    hydrodynamicForce { type momentumExchange; }"
        "    interiorDilation yes;"
        "}"
    );
    return dictionary(is);
}


//- Add the entries that dict lacks, whole models and not parts of them
void complete(dictionary& dict, const dictionary& usual)
{
    for (const entry& e : usual)
    {
        dictionary* given = dict.findDict(e.keyword(), keyType::LITERAL);
        if (given && e.isDict() && !e.dict().found("type"))
        {
            complete(*given, e.dict());
        }
        else if (!dict.found(e.keyword()))
        {
            dict.add(e);
        }
    }
}


//- With present names, and with the accurate models where there are none. Other
//  entries of the file are the user's own, to be referred to
dictionary presentEntries(const fvMesh& mesh, const dictionary& dict)
{
    dictionary result
    (
        withPresentNames(dict, {{"exchange", "couplingScheme"}})
    );
    accuracyLevel::refuseOldEntry(result);
    if (result.found("aggregation"))
    {
        FatalIOErrorInFunction(result)
            << "Entry 'aggregation': there is no model of the attraction between"
            << " clumps any more. Remove the entry; 'lubrication' is the only one"
            << " that acts across gaps." << exit(FatalIOError);
    }
    refuseUnread
    (
        result,
        typeFilePath<IOdictionary>
        (
            IOobject("clumpProperties", mesh.time().constant(), mesh)
        ),
        {
            "types", "placement", "injection", "integrator", "contactModel",
            "wallContactModel", "lubrication", "membraneContact", "loads", "effects",
            "rotation", "couplingScheme", "immersedBoundary", "openPatches",
            "typesMayChange", "accuracyLevel", "rho"
        }
    );
    if (result.isDict("types"))
    {
        result.set("types", sizeClasses::expanded(result.subDict("types")));
    }
    complete(result, accurateModels());
    return result;
}

}

Foam::deformableCloud::deformableCloud(const fvMesh& mesh, const word& name)
:
    deformableCloud
    (
        mesh, readProperties(mesh), name
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
    dict_(presentEntries(mesh, dict)),
    membraneContacts_(types_, dict_),
    g_(gravityOf(mesh)),
    effects_(dict_),
    ghosts_(mesh),
    integrator_(selectModel<integrator>(getDict(dict_, "integrator"))),
    contacts_(readModels(), dict_),
    walls_(mesh, types_, dict_),
    gaps_(dict_),
    contacting_(mesh, types_, bonds_, contacts_, walls_, gaps_),
    nSolves_(0),
    openPatches_(mesh, dict_),
    count_(mesh, types_, name)
{
    readLoads();
    refuseIdleEffects();

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
    checkMembranes();

    reportScales();
    const bool restarts = returnReduce(size(), sumOp<label>()) > 0;
    if (restarts)
    {
        count_.check(size(), cloud::prefix/name);
        restart();
    }
    else if (count_.emptied())
    {
        Info<< "No clumps at time " << mesh_.time().timeName() << ": "
            << (count_.left() ? "all have left the domain" : "none were placed")
            << ". The entry placement is not used; setClumps places clumps at this"
            << " time" << endl;
    }
    else
    {
        place();
    }
    count_.start(size());
    reportFractions();
    injector_.reset
    (
        new clumpInjector
        (
            name, dict_,
            injection::site{mesh, ghosts_, types_, typeIds_, hasFluid()}
        )
    );
    injector_->begin(*this);

    if (!openPatches_.empty())
    {
        Info<< "Clumps may leave through:";
        for (const word& patch : openPatches_.names())
        {
            Info<< ' ' << patch;
        }
        Info<< endl;
    }
    updateGhosts();
    if (!restarts && nClumps())
    {
        checkStart();
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
    membranes_.setSize(names.size());

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
        if (types_[i].hasSurface())
        {
            membranes_.set
            (
                i, new membraneStep(types_[i], type, membraneContacts_)
            );
        }
        typeIds_.insert(names[i], i);
    }
}


void Foam::deformableCloud::readLoads()
{
    constraints_.setSize(types_.size(), symmTensor(Zero));
    if (!effects_.active("loads"))
    {
        return;
    }

    const dictionary& loads = getDict(dict_, "loads");
    for (const word& name : loads.toc())
    {
        const dictionary& d = getDict(loads, name);
        loads_.append(selectModel<load>(d));

        const load& added = loads_.last();
        bool some = false;
        forAll(types_, i)
        {
            if (added.actsOn(types_[i]))
            {
                added.check(d, types_[i].size());
                constrain(d, i);
                some = true;
            }
        }
        if (!some)
        {
            FatalIOErrorInLookup(d, "clumpType", added.loadedType(), typeIds_)
                << exit(FatalIOError);
        }
        added.field(mesh_);
    }
}


void Foam::deformableCloud::constrain(const dictionary& dict, const label typei)
{
    const symmTensor& along = loads_.last().constraint();
    if (tr(constraints_[typei]) > 0 && tr(along) > 0)
    {
        FatalIOErrorInFunction(dict)
            << "Clump type " << types_[typei].name() << " has two loads of the type"
            << " hold: give all directions to one of them." << exit(FatalIOError);
    }
    if (!types_[typei].fixed())
    {
        constraints_[typei] += along;
    }
}


void Foam::deformableCloud::checkStart() const
{
    const dictionary& dict = getDict(dict_, "placement");
    if (contacts_.active() && effects_.active("contact"))
    {
        contacts_.refuseOverlaps(ghosts_.images(), ghosts_.nOwn(), dict);
    }
    if (membranesTouch())
    {
        membraneContacts_.refuseOverlaps(ghosts_, dict);
    }

    const surfaceCrossing crossing(mesh_, types_, ghosts_, 0.01);
    if (crossing.outside())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'position': " << crossing.description().c_str()
            << exit(FatalIOError);
    }
    if (crossing.nClumps())
    {
        IOWarningInFunction(dict)
            << crossing.nClumps() << " clumps start across a wall or an open"
            << " patch; " << crossing.description().c_str() << endl;
    }
}


void Foam::deformableCloud::reportFractions() const
{
    labelList numbers(types_.size(), 0);
    for (const clumpParcel& p : *this)
    {
        ++numbers[p.typeId()];
    }
    reduceList(numbers, plusEqOp<label>());
    if (!sum(numbers))
    {
        return;
    }

    const scalar volume = gSum(mesh_.V());
    const Pair<scalar> fractions(placement::fractions(types_, numbers, volume));
    bool someFixed = false;
    forAll(types_, i)
    {
        someFixed = someFixed || types_[i].fixed();
        labelList own(types_.size(), 0);
        own[i] = numbers[i];
        const scalar share = placement::fractions(types_, own, volume).first();
        Info<< "    " << types_[i].name() << ": " << numbers[i]
            << " clumps, haematocrit " << Foam::name(share).c_str() << nl;
    }
    Info<< "Haematocrit " << Foam::name(fractions.first()).c_str()
        << ", volume fraction of the clumps " << (someFixed ? "that move " : "")
        << Foam::name(fractions.second()).c_str() << endl;
}


void Foam::deformableCloud::restart()
{
    clumpFields::read
    (
        *this, types_, writtenTypes(name(), mesh_.time(), types_, dict_)
    );
    Info<< "Read " << returnReduce(size(), sumOp<label>())
        << " clumps from time " << mesh_.time().timeName()
        << (properties().found("placement") ? "; the entry placement is not used" : "")
        << endl;

    // Written by setClumps, not by a run: at rest unless they were given a velocity
    const IOdictionary ofRun
    (
        IOobject
        (
            "time", mesh_.time().timeName(), "uniform", mesh_.time(),
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    starts_ = ofRun.empty();
    if (starts_)
    {
        for (const clumpParcel& p : *this)
        {
            if (max(mag(p.state().u)) == 0)
            {
                followFlow_.insert(p.origId());
            }
        }
    }
}


void Foam::deformableCloud::place()
{
    starts_ = true;
    clumpFields::refuseRemains(*this);
    count_.check(size(), cloud::prefix/name());
    if (!dict_.found("placement") && dict_.found("injection"))
    {
        return;
    }

    const dictionary& dict = getDict(dict_, "placement");
    selectModel<placement>(dict, types_, typeIds_)->place
    (
        mesh_, *this, followFlow_
    );

    Info<< "Placed " << returnReduce(size(), sumOp<label>()) << " clumps" << endl;
}
