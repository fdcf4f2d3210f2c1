/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpMigration.H"
#include "deformableCloud.H"
#include "addToRunTimeSelectionTable.H"
#include "foamCompat.H"
#include "unitConversion.H"
#include <cmath>
#include <limits>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpMigration, 0);
    addToRunTimeSelectionTable(functionObject, clumpMigration, dictionary);
}
}


Foam::functionObjects::clumpMigration::clumpMigration
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    table_(mesh_, name, typeName),
    clump_(-1),
    mean_(false),
    window_(0),
    length_(0),
    shift_(0),
    crossing_(0),
    stopPeriods_(0),
    stopDrift_(0)
{
    read(dict);
    readState();
}


bool Foam::functionObjects::clumpMigration::read(const dictionary& dict)
{
    checkEntries
    (
        dict,
        {
            "cloud", "clump", "mean", "flow", "gradient", "window", "period",
            "rowDistance", "stopAfterPeriods", "stopAtDrift"
        },
        functionObjectEntries()
    );
    cloudName_ = deformableCloud::findName(mesh_, dict);
    axes_ = flowAxes(dict);
    clump_ = getNumberOrDefault(dict, "clump", -1, -1, labelMax);
    checkClump(dict);
    mean_ = dict.getOrDefault("mean", false);
    window_ = getPositive(dict, "window");

    const vector period
    (
        getFiniteOrDefault<vector>(dict, "period", vector(0, 0, 0))
    );
    length_ = mag(period & axes_.flow);
    shift_ = (period & axes_.gradient)*((period & axes_.flow) < 0 ? -1 : 1);
    const bool inclined =
        mag(shift_) > 1e-3*length_ && length_ > 1e-3*mag(shift_);
    if (mag(period) > 0 && !inclined)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'period' is " << period << "; a row of posts must be"
            << " inclined to the flow " << axes_.flow << " in the plane of the"
            << " gradient " << axes_.gradient << '.' << exit(FatalIOError);
    }
    if (inclined)
    {
        const scalar distance =
            getPositiveOrDefault(dict, "rowDistance", mag(period));
        crossing_ =
            distance*Foam::sqrt(sqr(length_) + sqr(shift_))/(length_*mag(shift_));
    }

    stopPeriods_ = getNonNegativeOrDefault(dict, "stopAfterPeriods", 0);
    stopDrift_ = getNonNegativeOrDefault(dict, "stopAtDrift", 0);
    if (stopPeriods_ > 0 && !length_)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'stopAfterPeriods' needs the entry 'period'."
            << exit(FatalIOError);
    }

    return fvMeshFunctionObject::read(dict) && table_.read(dict);
}


void Foam::functionObjects::clumpMigration::checkClump
(
    const dictionary& dict
) const
{
    const auto* cloud = mesh_.findObject<deformableCloud>(cloudName_);
    if (clump_ < 0 || !cloud)
    {
        return;
    }
    bool found =
        cloud->properties().found("injection") || !cloud->outlets().empty();
    for (const clumpParcel& p : *cloud)
    {
        found = found || p.origId() == clump_;
    }
    if (!returnReduce(found, orOp<bool>()))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'clump': there is no clump with the number " << clump_
            << '.' << exit(FatalIOError);
    }
}


void Foam::functionObjects::clumpMigration::readState()
{
    if (postProcess || !propertyDict().found("paths"))
    {
        return;
    }
    const dictionary& paths = propertyDict().subDict("paths");
    for (const word& key : paths.toc())
    {
        const List<vector> state(getFiniteList<vector>(paths, key));
        label id = -1;
        if
        (
            state.size() < 2 || key.compare(0, 5, "clump") != 0
         || !Foam::read(key.substr(5), id)
        )
        {
            FatalIOErrorInFunction(paths)
                << "Entry '" << key << "' is not the path of a clump."
                << exit(FatalIOError);
        }
        before_[id] = pathWindow(state);
    }
}


void Foam::functionObjects::clumpMigration::writeState()
{
    dictionary paths;
    for (const auto& f : followers_)
    {
        setExact(paths, "clump" + Foam::name(f.first), f.second.path.state());
    }
    propertyDict().set("paths", paths);
}


void Foam::functionObjects::clumpMigration::follow()
{
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);

    DynamicList<label> numbers;
    DynamicList<label> typeIds;
    DynamicList<point> centres;
    for (const clumpParcel& p : cloud)
    {
        if (clump_ < 0 || p.origId() == clump_)
        {
            numbers.append(p.origId());
            typeIds.append(p.typeId());
            centres.append(p.unwrappedCentre(cloud.type(p)));
        }
    }

    List<labelList> ids(Pstream::nProcs());
    List<labelList> types(Pstream::nProcs());
    List<pointField> places(Pstream::nProcs());
    const label proci = Pstream::myProcNo();
    ids[proci].transfer(numbers);
    types[proci].transfer(typeIds);
    places[proci].transfer(centres);
    gatherToAll(ids);
    gatherToAll(types);
    gatherToAll(places);

    // Without those that have left
    std::map<label, follower> present;
    forAll(ids, i)
    {
        forAll(ids[i], k)
        {
            const label id = ids[i][k];
            const auto old = followers_.find(id);
            const auto restarted = before_.find(id);
            follower& f = present[id];
            if (old != followers_.end())
            {
                f = std::move(old->second);
            }
            else if (restarted != before_.end())
            {
                f.path = std::move(restarted->second);
            }
            f.type = cloud.types()[types[i][k]].name();

            const point& x = places[i][k];
            f.path.add
            (
                vector
                (
                    time_.timeOutputValue(), x & axes_.flow, x & axes_.gradient
                ),
                window_
            );
        }
    }
    followers_ = std::move(present);
    before_.clear();
}


