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

    dictionary solver;
    solver.add("solver", word("PCG"));
    solver.add("preconditioner", word("DIC"));
    solver.add("tolerance", 1e-12);
    solver.add("relTol", 0);
    solver.add("maxIter", 10000);

    fvScalarMatrix start(fvm::laplacian(p));
    start.solve(solver);
}
