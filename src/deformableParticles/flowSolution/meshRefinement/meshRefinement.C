/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "meshRefinement.H"
#include "deformableCloud.H"
#include "dynamicFvMesh.H"
#include "incompressibleFlow.H"

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
            cloud.meshChanged();
            flow.meshChanged();
        }
    }
}
