/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpTable.H"
#include "deformableCloud.H"
#include "SortableList.H"
#include "StringStream.H"

Foam::functionObjects::clumpTable::clumpTable
(
    const word& name,
    const Time& runTime,
    const dictionary& dict,
    const word& fileName,
    const wordList& further
)
:
    fvMeshFunctionObject(name, runTime, dict),
    table_(mesh_, name, fileName),
    entries_({"cloud", "flow", "gradient"}),
    flow_(Zero),
    gradient_(Zero)
{
    entries_.append(further);
}


Foam::vector Foam::functionObjects::clumpTable::direction
(
    const dictionary& dict,
    const word& key,
    const vector& value
)
{
    const vector v(getFiniteOrDefault<vector>(dict, key, value));
    if (mag(v) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' must not be zero" << exit(FatalIOError);
    }
    return normalised(v);
}


Foam::scalar Foam::functionObjects::clumpTable::angle(const vector& v) const
{
    return std::atan2(v & gradient_, v & flow_);
}


bool Foam::functionObjects::clumpTable::read(const dictionary& dict)
{
    checkEntries(dict, entries_, functionObjectEntries());
    cloudName_ = deformableCloud::findName(mesh_, dict);
    flow_ = direction(dict, "flow", vector(1, 0, 0));
    gradient_ = direction(dict, "gradient", vector(0, 1, 0));
    if (mag(flow_ & gradient_) > 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "Entries 'flow' " << flow_ << " and 'gradient' " << gradient_
            << " are not at right angles." << exit(FatalIOError);
    }
    return fvMeshFunctionObject::read(dict) && table_.read(dict);
}


Foam::string Foam::functionObjects::clumpTable::columns
(
    const std::initializer_list<vector>& values
)
{
    OStringStream os;
    os.precision(10);
    for (const vector& v : values)
    {
        os << '\t' << v.x() << '\t' << v.y() << '\t' << v.z();
    }
    return os.str();
}


Foam::string Foam::functionObjects::clumpTable::columns
(
    const std::initializer_list<scalar>& values
)
{
    OStringStream os;
    os.precision(10);
    for (const scalar v : values)
    {
        os << '\t' << v;
    }
    return os.str();
}


const Foam::deformableCloud& Foam::functionObjects::clumpTable::cloud() const
{
    return mesh_.lookupObject<deformableCloud>(cloudName_);
}


bool Foam::functionObjects::clumpTable::write()
{
    DynamicList<label> ids;
    DynamicList<string> rows;
    for (const clumpParcel& p : cloud())
    {
        const clumpType& type = cloud().type(p);
        const string values(row(p, type));
        if (values.size())
        {
            ids.append(p.origId());
            rows.append(type.name() + values);
        }
    }

    List<List<label>> allIds(Pstream::nProcs());
    List<List<string>> allRows(Pstream::nProcs());
    allIds[Pstream::myProcNo()] = ids;
    allRows[Pstream::myProcNo()] = rows;
    Pstream::gatherList(allIds);
    Pstream::gatherList(allRows);

    if (Pstream::master())
    {
        DynamicList<label> id;
        DynamicList<string> text;
        forAll(allIds, proci)
        {
            id.append(allIds[proci]);
            text.append(allRows[proci]);
        }

        const tableHeader further(header());
        tableHeader all(further.title());
        all.add("time", "s").add("clump").add("type")
           .explain("time clump type", "number of the clump and name of its type")
           .add(further);
        Ostream& os = table_.open(all);
        const SortableList<label> order(id);
        forAll(order, k)
        {
            os  << time_.timeOutputValue() << '\t' << order[k] << '\t'
                << text[order.indices()[k]].c_str() << nl;
        }
        table_.flush();
    }

    return true;
}
