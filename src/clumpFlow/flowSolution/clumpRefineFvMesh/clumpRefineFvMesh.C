/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpRefineFvMesh.H"
#include "addToRunTimeSelectionTable.H"
#include "syncTools.H"

namespace Foam
{
    defineTypeNameAndDebug(clumpRefineFvMesh, 0);
    addToRunTimeSelectionTable(dynamicFvMesh, clumpRefineFvMesh, IOobject);
}


void Foam::clumpRefineFvMesh::selectRefineCandidates
(
    const scalar lowerRefineLevel,
    const scalar upperRefineLevel,
    const scalarField& values,
    bitSet& candidateCell
) const
{
    scalarField averages(nPoints(), Zero);
    scalarField counts(nPoints(), Zero);
    forAll(pointCells(), pointi)
    {
        for (const label celli : pointCells()[pointi])
        {
            averages[pointi] += values[celli];
            counts[pointi] += 1;
        }
    }
    syncTools::syncPointList
    (
        *this, averages, plusEqOp<scalar>(), scalar(0)
    );
    syncTools::syncPointList(*this, counts, plusEqOp<scalar>(), scalar(0));
    averages /= counts;

    const scalarField errors
    (
        maxPointField(error(averages, lowerRefineLevel, upperRefineLevel))
    );
    forAll(errors, celli)
    {
        if (errors[celli] > 0)
        {
            candidateCell.set(celli);
        }
    }
}
