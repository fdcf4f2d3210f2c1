/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "typeSelection.H"
#include "checkedEntries.H"

Foam::functionObjects::typeSelection::typeSelection
(
    const dictionary& dict,
    const fvMesh& mesh,
    const word& cloudName
)
:
    names_(dict.getOrDefault<wordList>("types", wordList()))
{
    if (dict.found("types") && names_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'types' is empty. Name at least one type of clumps, or leave the"
            << " entry out for all of them." << exit(FatalIOError);
    }
    const auto* cloud = mesh.findObject<deformableCloud>(cloudName);
    if (!cloud)
    {
        return;
    }
    HashTable<label> valid(cloud->typeIds());
    for (label i = 0; i < cloud->nTypes(); ++i)
    {
        valid.insert(cloud->types()[i].family(), i);
    }
    for (const word& name : names_)
    {
        if (!valid.found(name))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'types': there is no type of clumps with the name " << name
                << ". Valid: " << flatOutput(valid.sortedToc()) << exit(FatalIOError);
        }
    }
}


Foam::labelList Foam::functionObjects::typeSelection::numbers
(
    const clumpSuspension& clumps
) const
{
    DynamicList<label> result;
    for (label i = 0; i < clumps.nTypes(); ++i)
    {
        if (holds(clumps.types()[i]))
        {
            result.append(i);
        }
    }
    return labelList(result);
}
