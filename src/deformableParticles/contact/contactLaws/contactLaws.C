/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactLaws.H"
#include "FlatOutput.H"
#include "wallPolyPatch.H"
#include "wordRes.H"

Foam::labelList Foam::contactLaws::typesOf
(
    const dictionary& dict,
    const wordList& names,
    const PtrList<clumpType>& types
)
{
    DynamicList<label> result;
    for (const word& name : names)
    {
        const label before = result.size();
        HashTable<label> valid;
        forAll(types, i)
        {
            valid.insert(types[i].family(), i);
            if (types[i].name() == name || types[i].family() == name)
            {
                result.append(i);
            }
        }
        if (result.size() == before)
        {
            FatalIOErrorInLookup(dict, "clumpType", name, valid)
                << exit(FatalIOError);
        }
    }
    return labelList(result);
}


Foam::labelList Foam::contactLaws::wallsOf
(
    const dictionary& dict,
    const polyBoundaryMesh& patches
)
{
    const wordRes given
    (
        dict.getOrDefault<wordRes>("patches", wordRes({wordRe(".*", wordRe::REGEX)}))
    );
    wordList walls;
    DynamicList<label> result;
    for (const polyPatch& patch : patches)
    {
        if (isA<wallPolyPatch>(patch))
        {
            walls.append(patch.name());
            if (given.match(patch.name()))
            {
                result.append(patch.index());
            }
        }
    }
    if (result.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'patches' is " << flatOutput(given)
            << ", which is no wall. Valid here: " << flatOutput(walls)
            << exit(FatalIOError);
    }
    return labelList(result);
}


Foam::dictionary Foam::contactLaws::merged
(
    const dictionary& dict,
    const dictionary& ofPair
)
{
    dictionary result(dict);
    result.remove("pairs");
    if (ofPair.found("type") && ofPair.get<word>("type") != dict.get<word>("type"))
    {
        result.clear();
    }
    if (ofPair.found("reducedModulus"))
    {
        result.remove("allowedOverlap");
        result.remove("stress");
    }
    if (ofPair.found("allowedOverlap") || ofPair.found("stress"))
    {
        result.remove("reducedModulus");
    }
    result.merge(ofPair);
    result.name() = ofPair.name();
    result.remove("types");
    result.remove("patches");
    return result;
}


void Foam::contactLaws::give
(
    const dictionary& dict,
    const label first,
    const label second
)
{
    label& law = lawOf_[first*nSecond_ + second];
    const label added = laws_.size() - 1;
    if (law > 0 && law != added)
    {
        FatalIOErrorInFunction(dict)
            << "Two entries of 'pairs' give the law of the same pair." << nl
            << "    The second one is " << dict.dictName() << exit(FatalIOError);
    }
    law = added;
}


Foam::contactLaws::contactLaws
(
    const dictionary& dict,
    const PtrList<clumpType>& types
)
:
    types_(types),
    withWalls_(false),
    lawOf_(types.size()*types.size(), Zero),
    nSecond_(types.size())
{
    laws_.append(selectModel<contactModel>(merged(dict, dictionary(dict.name()))));
    const dictionary pairs
    (
        dict.found("pairs") ? getDict(dict, "pairs") : dictionary()
    );
    for (const word& name : pairs.toc())
    {
        const dictionary& pair = getDict(pairs, name);
        const wordList names(getEntry<wordList>(pair, "types"));
        if (names.size() != 2 || pair.found("patches"))
        {
            FatalIOErrorInFunction(pair)
                << "A pair of contactModel needs the entry 'types' with two clump"
                << " types, and no patches; it has " << flatOutput(names)
                << ". Valid for clumps of one type among themselves: (a a)"
                << exit(FatalIOError);
        }
        laws_.append(selectModel<contactModel>(merged(dict, pair)));
        for (const label i : typesOf(pair, {names[0]}, types))
        {
            for (const label j : typesOf(pair, {names[1]}, types))
            {
                give(pair, i, j);
                give(pair, j, i);
            }
        }
    }
}


Foam::contactLaws::contactLaws
(
    const dictionary& dict,
    const PtrList<clumpType>& types,
    const polyBoundaryMesh& patches
)
:
    types_(types),
    withWalls_(true),
    lawOf_(types.size()*patches.size(), Zero),
    nSecond_(patches.size())
{
    laws_.append(selectModel<contactModel>(merged(dict, dictionary(dict.name()))));
    const dictionary pairs
    (
        dict.found("pairs") ? getDict(dict, "pairs") : dictionary()
    );
    for (const word& name : pairs.toc())
    {
        const dictionary& pair = getDict(pairs, name);
        if (!pair.found("patches") && !pair.found("types"))
        {
            FatalIOErrorInFunction(pair)
                << "A pair of wallContactModel needs an entry 'patches' or 'types',"
                << " or both." << exit(FatalIOError);
        }
        const labelList chosen
        (
            pair.found("types")
          ? typesOf(pair, getEntry<wordList>(pair, "types"), types)
          : identity(types.size())
        );
        laws_.append(selectModel<contactModel>(merged(dict, pair)));
        for (const label patchi : wallsOf(pair, patches))
        {
            for (const label i : chosen)
            {
                give(pair, i, patchi);
            }
        }
    }
}


bool Foam::contactLaws::active() const
{
    for (const contactModel& law : laws_)
    {
        if (law.active())
        {
            return true;
        }
    }
    return false;
}


bool Foam::contactLaws::frictional() const
{
    for (const contactModel& law : laws_)
    {
        if (law.frictional())
        {
            return true;
        }
    }
    return false;
}
