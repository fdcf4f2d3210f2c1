/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "writtenTypes.H"
#include "FlatOutput.H"
#include "HashSet.H"
#include "Time.H"

namespace
{

using namespace Foam;

//- A list of an entry. In a file of the format binary it is text, as all entries of a
//  dictionary are, but dictionary::get would read raw bytes
template<class Type>
List<Type> stored(const dictionary& dict, const word& key)
{
    ITstream& is = dict.lookup(key);
    is.format(IOstream::ASCII);
    return List<Type>(is);
}

}


Foam::IOobject Foam::writtenTypes::file
(
    const word& cloudName,
    const Time& time
)
{
    return IOobject
    (
        cloudName + "Types", time.timeName(), "uniform", time,
        IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
    );
}


Foam::writtenTypes::writtenTypes
(
    const word& cloudName,
    const Time& time,
    const PtrList<clumpType>& types,
    const dictionary& properties
)
:
    properties_(properties),
    types_(types),
    file_(file(cloudName, time)),
    names_(file_.toc()),
    pieces_(names_.size(), -1),
    mayChange_(properties.getOrDefault("typesMayChange", false))
{
    if (names_.empty())
    {
        Info<< "The types of the clumps of time " << time.timeName()
            << " are not checked: there is no "
            << file_.instance()/file_.local()/file_.name() << endl;
    }
}


void Foam::writtenTypes::write
(
    const word& cloudName,
    const Time& time,
    const PtrList<clumpType>& types
)
{
    IOobject io(file(cloudName, time));
    io.readOpt() = IOobject::NO_READ;
    IOdictionary result(io);
    for (const clumpType& type : types)
    {
        dictionary& d = result.subDictOrAdd(type.name());
        setExact(d, "radii", flatOutput(type.radii()));
        setExact(d, "centres", flatOutput(type.centres()));
        setExact(d, "bonds", flatOutput(type.pairs()));
        if (type.isPiece())
        {
            labelList spheres(type.size());
            forAll(spheres, i)
            {
                spheres[i] = type.numberInWhole(i);
            }
            d.set("pieceOf", types[type.whole(-1)].name());
            setExact(d, "spheres", flatOutput(spheres));
        }
    }
    if (!result.regIOobject::write())
    {
        FatalErrorInFunction
            << "cannot write " << result.objectPath() << exit(FatalError);
    }
}


void Foam::writtenTypes::addPieces
(
    const std::function<label(const label, const labelList&)>& add
)
{
    forAll(names_, k)
    {
        const dictionary& d = getDict(file_, names_[k]);
        if (!d.found("pieceOf"))
        {
            continue;
        }
        const label written = names_.find(d.get<word>("pieceOf"));
        const labelList spheres(stored<label>(d, "spheres"));
        const label whole = written < 0 ? -1 : find(written);
        bool good = whole >= 0 && spheres.size();
        forAll(spheres, i)
        {
            good =
                good && spheres[i] > (i ? spheres[i - 1] : -1)
             && spheres[i] < types_[whole].size();
        }
        if (!good)
        {
            FatalIOErrorInFunction(d)
                << "Type " << names_[k] << " is that of pieces of clumps of the type "
                << d.get<word>("pieceOf") << " with the spheres " << flatOutput(spheres)
                << ". The entry 'types' of constant/clumpProperties has no such clumps"
                << " any more." << exit(FatalIOError);
        }
        pieces_[k] = add(whole, spheres);
    }
}


Foam::label Foam::writtenTypes::find(const label written) const
{
    if (pieces_[written] >= 0)
    {
        return pieces_[written];
    }
    forAll(types_, i)
    {
        if (types_[i].name() == names_[written])
        {
            return i;
        }
    }
    const bool renamed =
        mayChange_ && written < types_.size()
     && !names_.found(types_[written].name());
    return renamed ? written : -1;
}


Foam::string Foam::writtenTypes::change(const clumpType& type) const
{
    const dictionary& d = getDict(file_, type.name());
    const List<scalar> radii(stored<scalar>(d, "radii"));
    const List<point> centres(stored<point>(d, "centres"));
    const List<labelPair> bonds(stored<labelPair>(d, "bonds"));

    OStringStream os;
    if (radii.size() != type.size() || centres.size() != type.size())
    {
        os  << "it had " << radii.size() << " spheres then and has " << type.size()
            << " now";
        return os.str();
    }
    forAll(radii, i)
    {
        if (mag(radii[i] - type.radii()[i]) > 1e-4*radii[i])
        {
            os  << "the radius of sphere " << i << " was " << radii[i]
                << " m then and is " << type.radii()[i] << " m now";
            return os.str();
        }
        if (mag(centres[i] - type.centres()[i]) > 1e-4*type.reach())
        {
            os  << "the centre of sphere " << i << " lay at " << centres[i]
                << " m at rest then and lies at " << type.centres()[i]
                << " m now";
            return os.str();
        }
    }
    if (bonds != type.pairs())
    {
        os << "its bonds join other spheres now";
    }
    return os.str();
}


Foam::labelList Foam::writtenTypes::present(const labelUList& written) const
{
    if (names_.empty())
    {
        return labelList(written);
    }

    const dictionary& entry = getDict(properties_, "types");
    labelList result(written.size(), -1);
    labelList known(names_.size(), -1);
    forAll(written, k)
    {
        const label i = written[k];
        if (i < 0 || i >= names_.size())
        {
            FatalErrorInFunction
                << "typeId: a clump has the type " << i << "; the types are 0 to "
                << names_.size() - 1 << " in " << file_.objectPath()
                << exit(FatalError);
        }
        if (known[i] < 0)
        {
            known[i] = find(i);
            if (known[i] < 0)
            {
                FatalIOErrorInFunction(entry)
                    << "Clumps of time " << file_.instance() << " have the type "
                    << names_[i] << ", which is not among the entries of 'types'"
                    << " any more: " << flatOutput(entry.toc()) << '.' << nl
                    << "If it only has another name now, set 'typesMayChange"
                    << " yes' in constant/clumpProperties."
                    << exit(FatalIOError);
            }
            const clumpType& type = types_[known[i]];
            const string changed
            (
                mayChange_ ? string() : change(type)
            );
            if (changed.size())
            {
                FatalIOErrorInFunction
                (
                    getDict(entry, types_[type.whole(known[i])].name())
                )
                    << "Entry '" << type.name() << "': the type has changed since"
                    << " time " << file_.instance() << " was written: "
                    << changed.c_str() << '.' << nl
                    << "The clumps have their former shape. Restore the entry,"
                    << " place the clumps anew (setClumps), or, if they shall"
                    << " take the new shape" << nl
                    << "from here on, set 'typesMayChange yes' in"
                    << " constant/clumpProperties." << exit(FatalIOError);
            }
        }
        result[k] = known[i];
    }
    return result;
}
