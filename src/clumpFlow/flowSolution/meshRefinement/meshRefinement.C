/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "meshRefinement.H"
#include "clumpRefineFvMesh.H"
#include "coupledPatches.H"
#include "deformableCloud.H"
#include "foamCompat.H"
#include "incompressibleFlow.H"
#include "processorCyclicPolyPatch.H"
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


//- Fatal where the two halves of a cyclic pair are on different processors, since
//  OpenFOAM cannot match their refined faces
void refuseSplitPairs(const fvMesh& mesh)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    labelList split(patches.nNonProcessor(), 0);
    for (const polyPatch& pp : patches)
    {
        if (isA<processorCyclicPolyPatch>(pp))
        {
            const cyclicPolyPatch& half = refCast<const cyclicPolyPatch>
            (
                refCast<const processorCyclicPolyPatch>(pp).referPatch()
            );
            split[half.index()] = 1;
            split[half.neighbPatchID()] = 1;
        }
    }
    reduceList(split, maxEqOp<label>());

    string names;
    forAll(split, patchi)
    {
        if (split[patchi])
        {
            names += (names.empty() ? "" : " ") + patches[patchi].name();
        }
    }
    if (!names.empty())
    {
        FatalErrorInFunction
            << "The mesh cannot be refined, since faces of the cyclic patches "
            << names.c_str() << " and their counterparts are on different"
            << " processors." << nl
            << "    Decompose the case with this entry in system/decomposeParDict:"
            << nl
            << "    constraints { pairs { type preservePatches; patches ("
            << names.c_str() << "); } }" << exit(FatalError);
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
        refuseSplitPairs(mesh);
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
