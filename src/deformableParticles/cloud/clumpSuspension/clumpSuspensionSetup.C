/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpSuspension.H"
#include "ignoreOverflow.H"
#include "clumpProperties.H"
#include "clumpSource.H"
#include "fluidCoupling.H"
#include "sceneScales.H"

Foam::clumpSuspension::clumpSuspension
(
    const fvMesh& mesh,
    const dictionary& dict,
    const word& name
)
:
    // No floating point trap while the base class reads the files
    Cloud<clumpParcel>
    (
        (ignoreOverflow(), ghostExchange::checkProcessors(mesh)), name, false
    ),
    mesh_(mesh),
    dict_(completeClumpProperties(mesh, dict)),
    g_(gravityOf(mesh)),
    effects_(dict_),
    ghosts_(mesh),
    openPatches_(mesh, dict_),
    count_(mesh, types_, name),
    breakage_(mesh)
{
    effects_.decide(dict_, mesh_);
    readTypes();
    completeContactModels();
    if (effects_.active("fluid"))
    {
        resetCoupling();
    }
}


Foam::clumpSuspension::~clumpSuspension()
{}


void Foam::clumpSuspension::readTypes()
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
    kindOf_.setSize(names.size());
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
        readKind(i, type);
        typeIds_.insert(names[i], i);
    }
    refuseNamesOfPieces(types);
}


void Foam::clumpSuspension::readKind(const label typei, const dictionary& dict)
{
    const word& name = types_[typei].kind();
    if (types_[typei].ofSpheres())
    {
        return;
    }
    for (clumpKind& kind : kinds_)
    {
        if (kind.type() == name)
        {
            kindOf_.set(typei, &kind);
        }
    }
    if (!kindOf_.set(typei))
    {
        kinds_.append(clumpKind::New(name, {mesh_, types_, dict_}));
        kindOf_.set(typei, &kinds_.last());
    }
    kindOf_[typei].read(typei, dict);
}


void Foam::clumpSuspension::refuseNamesOfPieces(const dictionary& dict) const
{
    forAll(types_, i)
    {
        const word& name = types_[i].name();
        const auto end = name.find_last_not_of("0123456789-+");
        if (end == std::string::npos || end + 1 == name.size() || name[end] != '.')
        {
            continue;
        }
        const word whole(name.substr(0, end));
        if (typeIds_.found(whole) && bonds_[typeIds_[whole]].breakable())
        {
            FatalIOErrorInFunction(getDict(dict, name))
                << "Clump type " << name << " has the name that pieces of a broken "
                << whole << " may have: choose another name." << exit(FatalIOError);
        }
    }
}


Foam::label Foam::clumpSuspension::pieceType
(
    const label whole,
    const labelUList& spheres
)
{
    autoPtr<clumpType> type(new clumpType(types_[whole], whole, spheres));
    forAll(types_, i)
    {
        if (types_[i].isPiece() && types_[i].name() == type->name())
        {
            return i;
        }
    }
    types_.append(type.ptr());
    bonds_.append(new clumpBonds(types_.last(), bonds_[whole]));
    kindOf_.setSize(types_.size());
    return types_.size() - 1;
}


Foam::scalar Foam::clumpSuspension::stressOfScene(string& reason) const
{
    return contactStress(mesh_, dict_, effects_, g_, types_, bonds_, reason);
}


void Foam::clumpSuspension::completeContactModels()
{
    string reason;
    for (const word family : {"contactModel", "wallContactModel"})
    {
        if (!dict_.found(family))
        {
            const scalar stress = stressOfScene(reason);
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
    for (clumpKind& kind : kinds_)
    {
        if (kind.needsContactStress() && effects_.active("fluid"))
        {
            const scalar stress = stressOfScene(reason);
            kind.setContactStress(stress, reason);
        }
    }
}


void Foam::clumpSuspension::resetCoupling()
{
    coupling_.reset
    (
        new fluidCoupling
        (
            mesh_, types_, dict_,
            effects_.active("feedback"),
            effects_.active("rotation"),
            effects_.frozen()
        )
    );
}


bool Foam::clumpSuspension::readOrPlace()
{
    reportScales(*this);
    source_ = clumpSource::New
    (
        name(), dict_,
        clumpSource::site{mesh_, ghosts_, types_, typeIds_, hasFluid()}
    );
    const bool restarts = start_.begin(*this, *source_, count_);
    source_->begin(*this);
    if (restarts)
    {
        // Versions that kept the pieces together have written them so
        breakage_.divide(*this, *source_, count_, true);
        count_.start(size());
    }
    openPatches_.report();
    updateGhosts();
    if (dict_.found("injection"))
    {
        // Before the first of them is there
        ghostExchange::checkPatches(mesh_.boundaryMesh());
    }
    if (coupled())
    {
        coupling_->boundary().checkResolution(ghosts_.images());
    }
    return restarts;
}
