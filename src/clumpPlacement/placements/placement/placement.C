/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "placement.H"

namespace Foam
{
    defineTypeNameAndDebug(placement, 0);
    defineRunTimeSelectionTable(placement, dictionary);
}


Foam::placement::placement
(
    const dictionary& dict,
    const PtrList<clumpType>& types,
    const HashTable<label>& typeIds
)
:
    dict_(dict),
    types_(types),
    typeIds_(typeIds)
{}


Foam::label Foam::placement::typeId
(
    const dictionary& dict,
    const word& name
) const
{
    return typeId(dict, name, typeIds_);
}


Foam::label Foam::placement::typeId
(
    const dictionary& dict,
    const word& name,
    const HashTable<label>& typeIds
)
{
    if (!typeIds.found(name))
    {
        FatalIOErrorInLookup(dict, "clump", name, typeIds)
            << exit(FatalIOError);
    }
    return typeIds[name];
}


void Foam::placement::addFractions
(
    const dictionary& dict,
    const word& name,
    const scalar number,
    const PtrList<clumpType>& types,
    const HashTable<label>& typeIds,
    scalarList& fractions
)
{
    scalar ofFamily = 0;
    for (const clumpType& type : types)
    {
        ofFamily += type.family() == name ? type.share() : scalar(0);
    }
    if (typeIds.found(name) || ofFamily <= 0)
    {
        fractions[typeId(dict, name, typeIds)] += number;
        return;
    }
    forAll(types, i)
    {
        if (types[i].family() == name)
        {
            fractions[i] += number*types[i].share()/ofFamily;
        }
    }
}


Foam::scalarList Foam::placement::fractions
(
    const dictionary& dict,
    const PtrList<clumpType>& types,
    const HashTable<label>& typeIds
)
{
    scalarList result(types.size(), Zero);
    if (dict.found("clumpType") == dict.found("fractions"))
    {
        FatalIOErrorInFunction(dict)
            << "Give exactly one of the entries clumpType and fractions."
            << exit(FatalIOError);
    }
    if (dict.found("clumpType"))
    {
        addFractions
        (
            dict, getEntry<word>(dict, "clumpType"), 1, types, typeIds, result
        );
        return result;
    }
    const dictionary& given = getDict(dict, "fractions");
    for (const word& name : given.toc())
    {
        addFractions
        (
            given, name, getBetween(given, name, 0, 1), types, typeIds, result
        );
    }
    if (mag(sum(result) - 1) > 1e-6)
    {
        FatalIOErrorInFunction(given)
            << "The fractions add up to " << sum(result) << "; they must add up"
            << " to 1." << exit(FatalIOError);
    }
    return result;
}


Foam::label Foam::placement::typeAt(const scalarList& fractions, const scalar at)
{
    scalar upTo = 0;
    label last = 0;
    forAll(fractions, typei)
    {
        if (fractions[typei] > 0)
        {
            last = typei;
            upTo += fractions[typei];
            if (at < upTo)
            {
                break;
            }
        }
    }
    return last;
}


void Foam::placement::checkNumber
(
    const dictionary& dict,
    const word& entry,
    const scalar number
)
{
    if (!(number >= 1 && number <= 1e7))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << entry << "' requests " << number
            << " clumps; the number must be between 1 and 10 million."
            << exit(FatalIOError);
    }
}
