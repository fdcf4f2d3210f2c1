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
        places_.append
        (
            place
            {
                placement::typeId(d, d.get<word>("type")),
                getFinite<point>(d, "position"),
                givenRotation(d),
                getFiniteOrDefault<vector>(d, "velocity", Zero),
                getFiniteOrDefault<vector>(d, "angularVelocity", Zero),
                !d.found("velocity") && !d.found("angularVelocity")
            }
        );
    }
}


Foam::clumpState Foam::clumpPlacements::list::state(const label k) const
{
    const place& p = places_[k];
    clumpState s(types_[p.typeId], p.turn);
    s.setRigidMotion(types_[p.typeId], p.velocity, p.angularVelocity);
    return s;
}
