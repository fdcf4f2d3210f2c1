/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "freePlaces.H"
#include "coupledPolyPatch.H"
#include "faceTriangles.H"
#include "foamCompat.H"
#include "treeDataCell.H"

namespace
{

using namespace Foam;

//- Depth behind the inlet that counts as touching it, in radii
const scalar touching = 1e-6;

//- How often a candidate is moved off the inlet
const label maxMoves = 20;

boundBox boxOf(const UList<point>& x, const UList<scalar>& r, const scalar gap)
{
    boundBox box(boundBox::invertedBox);
    forAll(x, i)
    {
        box.add(x[i] - (r[i] + gap)*vector::one);
        box.add(x[i] + (r[i] + gap)*vector::one);
    }
    return box;
}

}


Foam::freePlaces::freePlaces
(
    const polyMesh& mesh,
    const ghostExchange& ghosts,
    const PtrList<clumpType>& types,
    const labelHashSet& inlets,
    const boundBox& region,
    const scalar gap
)
:
    mesh_(mesh),
    types_(types),
    shifts_(ghosts.shifts()),
    inlets_(inlets),
    region_(region),
    gap_(gap),
    nFitting_(0)
{}


Foam::List<Foam::point> Foam::freePlaces::corners(const bool atInlets) const
{
    DynamicList<point> result;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (isA<coupledPolyPatch>(pp) || inlets_.found(pp.index()) != atInlets)
        {
            continue;
        }
        for (const face& f : pp)
        {
            const boundBox box(f.points(mesh_.points()), false);
            for (const vector& shift : shifts_)
            {
                if (region_.overlaps(boundBox(box.min() - shift, box.max() - shift)))
                {
                    result.append(faceTriangles(f, mesh_.points()));
                    break;
                }
            }
        }
    }
    return List<point>(std::move(result));
}


void Foam::freePlaces::makeSurfaces() const
{
    if (!surface_.valid())
    {
        inletSurface_.reset(new wallSurface(corners(true)));
        surface_.reset(new wallSurface(corners(false)));
    }

    // Bounds of the processors' cell trees are built together
    mesh_.cellTree();
}


void Foam::freePlaces::clear()
{
    inletSurface_.clear();
    surface_.clear();
}


void Foam::freePlaces::test
(
    const clumpCandidate& c,
    const boundBox& mine,
    const Cloud<clumpParcel>& clumps,
    const UList<boundBox>& boxes,
    UList<scalar>& result
) const
{
    const scalarField& r = types_[c.typeId].radii();
    const pointField centres(c.centres());

    result = 0;
    if (mine.contains(c.position) && mesh_.findCell(c.position) >= 0)
    {
        result[owner] = 1.0/(1 + Pstream::myProcNo());
    }
    if (!region_.contains(c.position))
    {
        result[blocked] = 1;
    }

    for (const vector& shift : shifts_)
    {
        const pointField x(centres + shift);
        const boundBox box(boxOf(x, r, gap_));
        if (mine.overlaps(box))
        {
            forAll(x, i)
            {
                const scalar reach = r[i] + gap_;
                const scalar toInlet = inletSurface_->distance(x[i], r[i]);
                result[depth] = max(result[depth], r[i] - toInlet);
                if
                (
                    surface_->distance(x[i], reach)
                  < reach - touching*r[i]
                )
                {
                    result[blocked] = 1;
                }
                if (mine.contains(x[i]) && mesh_.findCell(x[i]) >= 0)
                {
                    result[inside + i] = 1;
                }
            }
        }

        label index = 0;
        for (const clumpParcel& p : clumps)
        {
            if (!result[blocked] && !result[conflicting] && box.overlaps(boxes[index]))
            {
                clumpCandidate other;
                other.typeId = p.typeId();
                other.position = p.position();
                other.state.x = p.state().x;
                if (overlap(other, c, types_, gap_, shift))
                {
                    result[conflicting] = 1;
                }
            }
            ++index;
        }
    }
}


Foam::labelList Foam::freePlaces::find
(
    UList<clumpCandidate>& candidates,
    const Cloud<clumpParcel>& clumps,
    const bool allWanted
) const
{
    makeSurfaces();

    const boundBox mine(mesh_.points(), false);
    List<boundBox> boxes(clumps.size());
    label index = 0;
    for (const clumpParcel& p : clumps)
    {
        boxes[index++] = boxOf(p.centres(), types_[p.typeId()].radii(), 0);
    }

    labelList starts(candidates.size() + 1, 0);
    forAll(candidates, k)
    {
        starts[k + 1] =
            starts[k] + inside + types_[candidates[k].typeId].size();
    }

    scalarField known(starts.last());
    bool moved = true;
    for (label moves = 0; moved && moves < maxMoves; ++moves)
    {
        forAll(candidates, k)
        {
            SubList<scalar> result(known, starts[k + 1] - starts[k], starts[k]);
            test(candidates[k], mine, clumps, boxes, result);
        }
        reduceList(known, maxEqOp<scalar>());

        moved = false;
        forAll(candidates, k)
        {
            clumpCandidate& c = candidates[k];
            const scalar d = known[starts[k] + depth];
            if (d > touching*min(types_[c.typeId].radii()))
            {
                known[starts[k] + blocked] = 1;
                c.position += d*c.inwards;
                moved = moved || mag(c.inwards) > 0;
            }
        }
    }

    nFitting_ = 0;
    labelList owners(candidates.size(), -1);
    forAll(candidates, k)
    {
        const SubList<scalar> result(known, starts[k + 1] - starts[k], starts[k]);
        bool isFree = result[owner] > 0 && !result[blocked];
        for (label i = inside; i < result.size(); ++i)
        {
            isFree = isFree && result[i] > 0;
        }
        nFitting_ += isFree;
        isFree = isFree && !result[conflicting];
        for (label other = 0; isFree && allWanted && other < k; ++other)
        {
            isFree =
                owners[other] < 0 || !conflict(candidates[other], candidates[k]);
        }
        if (isFree)
        {
            owners[k] = label(1/result[owner] + 0.5) - 1;
        }
    }
    return owners;
}


bool Foam::freePlaces::conflict
(
    const clumpCandidate& a,
    const clumpCandidate& b
) const
{
    for (const vector& shift : shifts_)
    {
        if (overlap(a, b, types_, gap_, shift))
        {
            return true;
        }
    }
    return false;
}
