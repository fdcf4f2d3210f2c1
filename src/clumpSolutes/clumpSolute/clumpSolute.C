/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpSolute.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntries.H"
#include "FlatOutput.H"
#include "foamCompat.H"
#include "fvOptions.H"
#include "ghostExchange.H"
#include "placedConditions.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpSolute, 0);
    addToRunTimeSelectionTable(functionObject, clumpSolute, dictionary);
}
}


Foam::functionObjects::clumpSolute::clumpSolute
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    table_(mesh_, name, typeName),
    clumpTable_(mesh_, name + "Clumps", "clumpContent"),
    through_(mesh_.boundaryMesh().nNonProcessor(), Zero)
{
    read(dict);
    if (!functionObject::postProcess)
    {
        refusePlaces(dict);
        ghostExchange::checkMatching(mesh_.boundaryMesh(), "a clumpSolute", dict);
        start();
    }
}


bool Foam::functionObjects::clumpSolute::read(const dictionary& dict)
{
    checkEntries
    (
        dict,
        {"cloud", "field", "diffusivity", "tolerance", "types", "perClump"},
        functionObjectEntries()
    );
    refuseSkippedSteps(dict);
    cloudName_ = deformableCloud::findName(mesh_, dict);
    diffusivity_ = getPositive(dict, "diffusivity");
    tolerance_ = getPositiveOrDefault(dict, "tolerance", 1e-8);
    perClump_ = dict.getOrDefault("perClump", false);
    if (!functionObject::postProcess)
    {
        const dictionary types(dict.subOrEmptyDict("types"));
        types_ = List<soluteType>(cloud().nTypes(), soluteType(diffusivity_));
        released_ = scalarList(types_.size(), Zero);
        for (const entry& e : types)
        {
            if (!cloud().typeIds().found(e.keyword()))
            {
                FatalIOErrorInFunction(e.isDict() ? e.dict() : dict)
                    << "Entry '" << e.keyword() << "' is no type of clumps. Valid: "
                    << flatOutput(cloud().typeIds().sortedToc()) << exit(FatalIOError);
            }
            types_[cloud().typeIds()[e.keyword()]] =
                soluteType(Foam::getDict(types, e.keyword()), diffusivity_);
        }
        const word name(dict.getOrDefault<word>("field", "c"));
        if (!outer_.valid())
        {
            IOobject file
            (
                name, mesh_.time().timeName(), mesh_,
                IOobject::MUST_READ, IOobject::NO_WRITE
            );
            if (!file.typeHeaderOk<volScalarField>(true))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry 'field' is " << name << ", but the start time "
                    << mesh_.time().timeName() << " has no volScalarField of this name:"
                    << " the concentration outside, with its conditions at the patches."
                    << exit(FatalIOError);
            }
            outer_.reset(new volScalarField(file, mesh_));
        }
    }
    return
        fvMeshFunctionObject::read(dict) && table_.read(dict)
     && clumpTable_.read(dict);
}


Foam::autoPtr<Foam::volScalarField> Foam::functionObjects::clumpSolute::field
(
    const word& name
) const
{
    return autoPtr<volScalarField>::New
    (
        IOobject
        (
            name, mesh_.time().timeName(), mesh_,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE
        ),
        mesh_,
        dimensionedScalar("none", outer_->dimensions(), -GREAT),
        zeroGradientFvPatchScalarField::typeName
    );
}


const Foam::soluteType& Foam::functionObjects::clumpSolute::type
(
    const label celli
) const
{
    static const soluteType none(1);
    const label typei = surfaces_->type()[celli];
    return typei < 0 ? none : types_[typei];
}


void Foam::functionObjects::clumpSolute::start()
{
    const word& name = outer_->name();
    inner_ = field(name + "Inside");
    outerContent_ = field(name + "Content");
    innerContent_ = field(name + "InsideContent");
    bound_ = field(name + "Bound");
    outside_.reset(new phaseVolume(mesh_, name + "Volume"));
    inside_.reset(new phaseVolume(mesh_, name + "InsideVolume"));

    surfaces_.reset(new bodySurfaces(mesh_));
    surfaces_->update(cloud());
    const scalarField& alpha = surfaces_->fraction();
    outside_->start(1 - alpha);
    inside_->start(alpha);
    const auto begin = [](volScalarField& field, const scalarField& values)
    {
        if (gMin(field.primitiveField()) <= -GREAT)
        {
            field.primitiveFieldRef() = values;
            field.correctBoundaryConditions();
        }
    };
    scalarField initial(outer_->primitiveField());
    forAll(initial, celli)
    {
        initial[celli] = type(celli).initial(initial[celli]);
    }
    begin(*inner_, initial);
    setBound();
    begin(*outerContent_, outside_->volume()*(*outer_));
    begin(*innerContent_, inside_->volume()*(*inner_ + *bound_));
}


