/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "closedMomentum.H"
#include "clumpMotion.H"
#include "clumpTotals.H"
#include "surfaceFields.H"

namespace
{

using namespace Foam;

//- Whether every face of the boundary is a pair of a periodic or processor patch
bool allCoupled(const fvMesh& mesh)
{
    bool result = true;
    for (const fvPatch& patch : mesh.boundary())
    {
        result = result && (patch.coupled() || !patch.size());
    }
    return returnReduce(result, andOp<bool>());
}

bool hasSources(PtrList<fv::option>& options, const word& field)
{
    for (fv::option& option : options)
    {
        if (option.isActive() && option.applyToField(field) >= 0)
        {
            return true;
        }
    }
    return false;
}

}


Foam::closedMomentum::closedMomentum
(
    deformableCloud& cloud,
    incompressibleFlow& flow
)
:
    cloud_(cloud),
    flow_(flow),
    flowIsClosed_
    (
        flow.solved()
     && cloud.coupled()
     && allCoupled(flow.U().mesh())
     && !hasSources(flow.options(), flow.U().name())
    )
{}


void Foam::closedMomentum::correct()
{
    const scalar rho = cloud_.fluidDensity();
    if (flow_.densityRatio())
    {
        cloud_.motion().addInside(rho*flow_.excessInertia());
    }
    if (!flowIsClosed_ || someFixed(cloud_) || cloud_.motion().prescribed())
    {
        return;
    }
    volVectorField& U = flow_.U();
    const scalarField& V = U.mesh().V();
    const scalar dt = U.time().deltaTValue();

    const clumpMomentum& m = cloud_.motion().momentum();
    const vectorField change
    (
        U.mesh().moving()
      ? V*U.primitiveField() - U.mesh().V0()*U.oldTime().primitiveField()
      : V*(U.primitiveField() - U.oldTime().primitiveField())
    );
    vector excess(rho*sum(change)/dt + m.rate - m.displaced - m.applied);
    scalar mass = rho*sum(V) + excessMass(cloud_);
    if (flow_.densityRatio())
    {
        mass += rho*cloud_.fluids()->excessMass();
    }
    reduce(excess, sumOp<vector>());
    reduce(mass, sumOp<scalar>());

    const vector dU(-dt*excess/mass);
    U.primitiveFieldRef() += dU;
    U.correctBoundaryConditions();
    flow_.phi() += dimensionedVector("dU", dimVelocity, dU) & U.mesh().Sf();
    cloud_.motion().changeVelocities(dU);
}