bool Foam::functionObjects::clumpMigration::done() const
{
    if (followers_.empty())
    {
        return false;
    }
    bool far = stopPeriods_ > 0;
    bool slow = stopDrift_ > 0;
    for (const auto& f : followers_)
    {
        const pathWindow& path = f.second.path;
        far =
            far
         && mag(path.last().y() - path.begin().y()) >= stopPeriods_*length_;
        slow = slow && path.full(window_) && mag(path.across()) < stopDrift_;
    }
    return far || slow;
}


bool Foam::functionObjects::clumpMigration::execute()
{
    follow();
    if (!postProcess && time_.stopAt() != Time::saWriteNow && done())
    {
        Info<< type() << ' ' << name() << ": the clumps have come to where the run"
            << " is to end; the next time step is the last one" << nl << endl;
        time_.stopAt(Time::saWriteNow);
    }
    if (!postProcess && time_.writeTime())
    {
        writeState();
    }
    return true;
}


Foam::word Foam::functionObjects::clumpMigration::mode
(
    const scalar displacement,
    const scalar periods,
    const scalar crossing
)
{
    return
        periods < crossing ? "undecided"
      : displacement > 0.75 ? "displaced"
      : displacement < 0.25 ? "withFlow"
      : "between";
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpMigration::header() const
{
    tableHeader result("Migration of clumps across the stream");
    result
       .add("time", "s").add("clump").add("type").add("along", "m")
       .add("across", "m").add("drift", "m/s").add("angle", "degrees")
       .explain("time clump type", "number of the clump (-1: mean) and name of its type")
       .explain("along across", "centre of mass along flow and gradient, without jumps at"
            " periodic boundaries")
       .explain("drift angle", "velocity across, and angle of the path against the stream,"
            " over the window of time");
    if (length_)
    {
        result
           .add("periods").add("shift", "m").add("displacement").add("mode")
           .explain("periods shift", "way along over the period of the posts, and lateral"
                " shift per period over the window, or over the part of it in which the"
                " stream crosses a whole number of rows")
           .explain("displacement mode", "shift over that of the rows of posts: displaced"
                " above 3/4, withFlow below 1/4, or between; undecided while the window"
                " has less than " + Foam::name(crossing_) + " periods, after which the"
                " stream has crossed a row");
    }
    return result;
}


Foam::scalarList Foam::functionObjects::clumpMigration::values
(
    const pathWindow& path
) const
{
    const scalar u = path.along();
    const scalar v = path.across();
    scalarList result
    ({
        path.last().y(), path.last().z(), v, radToDeg(std::atan2(v, u))
    });
    if (length_)
    {
        // Over as many crossings of rows as the window has
        const scalar n = std::floor(path.way()/(crossing_*length_));
        const scalar way = n > 0 ? n*crossing_*length_ : GREAT;
        const scalar s = length_*path.inclination(way);
        result.append((path.last().y() - path.begin().y())/length_);
        result.append(s);
        result.append(s/shift_);
    }
    return result;
}


void Foam::functionObjects::clumpMigration::writeRow
(
    Ostream& os,
    const label id,
    const word& type,
    const scalarList& row,
    const scalar periods
) const
{
    os << time_.timeOutputValue() << '\t' << id << '\t' << type;
    for (const scalar value : row)
    {
        os << '\t' << value;
    }
    if (length_)
    {
        os  << '\t'
            <<
            (
                std::isnan(row.last())
              ? word("nan") : mode(row.last(), periods, crossing_)
            );
    }
    os << nl;
}


bool Foam::functionObjects::clumpMigration::write()
{
    if (!Pstream::master())
    {
        return true;
    }
    Ostream& os = table_.open(header());
    scalarList means;
    scalar least = GREAT;
    for (const auto& f : followers_)
    {
        const pathWindow& path = f.second.path;
        const scalarList row(values(path));
        const scalar periods = length_ ? path.way()/length_ : 0;
        least = min(least, periods);
        writeRow(os, f.first, f.second.type, row, periods);
        means.setSize(row.size(), 0);
        forAll(row, i)
        {
            means[i] += row[i]/followers_.size();
        }
    }
    if (mean_ && means.size())
    {
        writeRow(os, -1, "mean", means, least);
    }
    table_.flush();
    return true;
}
