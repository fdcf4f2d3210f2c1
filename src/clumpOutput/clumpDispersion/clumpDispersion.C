/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpDispersion.H"
#include "addToRunTimeSelectionTable.H"
#include "coupledPolyPatch.H"
#include "foamCompat.H"
#include "stateList.H"
#include "wallPolyPatch.H"
#include <cmath>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpDispersion, 0);
    addToRunTimeSelectionTable(functionObject, clumpDispersion, dictionary);
}
}


Foam::functionObjects::clumpDispersion::clumpDispersion
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    table_(mesh_, name, typeName),
    wallTable_(mesh_, name + "Walls", "clumpDispersionWalls"),
    wallDistance_(0),
    neighbourhood_(-1),
    before_(time_.value())
{
    read(dict);
    readState();
}


Foam::scalarList Foam::functionObjects::clumpDispersion::defaultLags(const Time& time)
{
    // What the file says, not what an adjustable step is
    const dictionary& control = time.controlDict();
    const scalar dt = control.getOrDefault<scalar>("deltaT", time.deltaTValue());
    const scalar end = control.getOrDefault<scalar>("endTime", time.endTime().value());

    DynamicList<scalar> lags;
    for (label power = std::floor(std::log10(10*dt)); lags.size() < 100; ++power)
    {
        for (const scalar digit : {1, 2, 5})
        {
            const scalar lag = digit*std::pow(10.0, scalar(power));
            if (lag > 0.2*end*(1 + 1e-6))
            {
                return scalarList(lags);
            }
            if (lag >= 10*dt*(1 - 1e-6))
            {
                lags.append(lag);
            }
        }
    }
    return scalarList(lags);
}


void Foam::functionObjects::clumpDispersion::readWall(const dictionary& dict)
{
    wallDistance_ = getNonNegativeOrDefault(dict, "wallDistance", 0);
    wallPatches_.clear();
    walls_.clear();
    if (!wallDistance_)
    {
        if (dict.found("wallPatches"))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'wallPatches' needs the entry 'wallDistance'."
                << exit(FatalIOError);
        }
        return;
    }
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    if (dict.found("wallPatches"))
    {
        wordList valid;
        for (const polyPatch& pp : patches)
        {
            if (!isA<coupledPolyPatch>(pp))
            {
                valid.append(pp.name());
            }
        }
        for (const word& name : dict.get<wordList>("wallPatches"))
        {
            if (!valid.found(name))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry 'wallPatches': there is no patch " << name << ". Valid: "
                    << flatOutput(valid) << exit(FatalIOError);
            }
            wallPatches_.insert(patches.findPatchID(name));
        }
    }
    else
    {
        for (const polyPatch& pp : patches)
        {
            if (isA<wallPolyPatch>(pp))
            {
                wallPatches_.insert(pp.index());
            }
        }
    }
    if (wallPatches_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'wallDistance' is " << wallDistance_ << ", but the mesh has no"
            << " patch of the type wall. Name one by the entry 'wallPatches', or leave"
            << " the entry out." << exit(FatalIOError);
    }
}


