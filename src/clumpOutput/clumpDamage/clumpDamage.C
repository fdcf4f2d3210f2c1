/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpDamage.H"
#include "addToRunTimeSelectionTable.H"
#include "clumpDeformation.H"
#include "foamCompat.H"
#include "stateList.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpDamage, 0);
    addToRunTimeSelectionTable(functionObject, clumpDamage, dictionary);
}
}


Foam::functionObjects::clumpDamage::clumpDamage
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    table_(mesh_, name, typeName),
    typeTable_(mesh_, name + "Types", "clumpDamageTypes"),
    stops_(false),
    last_(time_.value())
{
    read(dict);
    readState();
}


void Foam::functionObjects::clumpDamage::readModels(const dictionary& dict)
{
    const dictionary& models = Foam::getDict(dict, "models");
    const wordList names(models.toc());
    models_.clear();
    models_.setSize(names.size());
    limits_.setSize(names.size());
    if (names.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'models' has no model of damage. Give one under a name of your choice, as"
            << " haemolysis { type powerLaw; constants zhang; }." << exit(FatalIOError);
    }
    forAll(names, m)
    {
        const dictionary& model = Foam::getDict(models, names[m]);
        models_.set(m, selectModel<damageModel>(model).ptr());
        limits_[m] = model.found("limit") ? getPositive(model, "limit") : GREAT;
    }

    const auto* cloud = mesh_.findObject<deformableCloud>(cloudName_);
    if (cloud && !cloud->hasFluid())
    {
        FatalIOErrorInFunction(dict)
            << "The damage of clumps follows from the stress of the fluid, and this case"
            << " has none (constant/transportProperties; effects, fluid)."
            << exit(FatalIOError);
    }
    forAll(names, m)
    {
        bool surfaces = !cloud;
        for (label i = 0; cloud && i < cloud->nTypes(); ++i)
        {
            const clumpType& type = cloud->types()[i];
            surfaces = surfaces || (types_.holds(type) && type.hasTriangles());
        }
        if (models_[m].ofMembranes() && !surfaces)
        {
            FatalIOErrorInFunction(models.subDict(names[m]))
                << "The model " << models_[m].type() << " needs the surface of a membrane,"
                << " and none of the types of clumps here is one." << exit(FatalIOError);
        }
    }

    // The histories of the models that have been there
    labelList numbers(names.size());
    forAll(names, m)
    {
        numbers[m] = names_.find(names[m]);
    }
    for (auto& h : histories_)
    {
        h.second.select(numbers);
    }
    names_ = names;
}


bool Foam::functionObjects::clumpDamage::read(const dictionary& dict)
{
    checkEntries
    (
        dict,
        {"cloud", "types", "models", "distance", "stopAtLimit"},
        functionObjectEntries()
    );
    cloudName_ = deformableCloud::findName(mesh_, dict);
    types_ = typeSelection(dict, mesh_, cloudName_);
    readModels(dict);

    const scalar V = gSum(mesh_.V().field());
    const label n = returnReduce(mesh_.nCells(), sumOp<label>());
    stress_.reset
    (
        new surroundingStress
        (
            mesh_, getPositiveOrDefault(dict, "distance", Foam::cbrt(V/n))
        )
    );
    stops_ = dict.getOrDefault("stopAtLimit", false);
    return
        fvMeshFunctionObject::read(dict) && table_.read(dict) && typeTable_.read(dict);
}


void Foam::functionObjects::clumpDamage::readState()
{
    const auto* cloud = mesh_.findObject<deformableCloud>(cloudName_);
    if (postProcess || !cloud || !propertyDict().found("damage"))
    {
        return;
    }
    const dictionary& state = propertyDict().subDict("damage");
    const wordList names(getEntry<wordList>(state, "models"));
    labelList numbers(names_.size());
    forAll(names_, m)
    {
        numbers[m] = names.find(names_[m]);
    }
    const dictionary& clumps = Foam::getDict(state, "clumps");
    for (const word& type : clumps.toc())
    {
        label typeId = -1;
        forAll(cloud->types(), i)
        {
            typeId = cloud->types()[i].name() == type ? i : typeId;
        }
        stateReader numbersOf(clumps, type);
        while (typeId >= 0 && !numbersOf.done())
        {
            const label id = label(numbersOf.number());
            damageHistory h(numbersOf, typeId);
            const label size = h.models.empty() ? 0 : h.models[0].size();
            if (h.models.size() != names.size() || size != cloud->types()[typeId].size())
            {
                FatalIOErrorInFunction(clumps)
                    << "Entry '" << type << "' is not the history of the clumps of this"
                    << " type. Remove the entry of this function object from the file to"
                    << " begin anew." << exit(FatalIOError);
            }
            h.select(numbers);
            before_[id] = h;
        }
    }

    // The lists are no longer there
    setState(before_);
}


