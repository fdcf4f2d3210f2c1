/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "branchFlow.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntries.H"
#include "deformableCloud.H"
#include "StringStream.H"
#include "stringList.H"
#include "surfaceFields.H"
#include <limits>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(branchFlow, 0);
    addToRunTimeSelectionTable(functionObject, branchFlow, dictionary);
}
}


namespace
{

using namespace Foam;

const scalar notANumber = std::numeric_limits<scalar>::quiet_NaN();

//- a/b; none where less than three quarters of what makes up b goes the same way
scalar oneWay(const scalar a, const scalar b, const scalar gross)
{
    return mag(b) > 0.5*gross ? a/b : notANumber;
}


//- Numbers as texts, with every bit of them: the file of the states of function objects
//  has 16 digits
stringList texts(const UList<scalar>& values)
{
    stringList result(values.size());
    forAll(values, i)
    {
        OStringStream os;
        os.precision(17);
        os << values[i];
        result[i] = os.str();
    }
    return result;
}


scalarList numbers(const UList<string>& texts)
{
    scalarList result(texts.size());
    forAll(texts, i)
    {
        result[i] = readScalar(texts[i]);
    }
    return result;
}

}


void Foam::functionObjects::branchFlow::branch::add(const branch& other)
{
    flux += other.flux;
    volume += other.volume;
    gross += other.gross;
    clumps += other.clumps;
    grossClumps += other.grossClumps;
    entered += other.entered;
    left += other.left;
    addTimes(other.timed, other.residence, other.squares);
}


void Foam::functionObjects::branchFlow::branch::addTimes
(
    const label n,
    const scalar mean,
    const scalar squared
)
{
    if (n)
    {
        const scalar all = timed + n;
        const scalar d = mean - residence;
        squares += squared + sqr(d)*timed*n/all;
        residence += d*n/all;
        timed += n;
    }
}


Foam::scalar
Foam::functionObjects::branchFlow::branch::haematocrit() const
{
    return oneWay(clumps, volume, gross);
}


Foam::functionObjects::branchFlow::branchFlow
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    table_(mesh_, name, typeName)
{
    read(dict);
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    for (label patchi = 0; patchi < patches.nNonProcessor(); ++patchi)
    {
        if (openPatches::isOpen(patches[patchi]))
        {
            branches_[patchi] = none();
        }
    }
    if (branches_.empty() && !postProcess)
    {
        FatalIOErrorInFunction(dict)
            << "The mesh has no patch that fluid and clumps can cross, an inlet or outlet of"
            << " the type patch: there is nothing to be written by " << typeName << '.'
            << exit(FatalIOError);
    }
    branches_[-1] = none();
    readState();
}


bool Foam::functionObjects::branchFlow::read(const dictionary& dict)
{
    checkEntries(dict, {"cloud"}, functionObjectEntries());
    refuseSkippedSteps(dict);
    cloudName_ = deformableCloud::findName(mesh_, dict);
    return fvMeshFunctionObject::read(dict) && table_.read(dict);
}


const Foam::deformableCloud& Foam::functionObjects::branchFlow::cloud() const
{
    return mesh_.lookupObject<deformableCloud>(cloudName_);
}


Foam::functionObjects::branchFlow::branch
Foam::functionObjects::branchFlow::none() const
{
    branch result;
    const auto* clumps = mesh_.findObject<deformableCloud>(cloudName_);
    result.entered.setSize(clumps ? clumps->nTypes() : 0, 0);
    result.left = result.entered;
    return result;
}


Foam::word Foam::functionObjects::branchFlow::patchName(const label patchi) const
{
    return patchi < 0 ? word("none") : mesh_.boundaryMesh()[patchi].name();
}


void Foam::functionObjects::branchFlow::readState()
{
    if (postProcess || !propertyDict().found("branches"))
    {
        return;
    }
    const dictionary& all = propertyDict().subDict("branches");
    for (auto& b : branches_)
    {
        if (!all.found(patchName(b.first)))
        {
            continue;
        }
        const dictionary& dict = all.subDict(patchName(b.first));
        branch& to = b.second;
        const scalarList sums(numbers(dict.get<stringList>("sums")));
        to.volume = sums[0];
        to.gross = sums[1];
        to.clumps = sums[2];
        to.grossClumps = sums[3];
        to.residence = sums[4];
        to.squares = sums[5];
        to.timed = dict.get<label>("timed");
        for (label i = 0; i < cloud().nTypes(); ++i)
        {
            const word& type = cloud().types()[i].name();
            to.entered[i] = dict.subDict("entered").getOrDefault<label>(type, 0);
            to.left[i] = dict.subDict("left").getOrDefault<label>(type, 0);
        }
    }
    const labelList ids(propertyDict().get<labelList>("clumps"));
    const scalarList times(numbers(propertyDict().get<stringList>("since")));
    forAll(ids, i)
    {
        since_[ids[i]] = times[i];
    }
}


void Foam::functionObjects::branchFlow::writeState()
{
    dictionary all;
    for (const auto& b : branches_)
    {
        const branch& from = b.second;
        dictionary dict;
        dict.set
        (
            "sums",
            texts
            (
                scalarList
                ({
                    from.volume, from.gross, from.clumps, from.grossClumps,
                    from.residence, from.squares
                })
            )
        );
        dict.set("timed", from.timed);
        dictionary entered;
        dictionary left;
        forAll(from.left, i)
        {
            entered.set(cloud().types()[i].name(), from.entered[i]);
            left.set(cloud().types()[i].name(), from.left[i]);
        }
        dict.set("entered", entered);
        dict.set("left", left);
        all.set(patchName(b.first), dict);
    }
    propertyDict().set("branches", all);

    DynamicList<label> ids;
    DynamicList<scalar> times;
    for (const auto& clump : since_)
    {
        ids.append(clump.first);
        times.append(clump.second);
    }
    propertyDict().set("clumps", labelList(ids));
    propertyDict().set("since", texts(times));
}