bool Foam::functionObjects::clumpDispersion::read(const dictionary& dict)
{
    checkEntries
    (
        dict,
        {
            "cloud", "types", "flow", "gradient", "lags", "between", "wallDistance",
            "wallPatches"
        },
        functionObjectEntries()
    );
    cloudName_ = deformableCloud::findName(mesh_, dict);
    types_ = typeSelection(dict, mesh_, cloudName_);
    axes_ = flowAxes(dict);

    scalarList lags(defaultLags(time_));
    if (dict.found("lags"))
    {
        lags = getFiniteList<scalar>(dict, "lags");
        for (const scalar lag : lags)
        {
            if (lag <= 0)
            {
                FatalIOErrorInFunction(dict)
                    << "Entry 'lags' is " << flatOutput(lags)
                    << "; lags are intervals of time above zero." << exit(FatalIOError);
            }
        }
    }
    if (lags.empty())
    {
        FatalIOErrorInFunction(dict)
            << "There is no lag" << (dict.found("lags") ? " in the entry 'lags'." : ":")
            << " Give the entry 'lags' intervals of time [s] in which clumps are displaced."
            << (dict.found("lags") ? "" : " The default ones are between ten times deltaT"
            " and a fifth of endTime, which is less here.")
            << exit(FatalIOError);
    }
    scalarMinMax between(-GREAT, GREAT);
    if (dict.found("between"))
    {
        const scalarList ends(getFiniteList<scalar>(dict, "between"));
        if (ends.size() != 2 || ends[0] >= ends[1])
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'between' is " << flatOutput(ends)
                << "; it has two places along the gradient, the lower one first."
                << exit(FatalIOError);
        }
        between = scalarMinMax(ends[0], ends[1]);
    }
    if
    (
        lags != lags_
     || between.min() != between_.min()
     || between.max() != between_.max()
    )
    {
        // Others begin anew
        dispersions_.clear();
    }
    lags_ = lags;
    between_ = between;
    readWall(dict);
    return fvMeshFunctionObject::read(dict) && table_.read(dict) && wallTable_.read(dict);
}


void Foam::functionObjects::clumpDispersion::readState()
{
    if (postProcess || !propertyDict().found("dispersion"))
    {
        return;
    }
    const dictionary& state = propertyDict().subDict("dispersion");

    // Of types and lags that are those of the run before
    const auto* cloud = mesh_.findObject<deformableCloud>(cloudName_);
    const dictionary& types = Foam::getDict(state, "types");
    for (const word& type : types.toc())
    {
        const label typei = cloud ? cloud->typeIds().lookup(type, -1) : -1;
        if (typei < 0 || !types_.holds(cloud->types()[typei]))
        {
            continue;
        }
        const dictionary& ofType = Foam::getDict(types, type);
        if (ofType.found("wall"))
        {
            visits_[type] = wallVisits(ofType);
        }
        std::vector<lagDispersion>& present = dispersion(type);
        const dictionary& lags = Foam::getDict(ofType, "lags");
        for (const word& key : lags.toc())
        {
            const lagDispersion before(Foam::getDict(lags, key), between_);
            for (lagDispersion& d : present)
            {
                if (mag(before.lag() - d.lag()) < 1e-9*d.lag())
                {
                    d = before;
                }
            }
        }
    }

    const scalar begun = stateReader(state, "time").number();
    if (mag(begun - time_.value()) > 1e-6*time_.deltaTValue())
    {
        // The clumps have moved since then, unobserved
        for (auto& type : dispersions_)
        {
            for (lagDispersion& d : type.second)
            {
                d.endAll();
            }
        }
        writeState();
        return;
    }
    const dictionary& places = Foam::getDict(state, "places");
    for (const word& type : places.toc())
    {
        stateReader numbers(places, type);
        while (!numbers.done())
        {
            place& p = places_[label(numbers.number())];
            p.type = type;
            p.typeId = label(numbers.number());
            p.x = numbers.threeNumbers();
            p.atWall = false;
        }
    }

    // The lists are no longer there
    writeState();
}


void Foam::functionObjects::clumpDispersion::writeState()
{
    dictionary types;
    dictionary places;
    for (const auto& ofType : dispersions_)
    {
        dictionary lags;
        label n = 0;
        for (const lagDispersion& d : ofType.second)
        {
            lags.set(word("lag" + Foam::name(n++)), d.state());
        }
        dictionary all;
        if (wallDistance_)
        {
            all = visits_[ofType.first].state();
        }
        all.set("lags", lags);
        types.set(ofType.first, all);

        DynamicList<scalar> numbers;
        for (const auto& p : places_)
        {
            if (p.second.type == ofType.first)
            {
                numbers.append(p.first);
                numbers.append(p.second.typeId);
                appendTo(numbers, p.second.x);
            }
        }
        setStateList(places, ofType.first, numbers);
    }
    dictionary state;
    setStateList(state, "time", scalarList(1, before_));
    state.set("types", types);
    state.set("places", places);
    propertyDict().set("dispersion", state);
}


