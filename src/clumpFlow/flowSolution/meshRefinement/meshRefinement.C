/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "meshRefinement.H"
#include "clumpRefineFvMesh.H"
#include "coupledPatches.H"
#include "deformableCloud.H"
#include "incompressibleFlow.H"
#include "unsolvedPhysics.H"

namespace
{

using namespace Foam;

//- Values beyond the coupled patches, of all fields of the mesh
template<class Type>
void updateCoupled(const fvMesh& mesh)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;
    const auto fields = const_cast<fvMesh&>(mesh).lookupClass<fieldType>();

    // In the same order on all processors
    for (const word& name : fields.sortedToc())
    {
        evaluateCoupled(fields[name]->boundaryFieldRef(false));
    }
}

}


void Foam::refineAroundClumps
(
    dynamicFvMesh& mesh,
    deformableCloud& cloud,
    incompressibleFlow& flow
)
{
    if (!cloud.effects().active("refinement"))
    {
        return;
    }
    const timeBreakdown::timer t(cloud.timing(), "refinement");

    const Time& time = mesh.time();
    const bool first = time.timeIndex() == time.startTimeIndex() + 1;
    if (first)
    {
        unsolvedPhysics::refuseSplitPairs(mesh, "be refined");
        if
        (
            Pstream::parRun() && isA<dynamicRefineFvMesh>(mesh)
         && !isA<clumpRefineFvMesh>(mesh)
        )
        {
            WarningInFunction
                << "The mesh cells that " << mesh.type() << " refines depend on the"
                << " decomposition." << nl << "    Set dynamicFvMesh "
                << clumpRefineFvMesh::typeName << " in "
                << time.constant()/"dynamicMeshDict" << '.' << endl;
        }
    }
    const bool started = time.startTimeIndex() == 0;
    bool changed = true;
    for (label pass = first && started ? 10 : 1; pass > 0 && changed; --pass)
    {
        cloud.prepareMeshChange();
        changed = mesh.update();
        if (mesh.moving())
        {
            unsolvedPhysics::refuseMotion(mesh);
        }
        if (changed)
        {
            updateCoupled<scalar>(mesh);
            updateCoupled<vector>(mesh);
            updateCoupled<symmTensor>(mesh);
            updateCoupled<tensor>(mesh);
            cloud.meshChanged();
            flow.meshChanged();
        }
    }
}
