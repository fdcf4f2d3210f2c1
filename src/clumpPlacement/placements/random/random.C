/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "random.H"
#include "clumpPacking.H"
#include "clumpTotals.H"
#include "foamCompat.H"
#include "ghostExchange.H"
#include "givenRotation.H"
#include "randomSeed.H"
#include "treeDataCell.H"
#include "uniformRotation.H"
#include <cmath>

namespace Foam
{
namespace clumpPlacements
{
    defineTypeNameAndDebug(random, 0);
    addToRunTimeSelectionTable(placement, random, dictionary);
}
}


namespace
{

using namespace Foam;

//- Fatal unless exactly one of some entries is there
void wantOne(const dictionary& dict, const wordList& entries)
{
    label n = 0;
    for (const word& entry : entries)
    {
        n += dict.found(entry);
    }
    if (n != 1)
    {
        FatalIOErrorInFunction(dict)
            << "Give exactly one of the entries " << flatOutput(entries)
            << "; there are " << n << '.' << exit(FatalIOError);
    }
}

}


Foam::clumpPlacements::random::random
(
    const dictionary& dict,
    const PtrList<clumpType>& types,
    const HashTable<label>& typeIds
)
:
    placement(dict, types, typeIds)
{
    checkEntries
    (
        dict,
        {
            "type", "clumpType", "fractions", "numbers", "haematocrit",
            "volumeFraction", "seed", "minGap", "maxOverlap", "axis", "angle",
            "min", "max", "cellZone"
        }
    );
    wantOne(dict, {"clumpType", "fractions", "numbers"});
    wantOne(dict, {"haematocrit", "volumeFraction", "numbers"});
}


Foam::scalarList Foam::clumpPlacements::random::readFractions() const
{
    if (!dict_.found("numbers"))
    {
        return fractions(dict_, types_, typeIds_);
    }
    scalarList result(types_.size(), Zero);
    const dictionary& given = getDict(dict_, "numbers");
    for (const word& name : given.toc())
    {
        addFractions
        (
            given, name, getNumber(given, name, 1, 10000000), types_, typeIds_,
            result
        );
    }
    return result;
}


Foam::labelList Foam::clumpPlacements::random::numbers
(
    const scalar volume
) const
{
    const scalarList fractions(readFractions());
    labelList result(fractions.size());
    scalar total = sum(fractions);

    word entry("numbers");
    if (!dict_.found(entry))
    {
        const bool nominal = dict_.found("haematocrit");
        entry = nominal ? "haematocrit" : "volumeFraction";
        scalar mean = 0;
        forAll(fractions, i)
        {
            mean += fractions[i]
               *(nominal ? types_[i].nominalVolume() : types_[i].volume());
        }
        total = std::round(getBetween(dict_, entry, 0, 1)*volume/mean);
    }
    checkNumber(dict_, entry, total);

    // Rounded so that the sum is the total
    scalar upTo = 0;
    label before = 0;
    forAll(fractions, i)
    {
        upTo += fractions[i]/sum(fractions)*total;
        result[i] = label(std::round(upTo)) - before;
        before += result[i];
    }
    return result;
}


void Foam::clumpPlacements::random::scatter
(
    const packingRegion& region,
    const labelUList& numbers,
    Cloud<clumpParcel>& clumps
) const
{
    const bool turned = dict_.found("axis") || dict_.found("angle");
    const quaternion turn(givenRotation(dict_));

    // All processors draw the same points, whatever the mesh is like, and those in the
    // region count. One of the processors has the place
    const boundBox box(region.bounds());
    region.mesh().cellTree();
    Random common(getEntry<label>(dict_, "seed"));
    List<Random> own(sum(numbers), Random(0));
    labelList typeIds(own.size());
    label k = 0;
    forAll(numbers, typei)
    {
        for (label n = 0; n < numbers[typei]; ++n, ++k)
        {
            own[k] = Random(randomSeed(common));
            typeIds[k] = typei;
        }
    }

    labelList wanted(identity(own.size()));
    while (wanted.size())
    {
        pointField points(wanted.size());
        labelList cells(wanted.size());
        labelList owners(wanted.size());
        forAll(wanted, i)
        {
            Random& numbersOf = own[wanted[i]];
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                points[i][d] =
                    box.min()[d] + numbersOf.sample01<scalar>()*box.span()[d];
            }
            cells[i] = region.cell(points[i]);
            owners[i] = cells[i] < 0 ? -1 : Pstream::myProcNo();
        }
        reduceList(owners, maxEqOp<label>());

        DynamicList<label> others;
        forAll(wanted, i)
        {
            k = wanted[i];
            if (owners[i] < 0)
            {
                others.append(k);
            }
            else if (owners[i] == Pstream::myProcNo())
            {
                newClump
                (
                    types_[typeIds[k]], typeIds[k], points[i],
                    turned ? turn : uniformRotation(own[k])
                ).enter(clumps, cells[i], k);
            }
        }
        wanted = others;
    }
}


void Foam::clumpPlacements::random::place
(
    const polyMesh& mesh,
    Cloud<clumpParcel>& clumps,
    labelHashSet& followFlow
) const
{
    packingRegion region(dict_, mesh);
    const labelList wanted(numbers(region.volume()));
    ghostExchange::checkPatches(mesh.boundaryMesh());
    scatter(region, wanted, clumps);

    Info<< "Packing " << sum(wanted) << " clumps" << endl;
    const scalar maxOverlap =
        getNonNegativeOrDefault(dict_, "maxOverlap", 0);
    clumpPacking packing
    (
        region, types_, clumps,
        getNonNegativeOrDefault(dict_, "minGap", 0),
        !dict_.found("axis")
    );
    scalar deepest = 0;
    const scalar reached = packing.pack(maxOverlap, deepest);
    if (reached < 1)
    {
        const scalar fraction =
            volumeFractions(types_, wanted, region.volume()).second();
        FatalIOErrorInFunction(dict_)
            << "The clumps do not fit: " << sum(wanted) << " clumps, a volume"
            << " fraction of " << fraction << ", could only be packed at "
            << 100*reached << " % of their size. This corresponds to a volume"
            << " fraction of " << pow3(reached)*fraction << '.' << nl
            << "    Place fewer clumps, reduce minGap, allow a maxOverlap (the"
            << " deepest is " << deepest << ")," << nl
            << "    or try another seed."
            << exit(FatalIOError);
    }
    for (const clumpParcel& p : clumps)
    {
        followFlow.insert(p.origId());
    }
    Info<< "Packed in " << packing.nSteps() << " steps, deepest overlap "
        << 100*deepest << " % of a sphere radius" << endl;
}