void Foam::functionObjects::clumpDispersion::updateWalls()
{
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    if (mesh_.changing() || !ghosts_.valid())
    {
        ghosts_.reset(new ghostExchange(mesh_));
        walls_.clear();
    }
    UList<clumpImage>& own = ghosts_->own(cloud.size());
    label i = 0;
    for (const clumpParcel& p : cloud)
    {
        own[i].set(p, cloud.type(p), p.state(), i);
        own[i].reach += wallDistance_;
        ++i;
    }
    ghosts_->updateNeighbours();
    if (walls_.valid() && neighbourhood_ == ghosts_->neighbourhood())
    {
        return;
    }
    neighbourhood_ = ghosts_->neighbourhood();
    DynamicList<face> faces;
    for (const label patchi : wallPatches_.sortedToc())
    {
        faces.append(mesh_.boundaryMesh()[patchi]);
    }
    walls_.reset(new wallSurface(faces, mesh_.points(), *ghosts_));
}


bool Foam::functionObjects::clumpDispersion::atWall
(
    const clumpParcel& p,
    const clumpType& type
) const
{
    const pointField x(p.centres());
    forAll(x, i)
    {
        const scalar limit =
            wallDistance_ + (type.hasTriangles() ? scalar(0) : type.radii()[i]);
        if (walls_->distance(x[i], limit) < limit)
        {
            return true;
        }
    }
    return false;
}


std::map<Foam::label, Foam::functionObjects::clumpDispersion::place>
Foam::functionObjects::clumpDispersion::find()
{
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    if (wallDistance_)
    {
        updateWalls();
    }

    // Number, type of the whole and its own, whether it is at the wall
    List<labelList> ids(Pstream::nProcs());
    List<pointField> centres(Pstream::nProcs());
    DynamicList<label> numbers;
    DynamicList<point> x;
    for (const clumpParcel& p : cloud)
    {
        if (types_.holds(cloud, p))
        {
            const clumpType& type = cloud.type(p);
            numbers.append(p.origId());
            numbers.append(cloud.wholeType(p));
            numbers.append(p.typeId());
            numbers.append(wallDistance_ && atWall(p, type));
            x.append(axes_.local(p.unwrappedCentre(type)));
        }
    }
    ids[Pstream::myProcNo()].transfer(numbers);
    centres[Pstream::myProcNo()].transfer(x);
    gatherToAll(ids);
    gatherToAll(centres);

    std::map<label, place> result;
    forAll(centres, proci)
    {
        const labelList& n = ids[proci];
        forAll(centres[proci], i)
        {
            place& p = result[n[4*i]];
            p.type = cloud.types()[n[4*i + 1]].name();
            p.typeId = n[4*i + 2];
            p.atWall = n[4*i + 3];
            p.x = centres[proci][i];
        }
    }
    return result;
}


std::vector<Foam::functionObjects::lagDispersion>&
Foam::functionObjects::clumpDispersion::dispersion(const word& type)
{
    std::vector<lagDispersion>& result = dispersions_[type];
    if (result.empty())
    {
        for (const scalar lag : lags_)
        {
            result.push_back(lagDispersion(lag, between_));
        }
    }
    return result;
}