void Foam::functionObjects::clumpSolute::refusePlaces(const dictionary& dict) const
{
    if (!cloud().effects().active("sliding"))
    {
        return;
    }
    const word patch(placedCondition(*outer_));
    const word source
    (
        placedSource(fv::options::New(mesh_), outer_->name())
    );
    if (!patch.empty() || !source.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The mesh slides along with the clumps, and "
            << (patch.empty() ? "source " : "the condition of patch ")
            << (patch.empty() ? source : patch) << " of " << outer_->name()
            << " may depend on the place. Set effects { sliding off; } in clumpProperties."
            << exit(FatalIOError);
    }
}


bool Foam::functionObjects::clumpSolute::execute()
{
    if (functionObject::postProcess)
    {
        return true;
    }
    takeAlong();
    moveClumps();
    fillEmpty();
    solve();
    return true;
}


void Foam::functionObjects::clumpSolute::writeClumps()
{
    // Content and volume
    HashTable<vector, labelPair, labelPair::Hash<>> sums;
    forAll(mesh_.V(), celli)
    {
        if (inside_->active(celli) && surfaces_->type()[celli] >= 0)
        {
            sums(surfaces_->idOf(celli), Zero) += mesh_.V()[celli]*vector
            (
                (*innerContent_)[celli],
                inside_->volume()[celli],
                inside_->volume()[celli]*(*bound_)[celli]
            );
        }
    }
    reduceMap(sums, plusEqOp<vector>());
    if (!Pstream::master())
    {
        return;
    }
    tableHeader header("Content of each clump");
    header
       .add("time", "s").add("clump").add("origProc").add("content", "C.m3")
       .add("volume", "m3").add("bound", "C.m3")
       .explain("clump origProc", "number of the clump, and of the processor that it is of")
       .explain("content volume", "in the mesh cells that it is the nearest of all clumps to")
       .explain("bound", "part of the content that is bound");
    Ostream& os = clumpTable_.open(header);
    for (const labelPair& id : sums.sortedToc())
    {
        os  << mesh_.time().timeOutputValue() << '\t' << id.second() << '\t' << id.first()
            << '\t' << sums[id].x() << '\t' << sums[id].y() << '\t' << sums[id].z() << nl;
    }
    clumpTable_.flush();
}


bool Foam::functionObjects::clumpSolute::write()
{
    if (functionObject::postProcess)
    {
        return true;
    }
    const scalarField& V = mesh_.V();
    const scalar outer = gSum(V*outerContent_->primitiveField());
    const scalar inner = gSum(V*innerContent_->primitiveField());
    scalar lowest = GREAT;
    scalar highest = -GREAT;
    const auto add = [&](const phaseVolume& phase, const volScalarField& c, const label i)
    {
        if (phase.active(i))
        {
            lowest = min(lowest, c[i]);
            highest = max(highest, c[i]);
        }
    };
    forAll(V, celli)
    {
        add(*outside_, *outer_, celli);
        if (!fixed(celli))
        {
            add(*inside_, *inner_, celli);
        }
    }
    reduce(lowest, minOp<scalar>());
    reduce(highest, maxOp<scalar>());
    scalarList released(released_);
    Pstream::listCombineGather(released, plusEqOp<scalar>());
    scalarList through(through_);
    Pstream::listCombineGather(through, plusEqOp<scalar>());
    if (Pstream::master())
    {
        tableHeader header("Content of the mesh");
        header
           .add("time", "s").add("outside", "C.m3").add("inside", "C.m3")
           .add("entered", "C.m3").add("lowest", "C").add("highest", "C")
           .explain("outside inside", "clumps; C is the unit of the concentration")
           .explain("entered", "amount that clumps have brought along less what they have"
                " taken away, and less that of the fluid in their place, in this run")
           .explain("lowest highest", "concentrations outside and inside");
        for (label i = 0; i < types_.size(); ++i)
        {
            const word name("released_" + cloud().types()[i].name());
            header.add(name, "C.m3/s").explain
            (
                name, "amount that clumps of this type release through their surface"
            );
        }
        forAll(through, patchi)
        {
            const word name("out_" + mesh_.boundary()[patchi].name());
            header.add(name, "C.m3/s").explain(name, "amount that leaves through the patch");
        }
        Ostream& os = table_.open(header);
        os  << mesh_.time().timeOutputValue() << '\t' << outer << '\t' << inner << '\t'
            << entered_ << '\t' << lowest << '\t' << highest;
        for (const scalar r : released)
        {
            os  << '\t' << r;
        }
        for (const scalar t : through)
        {
            os  << '\t' << t;
        }
        os  << nl;
        table_.flush();
    }
    if (perClump_)
    {
        writeClumps();
    }
    if (mesh_.time().writeTime())
    {
        outer_->write();
        inner_->write();
        outerContent_->write();
        innerContent_->write();
        if (binds())
        {
            bound_->write();
        }
        outside_->write();
        inside_->write();
    }
    return true;
}
