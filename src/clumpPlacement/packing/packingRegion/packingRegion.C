/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "packingRegion.H"
#include "coupledPolyPatch.H"
#include "checkedEntries.H"
#include "foamCompat.H"
#include "ListOps.H"
#include "plane.H"
#include "polyMeshTetDecomposition.H"
#include "syncTools.H"
#include "FlatOutput.H"

namespace
{

using namespace Foam;

//- Volume [m3] of a tetrahedron on the positive side of the planes from one on
scalar volumeWithin
(
    const FixedList<point, 4>& tet,
    const UList<plane>& planes,
    const label from = 0
)
{
    // The pieces of a tetrahedron that a plane cuts off
    struct pieces
    {
        DynamicList<FixedList<point, 4>> tets;

        void operator()(const tetPoints& t)
        {
            tets.append(FixedList<point, 4>{t[0], t[1], t[2], t[3]});
        }
    };

    if (from == planes.size())
    {
        return mag(tetPointRef(tet[0], tet[1], tet[2], tet[3]).mag());
    }
    const plane& cut = planes[from];
    label above = 0;
    for (const point& p : tet)
    {
        above += ((p - cut.origin()) & cut.normal()) >= 0;
    }
    if (!above)
    {
        return 0;
    }
    if (above == 4)
    {
        return volumeWithin(tet, planes, from + 1);
    }
    pieces in, out;
    tetPointRef(tet[0], tet[1], tet[2], tet[3]).sliceWithPlane(cut, in, out);
    scalar sum = 0;
    for (const auto& piece : in.tets)
    {
        sum += volumeWithin(piece, planes, from + 1);
    }
    return sum;
}

}


Foam::packingRegion::packingRegion
(
    const dictionary& dict,
    const polyMesh& mesh
)
:
    mesh_(mesh),
    box_(-GREAT*vector::one, GREAT*vector::one),
    volumes_(mesh.nCells()),
    volume_(0)
{
    readBox(dict);
    const boolList in(inZone(dict));
    findFaces(in);
    findVolumes(dict, in);
}


void Foam::packingRegion::readBox(const dictionary& dict)
{
    if (!dict.found("min") && !dict.found("max"))
    {
        return;
    }
    const boundBox given
    (
        getFinite<point>(dict, "min"), getFinite<point>(dict, "max")
    );
    if (cmptMin(given.span()) <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'max' is " << given.max() << "; it must be above min, "
            << given.min() << exit(FatalIOError);
    }
    const boundBox& whole = mesh_.bounds();
    const scalar small = 1e-6*whole.mag();
    boundBox allowed(whole);
    allowed.inflate(1e-6);
    if (!allowed.contains(given))
    {
        FatalIOErrorInFunction(dict)
            << "The box from 'min' " << given.min() << " to 'max' " << given.max()
            << " extends outside the mesh, which reaches from " << whole.min()
            << " to " << whole.max() << '.' << exit(FatalIOError);
    }
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (given.min()[d] > whole.min()[d] + small)
        {
            box_.min()[d] = given.min()[d];
        }
        if (given.max()[d] < whole.max()[d] - small)
        {
            box_.max()[d] = given.max()[d];
        }
    }
}


Foam::boolList Foam::packingRegion::inZone(const dictionary& dict) const
{
    if (!dict.found("cellZone"))
    {
        return boolList(mesh_.nCells(), true);
    }
    const word name(getEntry<word>(dict, "cellZone"));
    const label zonei = mesh_.cellZones().findZoneID(name);
    if (zonei < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'cellZone' is " << name << ", but the mesh has no such"
            << " zone. Valid names: " << flatOutput(mesh_.cellZones().names())
            << exit(FatalIOError);
    }
    boolList in;
    in.resize(mesh_.nCells(), false);
    for (const label celli : mesh_.cellZones()[zonei])
    {
        in[celli] = true;
    }
    return in;
}


void Foam::packingRegion::findFaces(const boolList& in)
{
    boolList other;
    syncTools::swapBoundaryCellList(mesh_, in, other);

    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();
    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        const face& f = mesh_.faces()[facei];
        if (in[owner[facei]] != in[neighbour[facei]])
        {
            faces_.append(in[owner[facei]] ? f : f.reverseFace());
        }
    }
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        forAll(pp, i)
        {
            const label facei = pp.start() + i;
            if
            (
                in[owner[facei]]
             && !(isA<coupledPolyPatch>(pp) && other[facei - mesh_.nInternalFaces()])
            )
            {
                faces_.append(pp[i]);
            }
        }
    }
}


Foam::scalar Foam::packingRegion::volumeInBox(const label celli) const
{
    const boundBox bounds
    (
        mesh_.cells()[celli].points(mesh_.faces(), mesh_.points()), false
    );
    DynamicList<plane> cuts;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        vector inwards(Zero);
        inwards[d] = 1;
        if (bounds.max()[d] <= box_.min()[d] || bounds.min()[d] >= box_.max()[d])
        {
            return 0;
        }
        if (bounds.min()[d] < box_.min()[d])
        {
            cuts.append(plane(box_.min()[d]*inwards, inwards));
        }
        if (bounds.max()[d] > box_.max()[d])
        {
            cuts.append(plane(box_.max()[d]*inwards, -inwards));
        }
    }
    if (cuts.empty())
    {
        return mesh_.cellVolumes()[celli];
    }
    scalar sum = 0;
    for (const tetIndices& t : polyMeshTetDecomposition::cellTetIndices(mesh_, celli))
    {
        const tetPointRef tet(t.tet(mesh_));
        sum += volumeWithin({tet.a(), tet.b(), tet.c(), tet.d()}, cuts);
    }
    return sum;
}


void Foam::packingRegion::findVolumes
(
    const dictionary& dict,
    const boolList& in
)
{
    scalar sum = 0;
    forAll(volumes_, celli)
    {
        sum += in[celli] ? volumeInBox(celli) : scalar(0);
        volumes_[celli] = sum;
    }

    volume_ = returnReduce(sum, sumOp<scalar>());
    if (volume_ <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "No part of the mesh lies in the box or the cellZone."
            << exit(FatalIOError);
    }
}


Foam::boundBox Foam::packingRegion::bounds() const
{
    const boundBox& whole = mesh_.bounds();
    return boundBox(max(whole.min(), box_.min()), min(whole.max(), box_.max()));
}


Foam::label Foam::packingRegion::cell(const point& p) const
{
    if (!box_.contains(p))
    {
        return -1;
    }
    const label celli = mesh_.findCell(p);
    const bool in =
        celli >= 0
     && volumes_[celli] > (celli ? volumes_[celli - 1] : scalar(0));
    return in ? celli : -1;
}


void Foam::packingRegion::update(const ghostExchange& ghosts)
{
    surface_.reset(new wallSurface(faces_, mesh_.points(), ghosts));
}