void Foam::functionObjects::clumpDamage::writeState()
{
    // All processors keep those of all of them
    List<scalarList> own(Pstream::nProcs());
    DynamicList<scalar> numbers;
    for (const auto& h : histories_)
    {
        numbers.append(h.first);
        numbers.append(h.second.typeId);
        h.second.append(numbers);
    }
    own[Pstream::myProcNo()].transfer(numbers);
    gatherToAll(own);

    std::map<label, damageHistory> all;
    for (const scalarList& values : own)
    {
        stateReader reader(values);
        while (!reader.done())
        {
            const label id = label(reader.number());
            const label typeId = label(reader.number());
            all[id] = damageHistory(reader, typeId);
        }
    }
    setState(all);
}


void Foam::functionObjects::clumpDamage::setState
(
    const std::map<label, damageHistory>& all
)
{
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    std::map<word, DynamicList<scalar>> types;
    for (const auto& h : all)
    {
        DynamicList<scalar>& numbers = types[cloud.types()[h.second.typeId].name()];
        numbers.append(h.first);
        h.second.append(numbers);
    }
    dictionary clumps;
    for (const auto& type : types)
    {
        setStateList(clumps, type.first, type.second);
    }
    dictionary state;
    state.set("models", names_);
    state.set("clumps", clumps);
    propertyDict().set("damage", state);
}


bool Foam::functionObjects::clumpDamage::has(const clumpParcel& p) const
{
    const auto h = histories_.find(p.origId());
    return h != histories_.end() && h->second.typeId == p.typeId();
}


void Foam::functionObjects::clumpDamage::followClumps()
{
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    const auto take = [&](const clumpParcel& p, const damageHistory& h)
    {
        histories_[p.origId()] =
            h.typeId == p.typeId()
          ? h : h.ofPiece(p.typeId(), cloud.type(p), cloud.types()[h.typeId]);
    };

    // Clumps that have no history here, or that of a larger one
    std::map<label, const clumpParcel*> lacking;
    for (const clumpParcel& p : cloud)
    {
        if (!types_.holds(cloud, p))
        {
            continue;
        }
        const auto restarted = before_.find(p.origId());
        if (restarted != before_.end())
        {
            take(p, restarted->second);
        }
        if (!has(p))
        {
            lacking[p.origId()] = &p;
        }
    }
    before_.clear();
    if (returnReduce(!lacking.empty(), orOp<bool>()))
    {
        // Numbers that may be those of their histories
        List<labelList> wanted(Pstream::nProcs());
        DynamicList<label> ids;
        for (const auto& l : lacking)
        {
            ids.append(l.first);
            if (l.second->pieceOf() >= 0)
            {
                ids.append(l.second->pieceOf());
            }
        }
        wanted[Pstream::myProcNo()].transfer(ids);
        gatherToAll(wanted);

        List<scalarList> found(Pstream::nProcs());
        DynamicList<scalar> numbers;
        labelHashSet sent;
        for (const labelList& list : wanted)
        {
            for (const label id : list)
            {
                const auto h = histories_.find(id);
                if (h != histories_.end() && sent.insert(id))
                {
                    numbers.append(id);
                    numbers.append(h->second.typeId);
                    h->second.append(numbers);
                }
            }
        }
        found[Pstream::myProcNo()].transfer(numbers);
        gatherToAll(found);

        std::map<label, damageHistory> others;
        for (const scalarList& values : found)
        {
            stateReader reader(values);
            while (!reader.done())
            {
                const label id = label(reader.number());
                const label typeId = label(reader.number());
                others[id] = damageHistory(reader, typeId);
            }
        }
        for (const auto& l : lacking)
        {
            const clumpParcel& p = *l.second;
            auto h = others.find(p.origId());
            if (h == others.end() && p.pieceOf() >= 0)
            {
                h = others.find(p.pieceOf());
            }
            if (h != others.end())
            {
                take(p, h->second);
            }
            else
            {
                histories_[p.origId()] =
                    damageHistory(p.typeId(), cloud.type(p), models_.size());
            }
        }
    }

    // Of clumps that are here only
    std::map<label, damageHistory> here;
    for (const clumpParcel& p : cloud)
    {
        if (types_.holds(cloud, p))
        {
            here[p.origId()] = std::move(histories_[p.origId()]);
        }
    }
    histories_ = std::move(here);
}


