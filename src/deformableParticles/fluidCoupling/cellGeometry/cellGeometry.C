/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellGeometry.H"
#include "volFields.H"
#include "surfaceFields.H"
#include "symmetryPlanes.H"
#include "wallPolyPatch.H"

Foam::cellGeometry::cellGeometry(const fvMesh& mesh)
:
    mesh_(mesh),
    largestReach_(0)
{
    update();
}


void Foam::cellGeometry::update()
{
    setCells();
    setLines();
    grid_.update(mesh_.cellCentres());

    // Demand-driven, made by all processors together
    mesh_.tetBasePtIs();
}


void Foam::cellGeometry::setCells()
{
    const labelListList& cellPoints = mesh_.cellPoints();
    const scalarField& volumes = mesh_.V();

    cells_.setSize(mesh_.nCells() + 1);
    largestReach_ = 0;
    label line = 0;
    forAll(volumes, celli)
    {
        cell& c = cells_[celli];
        c.x = mesh_.cellCentres()[celli];
        c.volume = volumes[celli];
        c.width = Foam::cbrt(c.volume);
        c.reach = 0;
        for (const label pointi : cellPoints[celli])
        {
            c.reach = max(c.reach, mag(mesh_.points()[pointi] - c.x));
        }
        largestReach_ = max(largestReach_, c.reach);
        c.firstLine = line;
        c.atWall = false;
        line += mesh_.cells()[celli].size();
    }
    cells_.last().firstLine = line;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<wallPolyPatch>(patch))
        {
            for (const label celli : patch.faceCells())
            {
                cells_[celli].atWall = true;
            }
        }
    }
    lines_.setSize(line);
}


void Foam::cellGeometry::setLines()
{
    const label nInternal = mesh_.nInternalFaces();

    acrossBoundary_ = vectorField(mesh_.nFaces() - nInternal, Zero);
    scalarField boundaryCoefficient(acrossBoundary_.size(), Zero);
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (patch.coupled())
        {
            const label start = patch.start() - nInternal;
            SubList<vector>(acrossBoundary_, patch.size(), start) =
                patch.delta()();
            SubList<scalar>(boundaryCoefficient, patch.size(), start) =
                mesh_.nonOrthDeltaCoeffs().boundaryField()[patch.index()];
        }
        else if (symmetryPlanes::isOne(patch.patch()))
        {
            // To the mirror image of the cell
            const vectorField n(patch.nf());
            forAll(n, i)
            {
                const point& x = mesh_.cellCentres()[patch.faceCells()[i]];
                const scalar d = 2*(n[i] & (patch.Cf()[i] - x));
                acrossBoundary_[patch.start() - nInternal + i] = d*n[i];
                boundaryCoefficient[patch.start() - nInternal + i] = 1/d;
            }
        }
    }

    forAll(mesh_.cells(), celli)
    {
        cell& c = cells_[celli];
        c.longestLine = 0;
        label k = c.firstLine;
        for (const label facei : mesh_.cells()[celli])
        {
            lineAcross& l = lines_[k++];
            const label boundaryFacei = facei - nInternal;
            scalar coefficient;
            if (boundaryFacei < 0)
            {
                const label owner = mesh_.faceOwner()[facei];
                l.to = owner == celli ? mesh_.faceNeighbour()[facei] : owner;
                coefficient = mesh_.nonOrthDeltaCoeffs()[facei];
            }
            else
            {
                l.to = -1 - boundaryFacei;
                coefficient = boundaryCoefficient[boundaryFacei];
            }
            l.conductance =
                mag(mesh_.faceAreas()[facei])*coefficient/c.volume;
            c.longestLine = max(c.longestLine, mag(along(c, l)));
        }
    }
}


const Foam::UList<Foam::label>& Foam::cellGeometry::find
(
    const boundBox& box,
    const scalar nReaches
) const
{
    const vector margin(nReaches*largestReach_*vector::one);
    grid_.find(boundBox(box.min() - margin, box.max() + margin), found_);
    return found_;
}
