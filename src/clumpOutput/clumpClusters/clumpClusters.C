/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpClusters.H"
#include "addToRunTimeSelectionTable.H"
#include "foamCompat.H"
#include "ghostExchange.H"
#include "ListOps.H"
#include "modelSelection.H"
#include "sphereGrid.H"
#include "surfaceDistance.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpClusters, 0);
    addToRunTimeSelectionTable(functionObject, clumpClusters, dictionary);
}
}


Foam::functionObjects::clumpClusters::clumpClusters
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    suspensionTable(name, runTime, dict, typeName, {"gap"}),
    gap_(0)
{
    read(dict);
}


bool Foam::functionObjects::clumpClusters::read(const dictionary& dict)
{
    const scalar V = gSum(mesh_.V().field());
    const label n = returnReduce(mesh_.nCells(), sumOp<label>());
    gap_ = getPositiveOrDefault(dict, "gap", 0.5*Foam::cbrt(V/n));
    return suspensionTable::read(dict);
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpClusters::header() const
{
    return
        tableHeader("Clusters of clumps that are nearer than " + Foam::name(gap_) + " m")
       .add("clumps").add("clusters").add("mean").add("weighted").add("largest")
       .add("n1").add("n2").add("n3to4").add("n5to8").add("n9")
       .explain("time clumps clusters", "number of clumps, and of clusters with the clumps"
            " that are alone")
       .explain("mean weighted largest", "size of a cluster: mean over the clusters, mean"
            " over the clumps, and largest")
       .explain("n1 n2 n3to4 n5to8 n9", "part of the clumps that are in clusters of 1, 2, 3"
            " to 4, 5 to 8, and 9 and more");
}


bool Foam::functionObjects::clumpClusters::near
(
    const clumpImage& A,
    const clumpImage& B
) const
{
    const clumpType& a = cloud().types()[A.typeId];
    const clumpType& b = cloud().types()[B.typeId];
    if (a.hasTriangles() && !b.hasTriangles())
    {
        return near(B, A);
    }
    const scalarField rA(a.hasTriangles() ? scalarField(A.x.size(), Zero) : a.radii());
    if (b.hasTriangles())
    {
        const surfaceDistance surface
        (
            b.surface(), B.x, B.transform.invertsHands()
        );
        const auto places = surface.nearest(A.x, max(rA) + gap_);
        forAll(places, i)
        {
            if (places[i].found && places[i].distance < rA[i] + gap_)
            {
                return true;
            }
        }
        return false;
    }
    forAll(A.x, i)
    {
        forAll(B.x, j)
        {
            if (magSqr(A.x[i] - B.x[j]) < sqr(rA[i] + b.radii()[j] + gap_))
            {
                return true;
            }
        }
    }
    return false;
}


Foam::DynamicList<Foam::Pair<Foam::labelPair>>
Foam::functionObjects::clumpClusters::neighbours() const
{
    const deformableCloud& clumps = cloud();
    const PtrList<clumpType>& types = clumps.types();
    ghostExchange ghosts(mesh_);
    UList<clumpImage>& own = ghosts.own(clumps.size());
    label a = 0;
    for (const clumpParcel& p : clumps)
    {
        clumpImage& image = own[a];
        image.set(p, types[p.typeId()], p.state(), a++);
        image.box = grown(image.box, 0.5*gap_);
        image.reach += 0.5*gap_;
    }
    ghosts.update();

    DynamicList<Pair<labelPair>> result;
    const UList<clumpImage>& images = ghosts.images();
    sphereGrid::forEachNear
    (
        images, ghosts.nOwn(), scalarList(ghosts.nOwn(), Zero),
        [&](const label first, const label second)
        {
            if (near(images[first], images[second]))
            {
                result.append(Pair<labelPair>(images[first].id, images[second].id));
            }
        }
    );
    return result;
}


Foam::labelList Foam::functionObjects::clumpClusters::sizes
(
    const UList<labelPair>& clumps,
    const UList<Pair<labelPair>>& neighbours
)
{
    HashTable<label, labelPair, labelPair::Hash<>> numbers;
    labelList cluster(identity(clumps.size()));
    forAll(clumps, i)
    {
        numbers.insert(clumps[i], i);
    }

    // A cluster has the number of its first clump
    const auto first = [&](label i)
    {
        while (cluster[i] != i)
        {
            i = cluster[i] = cluster[cluster[i]];
        }
        return i;
    };
    for (const Pair<labelPair>& pair : neighbours)
    {
        const label a = first(numbers[pair.first()]);
        const label b = first(numbers[pair.second()]);
        cluster[max(a, b)] = min(a, b);
    }
    labelList result(clumps.size(), Zero);
    forAll(clumps, i)
    {
        ++result[first(i)];
    }
    inplaceSubsetList(result, [](const label n) { return n > 0; });
    return result;
}


bool Foam::functionObjects::clumpClusters::write()
{
    List<List<labelPair>> clumps(Pstream::nProcs());
    List<List<Pair<labelPair>>> pairs(Pstream::nProcs());
    DynamicList<labelPair> own;
    for (const clumpParcel& p : cloud())
    {
        own.append(labelPair(p.origProc(), p.origId()));
    }
    clumps[Pstream::myProcNo()] = own;
    pairs[Pstream::myProcNo()] = neighbours();
    Pstream::gatherList(clumps);
    Pstream::gatherList(pairs);
    if (!Pstream::master())
    {
        return true;
    }

    const labelList found
    (
        sizes
        (
            ListListOps::combine<List<labelPair>>(clumps, accessOp<List<labelPair>>()),
            ListListOps::combine<List<Pair<labelPair>>>
            (
                pairs, accessOp<List<Pair<labelPair>>>()
            )
        )
    );
    const scalar n = sum(found);
    scalar squares = 0;
    label largest = 0;
    scalarList parts(5, Zero);
    for (const label size : found)
    {
        squares += sqr(scalar(size));
        largest = max(largest, size);
        label part = 0;
        for (const label least : {2, 3, 5, 9})
        {
            part += size >= least;
        }
        parts[part] += ratio(size, n);
    }
    scalarList row
    ({
        n, scalar(found.size()), ratio(n, found.size()), ratio(squares, n), scalar(largest)
    });
    row.append(parts);
    writeRow(row);
    return true;
}