Foam::Tuple2<Foam::scalar, Foam::scalar>
Foam::functionObjects::clumpDamage::damage
(
    const damageHistory& h,
    const label model
) const
{
    scalar sum = 0, largest = 0;
    for (const scalar history : h.models[model])
    {
        const scalar D = models_[model].damage(history);
        sum += D;
        largest = max(largest, D);
    }
    return Tuple2<scalar, scalar>(sum/h.models[model].size(), largest);
}


void Foam::functionObjects::clumpDamage::addPassed
(
    const clumpParcel& p,
    const word& type,
    const UList<scalar>& from,
    const UList<scalar>& to,
    DynamicList<string>& said
) const
{
    forAll(to, m)
    {
        if (from[m] < limits_[m] && to[m] >= limits_[m])
        {
            OStringStream os;
            os  << "Clump " << p.origId() << " (" << type << "): the damage " << names_[m]
                << " is " << to[m] << " and has passed the limit of " << limits_[m];
            said.append(os.str());
        }
    }
}


void Foam::functionObjects::clumpDamage::atLimit(const UList<string>& said)
{
    List<List<string>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = said;
    Pstream::gatherList(all);
    for (const List<string>& messages : all)
    {
        for (const string& message : messages)
        {
            Info<< type() << ' ' << name() << ": " << message.c_str() << nl;
        }
    }
    if (stops_ && time_.stopAt() != Time::saWriteNow)
    {
        Info<< type() << ' ' << name() << ": the next time step is the last one" << nl;
        time_.stopAt(Time::saWriteNow);
    }
    Info<< endl;
}