void Foam::functionObjects::branchFlow::add(const clumpPassage& p)
{
    const clumpType& type = cloud().types()[p.typeId];
    const label whole = type.whole(p.typeId);
    const scalar now = time_.timeOutputValue();

    branch& b = branches_[p.patchi];
    const scalar V = type.nominalVolume();
    b.clumps += p.entered ? -V : V;
    b.grossClumps += V;
    if (p.entered)
    {
        ++b.entered[whole];
        since_[p.id] = now;
        return;
    }
    ++b.left[whole];
    const auto found = since_.find(p.id);
    if (found != since_.end())
    {
        b.addTimes(1, now - found->second, 0);
        since_.erase(found);
    }
}


bool Foam::functionObjects::branchFlow::execute()
{
    if (postProcess)
    {
        return true;
    }
    const auto* phi = mesh_.findObject<surfaceScalarField>("phi");
    if (!phi)
    {
        FatalErrorInFunction
            << name() << ": there is no fluid whose flux could be written"
            << exit(FatalError);
    }
    for (auto& b : branches_)
    {
        if (b.first >= 0)
        {
            branch& to = b.second;
            to.flux = gSum(phi->boundaryField()[b.first]);
            to.volume += to.flux*time_.deltaTValue();
            to.gross += mag(to.flux)*time_.deltaTValue();
        }
    }
    for (const clumpPassage& p : cloud().count().passages())
    {
        add(p);
    }
    if (time_.writeTime())
    {
        writeState();
    }
    return true;
}


Foam::functionObjects::tableHeader
Foam::functionObjects::branchFlow::header() const
{
    tableHeader result("What flows through the open patches, outwards positive");
    result
       .add("time", "s").add("patch").add("Q", "m3/s").add("V", "m3").add("Vc", "m3")
       .add("entered").add("left")
       .add("Hd").add("flow").add("clumps").add("skimming")
       .add("residence", "s").add("residenceDeviation", "s").add("timed").add("inside")
       .explain("time patch", "all: sums over the patches, and the clumps put inside the mesh")
       .explain("Q V", "volume flux of fluid and clumps, and its sum over time")
       .explain("Vc entered left", "volume of the clumps that have left less that of those"
            " that have entered, and the numbers of both")
       .explain("Hd", "discharge haematocrit Vc/V, with the clumps of all types")
       .explain("flow clumps", "parts of V and of the volume Vc of the clumps, among the"
            " patches through which more leaves than enters")
       .explain("skimming", "Hd over that of the patches through which more enters")
       .explain("residence residenceDeviation timed", "mean and standard deviation of the"
            " time from entering to leaving here, and the number of clumps with such a time")
       .explain("inside", "number of clumps in the mesh");
    for (label i = 0; i < cloud().nTypes(); ++i)
    {
        const word& type = cloud().types()[i].name();
        result.add("entered_" + type).add("left_" + type);
        result.explain
        (
            "entered_" + type + " left_" + type, "of this type of clump and its pieces"
        );
    }
    return result;
}


void Foam::functionObjects::branchFlow::writeRow
(
    Ostream& os,
    const word& patch,
    const branch& b,
    const branch& in,
    const branch& out
) const
{
    const bool leaves = b.volume > 0.5*b.gross;
    const scalarList ratios
    ({
        b.haematocrit(),
        leaves && out.volume > 0 ? b.volume/out.volume : notANumber,
        leaves && out.clumps > 0 ? b.clumps/out.clumps : notANumber,
        leaves && in.clumps < 0 ? b.haematocrit()/in.haematocrit() : notANumber,
        b.timed ? b.residence : notANumber,
        b.timed > 1 ? Foam::sqrt(b.squares/(b.timed - 1)) : notANumber
    });
    os  << time_.timeOutputValue() << '\t' << patch << '\t' << b.flux << '\t' << b.volume
        << '\t' << b.clumps << '\t' << sum(b.entered) << '\t' << sum(b.left);
    for (const scalar ratio : ratios)
    {
        os  << '\t' << ratio;
    }
    os  << '\t' << b.timed << '\t' << cloud().count().inside();
    forAll(b.left, i)
    {
        os  << '\t' << b.entered[i] << '\t' << b.left[i];
    }
    os  << nl;
}


bool Foam::functionObjects::branchFlow::write()
{
    if (postProcess)
    {
        Info<< name() << ": what flows through the patches is known in the run only; no"
            << " table is written" << endl;
        return true;
    }
    if (!Pstream::master())
    {
        return true;
    }
    branch all(none());
    branch in(none());
    branch out(none());
    for (const auto& b : branches_)
    {
        all.add(b.second);
        if (b.second.volume < -0.5*b.second.gross)
        {
            in.add(b.second);
        }
        else if (b.second.volume > 0.5*b.second.gross)
        {
            out.add(b.second);
        }
    }
    Ostream& os = table_.open(header());
    for (const auto& b : branches_)
    {
        if (b.first >= 0)
        {
            writeRow(os, patchName(b.first), b.second, in, out);
        }
    }
    writeRow(os, "all", all, none(), none());
    table_.flush();
    return true;
}