bool Foam::functionObjects::clumpDispersion::execute()
{
    std::map<label, place> now(find());
    const scalar t = time_.value();

    // In the order of the numbers, whatever the processors of the clumps are
    for (const auto& clump : places_)
    {
        const place& p = clump.second;
        const auto found = now.find(clump.first);
        if (found == now.end() || found->second.typeId != p.typeId)
        {
            for (lagDispersion& d : dispersion(p.type))
            {
                d.end(clump.first);
            }
        }
    }
    for (const auto& clump : now)
    {
        const place& p = clump.second;
        const auto before = places_.find(clump.first);
        for (lagDispersion& d : dispersion(p.type))
        {
            if (before != places_.end() && before->second.typeId == p.typeId)
            {
                d.follow(clump.first, before_, before->second.x, t, p.x);
            }
            else
            {
                d.begin(clump.first, t, p.x);
            }
        }
    }
    for (auto& type : dispersions_)
    {
        for (lagDispersion& d : type.second)
        {
            d.reach(t);
        }
        if (wallDistance_)
        {
            std::map<label, bool> at;
            for (const auto& clump : now)
            {
                if (clump.second.type == type.first)
                {
                    at[clump.first] = clump.second.atWall;
                }
            }
            visits_[type.first].add(at, t - before_);
        }
    }
    places_ = std::move(now);
    before_ = t;
    if (!postProcess && time_.writeTime())
    {
        writeState();
    }
    return true;
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpDispersion::header()
{
    return
        tableHeader("Displacements of clumps over lags of time")
       .add("time", "s").add("type").add("lag", "s").add("clumps").add("n")
       .add("meanFlow", "m").add("msdFlow", "m2")
       .add("meanGradient", "m").add("msdGradient", "m2")
       .add("DGradient", "m2/s").add("errorGradient", "m2/s")
       .add("meanVorticity", "m").add("msdVorticity", "m2")
       .add("DVorticity", "m2/s").add("errorVorticity", "m2/s")
       .explain("time type lag", "name of the type of the clumps, interval of time")
       .explain("clumps n", "number of clumps and of displacements over the lag, since the"
            " first run began")
       .explain("meanFlow msdFlow meanGradient msdGradient meanVorticity msdVorticity",
            "displacement and its square along the flow, along its gradient and along the"
            " vorticity, means over n")
       .explain("DGradient errorGradient DVorticity errorVorticity", "msd over twice the"
            " lag, and its standard error, nan before there are eight clumps or blocks of"
            " eight lags");
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpDispersion::wallHeader()
{
    return
        tableHeader("Clumps at the wall")
       .add("time", "s").add("type").add("clumps").add("atWall").add("share")
       .add("timeShare").add("arrivals").add("departures").add("stay", "s")
       .add("flux", "1/(m2.s)")
       .explain("time type clumps atWall share", "name of a type of clumps, number of them,"
            " how many are at the wall, and that over their number")
       .explain("timeShare arrivals departures", "time of clumps at the wall over that of"
            " clumps, clumps that have come to the wall and gone from it; since the first"
            " run began")
       .explain("stay flux", "time at the wall over departures; arrivals less departures,"
            " over the area of the wall and the time");
}


bool Foam::functionObjects::clumpDispersion::write()
{
    scalar area = 0;
    for (const label patchi : wallPatches_.sortedToc())
    {
        area += gSum(mesh_.magSf().boundaryField()[patchi]);
    }
    if (!Pstream::master())
    {
        return true;
    }
    Ostream& os = table_.open(header());
    for (const auto& type : dispersions_)
    {
        for (const lagDispersion& d : type.second)
        {
            const vector mean(d.mean());
            const vector msd(d.msd());
            const vector D(msd/(2*d.lag()));
            const vector error(d.error()/(2*d.lag()));
            os  << time_.timeOutputValue() << '\t' << type.first << '\t' << d.lag()
                << '\t' << d.nPaths() << '\t' << d.n();
            for (const direction k : {vector::Z, vector::X, vector::Y})
            {
                os  << '\t' << mean[k] << '\t' << msd[k];
                if (k != vector::Z)
                {
                    os  << '\t' << D[k] << '\t' << error[k];
                }
            }
            os  << nl;
        }
    }
    table_.flush();

    if (wallDistance_)
    {
        Ostream& wall = wallTable_.open(wallHeader());
        for (const auto& type : visits_)
        {
            const wallVisits& v = type.second;
            wall<< time_.timeOutputValue() << '\t' << type.first << '\t' << v.clumps()
                << '\t' << v.atWall() << '\t' << v.share() << '\t' << v.timeShare()
                << '\t' << v.arrivals() << '\t' << v.departures() << '\t' << v.stay()
                << '\t' << v.flux(area) << nl;
        }
        wallTable_.flush();
    }
    return true;
}
