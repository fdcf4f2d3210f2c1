/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "coupledFluxes.H"
#include "fvMatrices.H"
#include "syncTools.H"

void Foam::equateCoupledFluxes(fvScalarMatrix& equation)
{
    const fvMesh& mesh = equation.psi().mesh();
    const label nInner = mesh.nInternalFaces();
    scalarField ownI(mesh.nFaces() - nInner, Zero);
    scalarField ownB(ownI);
    for (const fvPatch& patch : mesh.boundary())
    {
        if (patch.coupled())
        {
            const label start = patch.start() - nInner;
            SubField<scalar>(ownI, patch.size(), start) =
                equation.internalCoeffs()[patch.index()];
            SubField<scalar>(ownB, patch.size(), start) =
                equation.boundaryCoeffs()[patch.index()];
        }
    }
    scalarField otherI(ownI);
    scalarField otherB(ownB);
    syncTools::swapBoundaryFaceList(mesh, otherI);
    syncTools::swapBoundaryFaceList(mesh, otherB);
    for (const fvPatch& patch : mesh.boundary())
    {
        if (patch.coupled())
        {
            const label start = patch.start() - nInner;
            const label n = patch.size();
            equation.internalCoeffs()[patch.index()] =
                0.5
               *(
                    SubField<scalar>(ownI, n, start)
                  + SubField<scalar>(otherB, n, start)
                );
            equation.boundaryCoeffs()[patch.index()] =
                0.5
               *(
                    SubField<scalar>(ownB, n, start)
                  + SubField<scalar>(otherI, n, start)
                );
        }
    }
}
