/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpCount.H"
#include "FlatOutput.H"
#include "foamCompat.H"
#include "labelVector.H"
#include "polyMesh.H"
#include "Time.H"

Foam::Ostream& Foam::operator<<(Ostream& os, const clumpPassage& p)
{
    return os
        << p.entered << token::SPACE << p.id << token::SPACE << p.typeId
        << token::SPACE << p.patchi << token::SPACE << p.centre
        << token::SPACE << p.velocity;
}


Foam::Istream& Foam::operator>>(Istream& is, clumpPassage& p)
{
    return is
        >> p.entered >> p.id >> p.typeId >> p.patchi >> p.centre >> p.velocity;
}


Foam::clumpCount::clumpCount
(
    const polyMesh& mesh,
    const PtrList<clumpType>& types,
    const word& cloudName
)
:
    mesh_(mesh),
    types_(types),
    file_
    (
        IOobject
        (
            cloudName + "Count", mesh.time().timeName(), "uniform",
            mesh.time(), IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE
        )
    ),
    nInside_(0)
{}


bool Foam::clumpCount::emptied() const
{
    return file_.getOrDefault<label>("nClumps", -1) == 0;
}


void Foam::clumpCount::check(const label nHere, const fileName& folder) const
{
    const label found = returnReduce(nHere, sumOp<label>());
    label written = -1;
    if (!file_.readIfPresent("nClumps", written) || written == found)
    {
        return;
    }

    labelList numbers(Pstream::nProcs());
    numbers[Pstream::myProcNo()] = nHere;
    Pstream::gatherList(numbers);

    FatalErrorInFunction
        << "The run that wrote " << mesh_.time().timePath() << " had "
        << written << " clumps, but " << found << " were found";
    if (Pstream::parRun())
    {
        FatalError << ", by processor " << flatOutput(numbers);
    }
    FatalError
        << '.' << nl << "    Files in " << folder
        << " are missing. To continue with the remaining clumps, remove "
        << file_.instance()/file_.local()/file_.name() << exit(FatalError);
}


void Foam::clumpCount::set(const label nInside)
{
    nInside_ = nInside;
    file_.set("nClumps", nInside_);
    if (!file_.found("placed"))
    {
        file_.set("placed", nInside_ + left() - entered() - brokenOff());
    }
}


void Foam::clumpCount::start(const label nHere)
{
    set(returnReduce(nHere, sumOp<label>()));
}


Foam::word Foam::clumpCount::patchName(const label patchi) const
{
    return patchi < 0 ? word("none") : mesh_.boundaryMesh()[patchi].name();
}


Foam::label Foam::clumpCount::total(const word& key) const
{
    label sum = 0;
    const dictionary& patches = file_.subOrEmptyDict(key);
    for (const word& patch : patches.toc())
    {
        const dictionary& types = patches.subDict(patch);
        for (const word& type : types.toc())
        {
            sum += types.get<label>(type);
        }
    }
    return sum;
}


void Foam::clumpCount::add
(
    const bool entered,
    const clumpParcel& p,
    const label patchi
)
{
    const clumpType& type = types_[p.typeId()];
    here_.append
    (
        {
            entered, p.origId(), p.typeId(), patchi, p.centre(type),
            p.state().velocity(type), entered ? clumpState() : p.state()
        }
    );
}


void Foam::clumpCount::gather()
{
    List<List<clumpPassage>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = here_;
    Pstream::gatherList(all);

    DynamicList<clumpPassage> sorted;
    for (const List<clumpPassage>& passages : all)
    {
        sorted.append(passages);
    }
    Foam::stableSort
    (
        sorted,
        [](const clumpPassage& a, const clumpPassage& b) { return a.id < b.id; }
    );
    passages_ = sorted;
    masterToAll(passages_);
}


void Foam::clumpCount::announce()
{
    for (const clumpPassage& p : passages_)
    {
        const word& type = types_[p.typeId].name();
        dictionary& numbers =
            file_.subDictOrAdd(p.entered ? "entered" : "left")
           .subDictOrAdd(patchName(p.patchi));
        numbers.set(type, numbers.getOrDefault<label>(type, 0) + 1);

        Info<< "Clump " << p.id << " (" << type << ") has "
            << (p.entered ? "entered" : "left") << " through patch "
            << patchName(p.patchi) << " at " << p.centre << nl;
    }
    Info<< "Clumps: " << nInside_ << " inside, " << entered() << " entered, "
        << left() << " left" << endl;
}


void Foam::clumpCount::endStep(const label nHere)
{
    const labelVector sums
    (
        returnReduce
        (
            labelVector(nHere, here_.size(), 0), sumOp<labelVector>()
        )
    );
    set(sums.x());
    passages_.clear();
    if (sums.y())
    {
        gather();
        announce();
        here_.clear();
    }

    const label lost = placed() + entered() + brokenOff() - left() - inside();
    if (lost)
    {
        FatalErrorInFunction
            << "Of " << placed() << " clumps placed, " << entered()
            << " that entered and " << brokenOff() << " pieces that broke off, "
            << left() << " have left and " << inside() << " are inside: "
            << lost << " are missing." << abort(FatalError);
    }
}
