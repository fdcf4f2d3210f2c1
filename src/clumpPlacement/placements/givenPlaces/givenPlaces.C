/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "givenPlaces.H"
#include "foamCompat.H"
#include "treeDataCell.H"

void Foam::givenPlaces::place
(
    const polyMesh& mesh,
    Cloud<clumpParcel>& clumps,
    labelHashSet& followFlow
) const
{
    // Bounds of the processors' cell trees are built together
    mesh.cellTree();
    const boundBox mine(mesh.points(), false);

    // On a boundary between processors the first one takes the clump
    labelList owners(size(), labelMax);
    DynamicList<labelPair> here;
    forAll(owners, k)
    {
        const point x(position(k));
        const label celli = mine.contains(x) ? mesh.findCell(x) : -1;
        if (celli >= 0)
        {
            owners[k] = Pstream::myProcNo();
            here.append(labelPair(k, celli));
        }
    }
    reduceList(owners, minEqOp<label>());

    const label outside = owners.find(labelMax);
    if (outside >= 0)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'position': clump " << outside << " of type "
            << types_[clump(outside).typeId].name() << " at " << position(outside)
            << " lies outside the mesh." << exit(FatalIOError);
    }

    for (const labelPair& at : here)
    {
        const label k = at.first();
        if (owners[k] == Pstream::myProcNo())
        {
            const newClump c(clump(k));
            c.enter(clumps, at.second(), k);
            if (c.followsFlow)
            {
                followFlow.insert(k);
            }
        }
    }
}
