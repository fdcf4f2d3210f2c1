/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellGeometry.H"
#include "volFields.H"
#include "surfaceFields.H"

Foam::cellGeometry::cellGeometry(const fvMesh& mesh)
:
    mesh_(mesh)
{
    update();
}


void Foam::cellGeometry::update()
{
    const vectorField& centres = mesh_.cellCentres();

    width_ = Foam::cbrt(mesh_.V().field());
    reach_ = scalarField(mesh_.nCells(), Zero);

    const labelListList& cellPoints = mesh_.cellPoints();
    forAll(reach_, celli)
    {
        for (const label pointi : cellPoints[celli])
        {
            reach_[celli] = max
            (
                reach_[celli], mag(mesh_.points()[pointi] - centres[celli])
            );
        }
    }
    largestReach_ = reach_.empty() ? 0 : max(reach_);

    acrossBoundary_ = vectorField
    (
        mesh_.nFaces() - mesh_.nInternalFaces(), Zero
    );
    boundaryCoefficient_ = scalarField(acrossBoundary_.size(), Zero);
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (patch.coupled())
        {
            const label start = patch.start() - mesh_.nInternalFaces();
            SubList<vector>(acrossBoundary_, patch.size(), start) =
                patch.delta()();
            SubList<scalar>(boundaryCoefficient_, patch.size(), start) =
                mesh_.nonOrthDeltaCoeffs().boundaryField()[patch.index()];
        }
    }

    // Demand-driven, made by all processors together
    mesh_.tetBasePtIs();

    const treeBoundBox box(centres);
    const vector margin(1e-4*mag(box.span())*vector::one);
    tree_.reset
    (
        new indexedOctree<treeDataPoint>
        (
            treeDataPoint(centres),
            treeBoundBox(box.min() - margin, box.max() + margin),
            10,
            10,
            1
        )
    );
}


Foam::labelList Foam::cellGeometry::find
(
    const boundBox& box,
    const scalar nReaches
) const
{
    const vector margin(nReaches*largestReach_*vector::one);
    return tree_->findBox(treeBoundBox(box.min() - margin, box.max() + margin));
}


Foam::scalar Foam::cellGeometry::wallConductance
(
    const label celli,
    const scalar a,
    const std::function<scalar(const point&)>& distance
) const
{
    // Closer than this part of the line the wall is as good as in the centre
    constexpr scalar closest = 0.02;

    const point& x = mesh_.cellCentres()[celli];
    scalar result = 0;

    for (const label facei : mesh_.cells()[celli])
    {
        const label boundaryFacei = facei - mesh_.nInternalFaces();
        vector line;
        scalar coefficient;
        if (boundaryFacei < 0)
        {
            const label owner = mesh_.faceOwner()[facei];
            const label other =
                owner == celli ? mesh_.faceNeighbour()[facei] : owner;
            line = mesh_.cellCentres()[other] - x;
            coefficient = mesh_.nonOrthDeltaCoeffs()[facei];
        }
        else
        {
            line = acrossBoundary_[boundaryFacei];
            coefficient = boundaryCoefficient_[boundaryFacei];
        }

        // The surface is farther than the line is long
        if (magSqr(line) < sqr(a))
        {
            continue;
        }

        const scalar b = distance(x + line);
        if (b < 0)
        {
            const scalar t = max(a/(a - b), closest);
            result +=
                mag(mesh_.faceAreas()[facei])*coefficient/mesh_.V()[celli]
               *(1/t - 1);
        }
    }

    return result;
}