bool Foam::functionObjects::clumpDamage::execute()
{
    if (postProcess)
    {
        return true;
    }
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    const scalar dt = time_.value() - last_;
    last_ = time_.value();
    followClumps();
    const List<scalarField> stresses
    (
        stress_->find
        (
            cloud,
            mesh_.lookupObject<volVectorField>("U"),
            mesh_.lookupObject<volScalarField>("nu")
        )
    );

    loads_.clear();
    DynamicList<string> said;
    label n = -1;
    for (const clumpParcel& p : cloud)
    {
        ++n;
        if (!types_.holds(cloud, p))
        {
            continue;
        }
        const clumpType& type = cloud.type(p);
        damageHistory& h = histories_[p.origId()];
        damageModel::load largest;
        largest.stress = max(stresses[n]);
        largest.deformation = clumpDeformation::index(type, p.state().x);
        const scalarField strains(clumpDeformation::arealStrains(type, p.state().x));
        largest.arealStrain = max(strains);
        loads_[p.origId()] = largest;
        h.stress = max(h.stress, largest.stress);
        h.deformation = max(h.deformation, largest.deformation);
        h.arealStrain = max(h.arealStrain, largest.arealStrain);

        scalarList from(models_.size()), to(models_.size());
        forAll(models_, m)
        {
            from[m] = damage(h, m).first();
            forAll(strains, i)
            {
                scalar& history = h.models[m][i];
                history = models_[m].advance
                (
                    history, {stresses[n][i], largest.deformation, strains[i]}, dt
                );
            }
            to[m] = damage(h, m).first();
        }
        addPassed(p, type.name(), from, to, said);
    }
    if (returnReduce(!said.empty(), orOp<bool>()))
    {
        atLimit(said);
    }
    if (time_.writeTime())
    {
        writeState();
    }
    return true;
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpDamage::header() const
{
    tableHeader result("Stress, deformation and damage of each clump");
    result
       .add("time", "s").add("clump").add("type").add("stress", "Pa")
       .add("stressPeak", "Pa").add("deformation").add("deformationPeak")
       .add("arealStrain").add("arealStrainPeak")
       .explain("time clump type", "number of the clump and name of its type")
       .explain("stress stressPeak", "of the fluid around the clump, largest over its"
            " spheres or nodes, now and so far")
       .explain("deformation deformationPeak", "(a1 - a2)/(a1 + a2) of the longest half axes"
            " of the ellipsoid with the same moments, now and so far")
       .explain("arealStrain arealStrainPeak", "of a membrane, largest over its nodes, now"
            " and so far; zero for spheres");
    forAll(names_, m)
    {
        result.add(names_[m]).add(names_[m] + "Max");
        result.explain
        (
            names_[m] + " " + names_[m] + "Max",
            "damage by the model " + models_[m].type() + ", mean and largest over the"
            " spheres or nodes"
        );
    }
    return result;
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpDamage::typeHeader() const
{
    tableHeader result("Damage of clumps by types");
    result
       .add("time", "s").add("type").add("clumps")
       .explain("time type clumps", "name of a type of clumps and number of them, with pieces"
            " of broken ones");
    forAll(names_, m)
    {
        result.add(names_[m]).add(names_[m] + "Max");
        result.explain
        (
            names_[m] + " " + names_[m] + "Max",
            "damage by the model " + models_[m].type() + ", mean over the clumps and"
            " largest over all of their spheres or nodes"
        );
    }
    return result;
}


bool Foam::functionObjects::clumpDamage::write()
{
    if (postProcess)
    {
        Info<< name() << ": the history of stress is known in the run only; no table is"
            << " written" << endl;
        return true;
    }
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);

    // Number, type of the whole, and the values of a row
    List<scalarList> rows(Pstream::nProcs());
    List<wordList> types(Pstream::nProcs());
    DynamicList<scalar> own;
    DynamicList<word> ownTypes;
    for (const clumpParcel& p : cloud)
    {
        const auto h = histories_.find(p.origId());
        const auto l = loads_.find(p.origId());
        if (h == histories_.end() || l == loads_.end())
        {
            continue;
        }
        ownTypes.append(cloud.type(p).name());
        own.append(p.origId());
        own.append(cloud.wholeType(p));
        own.append(l->second.stress);
        own.append(h->second.stress);
        own.append(l->second.deformation);
        own.append(h->second.deformation);
        own.append(l->second.arealStrain);
        own.append(h->second.arealStrain);
        forAll(models_, m)
        {
            const Tuple2<scalar, scalar> D(damage(h->second, m));
            own.append(D.first());
            own.append(D.second());
        }
    }
    rows[Pstream::myProcNo()].transfer(own);
    types[Pstream::myProcNo()].transfer(ownTypes);
    Pstream::gatherList(rows);
    Pstream::gatherList(types);
    if (!Pstream::master())
    {
        return true;
    }

    const label width = 8 + 2*models_.size();
    std::map<label, std::pair<word, SubList<scalar>>> clumps;
    forAll(rows, proci)
    {
        forAll(types[proci], k)
        {
            const SubList<scalar> row(rows[proci], width, k*width);
            clumps.emplace(label(row[0]), std::make_pair(types[proci][k], row));
        }
    }
    Ostream& os = table_.open(header());
    List<scalarList> ofTypes
    (
        cloud.nTypes(), scalarList(1 + 2*models_.size(), Zero)
    );
    for (const auto& clump : clumps)
    {
        const SubList<scalar>& row = clump.second.second;
        os  << time_.timeOutputValue() << '\t' << clump.first << '\t'
            << clump.second.first;
        for (label k = 2; k < width; ++k)
        {
            os  << '\t' << row[k];
        }
        os  << nl;
        scalarList& sums = ofTypes[label(row[1])];
        sums[0] += 1;
        forAll(models_, m)
        {
            sums[1 + 2*m] += row[8 + 2*m];
            sums[2 + 2*m] = max(sums[2 + 2*m], row[9 + 2*m]);
        }
    }
    table_.flush();

    Ostream& byTypes = typeTable_.open(typeHeader());
    for (const label type : types_.numbers(cloud))
    {
        const scalarList& sums = ofTypes[type];
        byTypes << time_.timeOutputValue() << '\t' << cloud.types()[type].name() << '\t'
            << sums[0];
        forAll(models_, m)
        {
            byTypes << '\t' << sums[1 + 2*m]/max(sums[0], scalar(1)) << '\t'
                << sums[2 + 2*m];
        }
        byTypes << nl;
    }
    typeTable_.flush();
    return true;
}
