/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "meshRefinement.H"
#include "deformableCloud.H"
#include "dynamicFvMesh.H"
#include "incompressibleFlow.H"

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
        auto& patches = fields[name]->boundaryFieldRef(false);
        const label startOfRequests = Pstream::nRequests();
        for (auto& patch : patches)
        {
            if (patch.coupled())
            {
                patch.initEvaluate(Pstream::commsTypes::nonBlocking);
            }
        }
        Pstream::waitRequests(startOfRequests);
        for (auto& patch : patches)
        {
            if (patch.coupled())
            {
                patch.evaluate(Pstream::commsTypes::nonBlocking);
            }
        }
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
    bool changed = true;
    for (label pass = first ? 10 : 1; pass > 0 && changed; --pass)
    {
        cloud.prepareMeshChange();
        changed = mesh.update();
        if (mesh.moving())
        {
            FatalErrorInFunction
                << "The points of the mesh move: " << mesh.type() << " in "
                << time.constant()/"dynamicMeshDict" << '.' << nl
                << "    Clumps can be used with meshes that are refined"
                << " (dynamicRefineFvMesh) or do not change." << exit(FatalError);
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
