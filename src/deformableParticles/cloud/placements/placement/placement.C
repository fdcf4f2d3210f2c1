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
    if (!typeIds_.found(name))
    {
        FatalIOErrorInLookup(dict, "clump type", name, typeIds_)
            << exit(FatalIOError);
    }
    return typeIds_[name];
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
