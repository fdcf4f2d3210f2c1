/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "IOdictionary.H"
#include "placement.H"
#include "treeDataCell.H"
#include "uniformDimensionedFields.H"
#include "OSspecific.H"
#include "sigFpe.H"
#include "sphereGrid.H"

namespace
{

using namespace Foam;

//- constant/clumpProperties. A number too large for the machine becomes
//  infinite, and is refused where it is read.
IOdictionary readProperties(const fvMesh& mesh)
{
    const sigFpe::ignore overflow;
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
    Cloud<clumpParcel>((sigFpe::ignore(), mesh), name, false),
    mesh_(mesh),
    dict_(dict),
    effects_(dict_),
    ghosts_(mesh),
    integrator_(selectModel<integrator>(getDict(dict_, "integrator"))),
    contactModel_(selectModel<contactModel>(getDict(dict_, "contactModel"))),
    wallContactModel_
    (
        selectModel<wallContactModel>(getDict(dict_, "wallContactModel"))
    ),
    rho_(0),
    mu_(0),
    g_(Zero),
    nClumps_(0),
    wallClearance_(0)
{
    // Other entries of the file are the user's own, to be referred to
    refuseMisspelt
    (
        dict_,
        {
            "types", "placement", "integrator", "contactModel",
            "wallContactModel", "loads", "effects", "rotation", "exchange",
            "immersedBoundary"
        }
    );
    readTypes();
    readLoads();

    g_ = uniformDimensionedVectorField
    (
        IOobject("g", mesh.time().constant(), mesh, IOobject::READ_IF_PRESENT),
        dimensionedVector(dimAcceleration, Zero)
    ).value();

    if (effects_.automatic("fluid"))
    {
        const bool found = IOobject
        (
            "transportProperties", mesh.time().constant(), mesh
        ).typeHeaderOk<IOdictionary>(false);

        effects_.decide
        (
            "fluid",
            found,
            found
          ? "constant/transportProperties is there"
          : "no constant/transportProperties"
        );
    }

    if (effects_.active("fluid"))
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

        rotationModel_ = selectModel<rotationModel>(getDict(dict_, "rotation"));
        exchangeModel_ = selectModel<exchangeModel>(getDict(dict_, "exchange"));
        immersedBoundary_.reset
        (
            new immersedBoundary
            (
                mesh, types_, getDict(dict_, "immersedBoundary")
            )
        );
    }
    else
    {
        effects_.decide("convection", false, "no fluid");
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

    ghosts_.update(*this);
    if (placed)
    {
        checkOverlaps(getDict(dict_, "placement"));
    }
    if (wet())
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
        types_.set(i, new clumpType(names[i], getDict(types, names[i])));
        typeIds_.insert(names[i], i);
    }
}


void Foam::deformableCloud::readLoads()
{
    if (!dict_.found("loads"))
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


void Foam::deformableCloud::restart()
{
    clumpParcel::readFields(*this);

    // A number stands for one clump, on all processors
    List<labelPairList> ids(Pstream::nProcs());
    labelPairList& mine = ids[Pstream::myProcNo()];
    for (const clumpParcel& p : *this)
    {
        mine.append(labelPair(p.origProc(), p.origId()));
    }
    Pstream::gatherList(ids);

    HashSet<labelPair, labelPair::Hash<>> seen;
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
    }

    nClumps_ = start.clumps().size();
    Info<< "Placed " << nClumps_ << " clumps" << endl;
}


void Foam::deformableCloud::checkOverlaps(const dictionary& dict) const
{
    if (!contactModel_->active() || !effects_.active("contact"))
    {
        return;
    }

    const UList<clumpImage>& images = ghosts_.images();

    sphereGrid::forEachContact
    (
        images, ghosts_.nOwn(), types_,
        [&](const label a, const label i, const label b, const label j)
        {
            const clumpType& ta = types_[images[a].typeId];
            const clumpType& tb = types_[images[b].typeId];

            if
            (
                mag(images[a].x[i] - images[b].x[j])
              < max(ta.radii()[i], tb.radii()[j])
            )
            {
                FatalIOErrorInFunction(dict)
                    << "Entry position: sphere " << i << " of clump "
                    << images[a].id.second() << " of type " << ta.name()
                    << " and sphere " << j << " of clump "
                    << images[b].id.second() << " of type " << tb.name()
                    << " lie inside each other at " << images[a].x[i]
                    << exit(FatalIOError);
            }
        }
    );
}


void Foam::deformableCloud::decideEffects()
{
    if (effects_.automatic("gravity"))
    {
        scalar excess = 0;
        for (const clumpType& ct : types_)
        {
            excess = max(excess, mag(ct.mass() - rho_*ct.volume())/ct.mass());
        }
        const bool on = mag(g_) > 0 && excess > 1e-6;
        effects_.decide
        (
            "gravity",
            on,
            mag(g_) == 0 ? "no gravity in constant/g"
          : on ? "densities differ" : "equal densities"
        );
    }

    if (effects_.automatic("contact"))
    {
        if (!contactModel_->active())
        {
            effects_.decide("contact", false, "contactModel none");
        }
        else if (nClumps_ < 2 && !ghosts_.meetsItself())
        {
            effects_.decide("contact", false, "one clump in the domain");
        }
        else
        {
            // Boxes meet, or may meet within this step
            const UList<clumpImage>& images = ghosts_.images();
            bool near = false;
            for (label a = 0; a < ghosts_.nOwn() && !near; ++a)
            {
                const scalar margin =
                    2*max(mag(images[a].u))*mesh_.time().deltaTValue();
                boundBox box(images[a].box);
                box.min() -= margin*vector::one;
                box.max() += margin*vector::one;
                forAll(images, b)
                {
                    near = near || (b != a && box.overlaps(images[b].box));
                }
            }
            reduce(near, orOp<bool>());
            effects_.decide
            (
                "contact", near, near ? "clumps are near" : "no clumps are near"
            );
        }
    }

    decideWalls();
}


void Foam::deformableCloud::decideWalls()
{
    if (!effects_.automatic("walls"))
    {
        if (effects_.active("walls") && !walls_.valid())
        {
            walls_.reset(new wallSurface(mesh_, ghosts_));
        }
        return;
    }
    if (!wallContactModel_->active())
    {
        effects_.decide("walls", false, "wallContactModel none");
        return;
    }

    // Measured anew only when a clump may have come near since
    wallClearance_ -= maxSpeed()*mesh_.time().deltaTValue();
    if (walls_.valid() && wallClearance_ > 0)
    {
        return;
    }
    if (!walls_.valid())
    {
        walls_.reset(new wallSurface(mesh_, ghosts_));
    }

    scalar gap = GREAT;
    scalar radius = 0;
    for (const clumpParcel& p : *this)
    {
        if (type(p).fixed())
        {
            continue;
        }
        const pointField centres(p.centres());
        forAll(centres, i)
        {
            const scalar r = type(p).radii()[i];
            gap = min(gap, walls_->distance(centres[i], 100*r) - r);
            radius = max(radius, r);
        }
    }
    reduce(gap, minOp<scalar>());
    reduce(radius, maxOp<scalar>());

    const bool near = gap < 0.5*radius;
    wallClearance_ = near ? 0 : gap - 0.5*radius;

    OStringStream reason;
    if (gap > 98*radius)
    {
        reason << "none near";
    }
    else
    {
        // Two digits: the number is for people
        reason.precision(2);
        reason << "nearest " << 1e6*gap << " um";
    }
    effects_.decide("walls", near, reason.str());
}
