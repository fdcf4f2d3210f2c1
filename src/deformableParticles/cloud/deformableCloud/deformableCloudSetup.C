/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "accuracyLevel.H"
#include "IOdictionary.H"
#include "placement.H"
#include "treeDataCell.H"
#include "uniformDimensionedFields.H"
#include "OSspecific.H"

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
    // Numbers too large: as in readProperties
    Cloud<clumpParcel>((anyNumber(), mesh), name, false),
    mesh_(mesh),
    dict_(dict),
    effects_(dict_),
    ghosts_(mesh),
    contactGhosts_(mesh),
    integrator_(selectModel<integrator>(getDict(dict_, "integrator"))),
    contactModel_(selectModel<contactModel>(getDict(dict_, "contactModel"))),
    wallContactModel_
    (
        selectModel<wallContactModel>(getDict(dict_, "wallContactModel"))
    ),
    rho_(0),
    mu_(0),
    overshoots_(false),
    g_(Zero),
    nClumps_(0),
    wallClearance_(0),
    wallsOf_(-1)
{
    accuracyLevel::refuseOldEntry(dict_);

    // Other entries of the file are the user's own, to be referred to
    refuseMisspelt
    (
        dict_,
        {
            "types", "placement", "integrator", "contactModel",
            "wallContactModel", "loads", "effects", "rotation", "exchange",
            "immersedBoundary", "accuracyLevel"
        }
    );
    decideOnce();
    readTypes();
    readLoads();

    g_ = uniformDimensionedVectorField
    (
        IOobject("g", mesh.time().constant(), mesh, IOobject::READ_IF_PRESENT),
        dimensionedVector(dimAcceleration, Zero)
    ).value();

    if (wet())
    {
        const IOdictionary fluid
        (
            IOobject
            (
                "transportProperties", mesh.time().constant(), mesh,
                IOobject::MUST_READ, IOobject::NO_WRITE, false
            )
        );
        rho_ = getPositive(fluid, "rho", dimDensity);
        if (fluid.found("nu"))
        {
            // The viscosity models take any sign
            getPositive(fluid, "nu", dimViscosity);
        }

    }

    if (effects_.active("feedback"))
    {
        if (effects_.active("rotation"))
        {
            rotationModel_ =
                selectModel<rotationModel>(getDict(dict_, "rotation"));
        }
        couplingScheme_ = selectModel<couplingScheme>(getDict(dict_, "exchange"));
        immersedBoundary_.reset
        (
            new immersedBoundary
            (
                mesh, types_, getDict(dict_, "immersedBoundary")
            )
        );
    }
    else if (wet())
    {
        drag_.reset(new oneWayDrag(types_));
    }

    nClumps_ = returnReduce(size(), sumOp<label>());
    const bool placed = !nClumps_;
    if (nClumps_)
    {
        restart();
    }
    else
    {
        place();
    }
    reportFractions();

    ghosts_.update(*this);
    if (placed)
    {
        checkOverlaps(getDict(dict_, "placement"));
    }
    if (coupled())
    {
        immersedBoundary_->checkResolution(ghosts_.images());
    }
    decideEffects();
}


void Foam::deformableCloud::readTypes()
{
    const dictionary& types = getDict(dict_, "types");
    const wordList names(types.toc());
    if (names.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'types' must hold one clump type at least"
            << exit(FatalIOError);
    }
    types_.setSize(names.size());

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
        typeIds_.insert(names[i], i);
    }
}


void Foam::deformableCloud::readLoads()
{
    if (!effects_.active("loads"))
    {
        return;
    }

    const dictionary& loads = getDict(dict_, "loads");
    for (const word& name : loads.toc())
    {
        const dictionary& d = getDict(loads, name);
        loads_.append(selectModel<load>(d));

        const word& on = loads_.last().clumpType();
        if (!typeIds_.found(on))
        {
            FatalIOErrorInLookup(d, "clumpType", on, typeIds_)
                << exit(FatalIOError);
        }
        loads_.last().check(d, types_[typeIds_[on]].size());
    }
}


bool Foam::deformableCloud::inMesh(const point& p) const
{
    bool found = false;
    for (const vector& shift : ghosts_.shifts())
    {
        const point image(p + shift);
        found =
            found
         || (ghosts_.localBox().contains(image) && mesh_.findCell(image) >= 0);
    }
    return returnReduce(found, orOp<bool>());
}


