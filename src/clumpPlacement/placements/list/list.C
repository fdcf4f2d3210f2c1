/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "list.H"
#include "givenRotation.H"

namespace Foam
{
namespace clumpPlacements
{
    defineTypeNameAndDebug(list, 0);
    addToRunTimeSelectionTable(placement, list, dictionary);
}
}


Foam::clumpPlacements::list::list
(
    const dictionary& dict,
    const PtrList<clumpType>& types,
    const HashTable<label>& typeIds
)
:
    givenPlaces(dict, types, typeIds)
{
    checkEntries(dict, {"type", "clumps"});

    for (const dictionary& d : getDictList(dict, "clumps"))
    {
        checkEntries
        (
            d,
            {
                "type", "position", "axis", "angle", "velocity",
                "angularVelocity"
            }
        );
        const label typei = placement::typeId(d, getEntry<word>(d, "type"));
        const bool moves = d.found("velocity") || d.found("angularVelocity");
        if (types_[typei].hasTriangles() && moves)
        {
            FatalIOErrorInFunction(d)
                << "Entry 'type': " << types_[typei].name() << " is a membrane, which"
                << " has no inertia and starts with the velocity of the flow. Remove"
                << " the entries velocity and angularVelocity." << exit(FatalIOError);
        }
        places_.append
        (
            place
            {
                typei,
                getFinite<point>(d, "position"),
                givenRotation(d),
                getFiniteOrDefault<vector>(d, "velocity", Zero),
                getFiniteOrDefault<vector>(d, "angularVelocity", Zero),
                moves
            }
        );
    }
}


Foam::newClump Foam::clumpPlacements::list::clump(const label k) const
{
    const place& p = places_[k];
    const clumpType& type = types_[p.typeId];
    newClump result(type, p.typeId, p.position, p.turn);
    if (p.moves)
    {
        result.setVelocity(type, p.velocity, p.angularVelocity);
    }
    return result;
}
