/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpPairs.H"
#include "addToRunTimeSelectionTable.H"
#include "clumpMotion.H"
#include "ListListOps.H"
#include <algorithm>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpPairs, 0);
    addToRunTimeSelectionTable(functionObject, clumpPairs, dictionary);
}
}


Foam::functionObjects::clumpPairs::clumpPairs
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    suspensionTable(name, runTime, dict, typeName)
{
    read(dict);
}


bool Foam::functionObjects::clumpPairs::read(const dictionary& dict)
{
    const bool success = suspensionTable::read(dict);
    cloud().motion().keepPairs();
    return success;
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpPairs::header() const
{
    return
        tableHeader("What acts between clumps, and between clumps and walls")
       .add("first").add("second").add("area", "m2").add("bonds").add("contact", "N")
       .add("attraction", "N").add("film", "N").add("bond", "N").add("tangential", "N")
       .explain("time first second", "numbers of two clumps; second is -1 for walls")
       .explain("area", "area of contact, pi R* d of spheres that overlap by d")
       .explain("bonds", "number of bonds")
       .explain("contact attraction film bond", "force on the first clump along the line"
            " from the second one, or along the normal of the walls, of contact, of"
            " surfaceForces without bonds, of the film, and of bonds")
       .explain("tangential", "force of friction and bonds across this line");
}


bool Foam::functionObjects::clumpPairs::write()
{
    List<List<pairForces>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = cloud().motion().pairs();
    Pstream::gatherList(all);
    if (!Pstream::master())
    {
        return true;
    }
    List<pairForces> pairs
    (
        ListListOps::combine<List<pairForces>>(all, accessOp<List<pairForces>>())
    );
    std::sort
    (
        pairs.begin(), pairs.end(),
        [](const pairForces& a, const pairForces& b)
        {
            return a.first != b.first ? a.first < b.first : a.second < b.second;
        }
    );
    for (const pairForces& p : pairs)
    {
        const vector& n = p.direction;
        const vector rubbing(p.contact + p.bonds);
        writeRow
        ({
            scalar(p.first), scalar(p.second), p.area, scalar(p.nBonds), p.contact & n,
            p.attraction & n, p.film & n, p.bonds & n, mag(rubbing - (rubbing & n)*n)
        });
    }
    return true;
}