void Foam::deformableCloud::reportFractions() const
{
    labelList numbers(types_.size(), 0);
    for (const clumpParcel& p : *this)
    {
        ++numbers[p.typeId()];
    }
    Pstream::listCombineGather(numbers, plusEqOp<label>());
    Pstream::listCombineScatter(numbers);

    const Pair<scalar> fractions
    (
        placement::fractions(types_, numbers, gSum(mesh_.V()))
    );
    Info<< "Haematocrit " << Foam::name(fractions.first()).c_str()
        << ", volume fraction of the spheres' unions "
        << Foam::name(fractions.second()).c_str() << endl;
}


void Foam::deformableCloud::restart()
{
    clumpParcel::readFields(*this);

    // Written by setClumps, not by a run: at rest unless they were given a velocity
    if (!isFile(mesh_.time().timePath()/"uniform"/"time"))
    {
        for (const clumpParcel& p : *this)
        {
            if (max(mag(p.state().u)) == 0)
            {
                followFlow_.insert(p.origId());
            }
        }
    }

    // A number stands for one clump, on all processors
    List<labelPairList> ids(Pstream::nProcs());
    labelPairList& mine = ids[Pstream::myProcNo()];
    for (const clumpParcel& p : *this)
    {
        mine.append(labelPair(p.origProc(), p.origId()));
    }
    Pstream::gatherList(ids);

    HashSet<labelPair, Hash<labelPair>> seen;
    for (const labelPairList& part : ids)
    {
        for (const labelPair& id : part)
        {
            if (!seen.insert(id))
            {
                FatalErrorInFunction
                    << fieldIOobject("origId", IOobject::NO_READ).objectPath()
                    << ": two clumps have the number " << id.second()
                    << " (origProcId " << id.first() << ')'
                    << exit(FatalError);
            }
        }
    }
}


void Foam::deformableCloud::place()
{
    const IOobject written(fieldIOobject("typeId", IOobject::NO_READ));
    if (returnReduce(isFile(written.objectPath()), orOp<bool>()))
    {
        FatalErrorInFunction
            << written.path() << " holds clumps, but their places,"
            << " coordinates, are missing or cannot be read" << exit(FatalError);
    }

    // A run that had clumps wrote both; after setClumps there is no state
    const fileName uniform(mesh_.time().timePath()/"uniform");
    const bool had =
        isFile(uniform/"time")
     && isFile(uniform/cloud::prefix/name()/"cloudProperties");
    if (returnReduce(had, orOp<bool>()))
    {
        FatalErrorInFunction
            << "The run that wrote " << mesh_.time().timePath()
            << " had clumps, but " << written.path() << " holds none." << nl
            << "    To place them anew, remove " << uniform/cloud::prefix
            << exit(FatalError);
    }

    const dictionary& dict = getDict(dict_, "placement");
    const placement start(dict, types_, typeIds_);

    // Bounds of the processors' cell trees are built together
    mesh_.cellTree();

    forAll(start.clumps(), k)
    {
        const placement::placed& p = start.clumps()[k];

        const label celli =
            ghosts_.localBox().contains(p.position)
          ? mesh_.findCell(p.position) : -1;

        // On a boundary between processors the first one takes it
        label proci = celli >= 0 ? Pstream::myProcNo() : labelMax;
        reduce(proci, minOp<label>());

        if (proci == labelMax)
        {
            FatalIOErrorInFunction(dict)
                << "Entry position: clump " << k << " of type "
                << types_[p.typeId].name() << " at " << p.position
                << " lies outside the mesh" << exit(FatalIOError);
        }
        forAll(p.state.x, i)
        {
            if (!inMesh(p.position + p.state.x[i]))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry position: sphere " << i << " of clump " << k
                    << " of type " << types_[p.typeId].name() << " at "
                    << p.position + p.state.x[i] << " lies outside the mesh"
                    << exit(FatalIOError);
            }
        }

        if (proci == Pstream::myProcNo())
        {
            addParticle
            (
                new clumpParcel(mesh_, p.position, celli, p.typeId, p.state)
            );

            // The number in the list, however the mesh is decomposed
            clumpParcel& parcel = *last();
            parcel.origProc() = 0;
            parcel.origId() = k;
        }
        if (p.followsFlow)
        {
            followFlow_.insert(k);
        }
    }

    nClumps_ = start.clumps().size();
    Info<< "Placed " << nClumps_ << " clumps" << endl;
}
