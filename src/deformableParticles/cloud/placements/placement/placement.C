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


Foam::scalarList Foam::placement::shares
(
    const dictionary& dict,
    const label nTypes,
    const HashTable<label>& typeIds
)
{
    scalarList result(nTypes, Zero);
    if (dict.found("clumpType") == dict.found("fractions"))
    {
        FatalIOErrorInFunction(dict)
            << "Give exactly one of the entries clumpType and fractions."
            << exit(FatalIOError);
    }
    if (dict.found("clumpType"))
    {
        result[typeId(dict, dict.get<word>("clumpType"), typeIds)] = 1;
        return result;
    }
    const dictionary& given = getDict(dict, "fractions");
    for (const word& name : given.toc())
    {
        result[typeId(given, name, typeIds)] = getBetween(given, name, 0, 1);
    }
    if (mag(sum(result) - 1) > 1e-6)
    {
        FatalIOErrorInFunction(given)
            << "The fractions add up to " << sum(result) << "; they must add up"
            << " to 1." << exit(FatalIOError);
    }
    return result;
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


Foam::Pair<Foam::scalar> Foam::placement::fractions
(
    const PtrList<clumpType>& types,
    const labelUList& numbers,
    const scalar volume
)
{
    Pair<scalar> result(0, 0);
    forAll(types, i)
    {
        if (!types[i].fixed())
        {
            result.first() += numbers[i]*types[i].nominalVolume()/volume;
            result.second() += numbers[i]*types[i].volume()/volume;
        }
    }
    return result;
}
