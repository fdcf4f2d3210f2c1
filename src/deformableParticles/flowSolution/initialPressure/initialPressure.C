/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "initialPressure.H"
#include "fvMatrices.H"
#include "fvmLaplacian.H"
#include "volFields.H"

void Foam::setInitialPressure(volScalarField& p)
{
    const scalarField& values = p.primitiveField();
    if (p.needReference() || gMax(values) != gMin(values))
    {
        return;
    }

    dictionary solver(p.mesh().solverDict(p.name()));
    solver.set("tolerance", 1e-10);
    solver.set("relTol", 0);
    solver.set("maxIter", 10000);

    fvScalarMatrix start(fvm::laplacian(p));
    start.solve(solver);
}
