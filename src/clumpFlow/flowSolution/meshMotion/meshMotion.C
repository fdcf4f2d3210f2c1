/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "meshMotion.H"
#include "clumpMotion.H"
#include "deformableCloud.H"
#include "dynamicMotionSolverFvMesh.H"
#include "dynamicRefineFvMesh.H"
#include "fvcMeshPhi.H"
#include "incompressibleFlow.H"
#include "points0MotionSolver.H"
#include "solidBodyMotionSolver.H"
#include "unsolvedPhysics.H"
#include "wallDisplacement.H"
#include "wallPolyPatch.H"

namespace
{

using namespace Foam;

//- Part of its radius by which a wall that moves may be pressed into a sphere
constexpr scalar deepest = 0.5;

//- fvMesh inherits several functions type()
const word& polyMeshType(const polyMesh& mesh)
{
    return mesh.type();
}

}


bool Foam::meshMotion::moves(const fvMesh& mesh)
{
    return mesh.dynamic() && !isA<dynamicRefineFvMesh>(mesh);
}


void Foam::meshMotion::start(dynamicFvMesh& mesh)
{
    if (!moves(mesh))
    {
        return;
    }
    const motionSolver* motion =
        isA<dynamicMotionSolverFvMesh>(mesh)
      ? &refCast<const dynamicMotionSolverFvMesh>(mesh).motion()
      : nullptr;
    if (!motion || !isA<solidBodyMotionSolver>(*motion))
    {
        unsolvedPhysics::refuseSplitPairs(mesh, "move");
    }
    const bool started = mesh.time().startTimeIndex() == 0;
    if (started && motion && isA<points0MotionSolver>(*motion))
    {
        mesh.update();
        mesh.moving(false);
    }
}


Foam::meshMotion::meshMotion
(
    dynamicFvMesh& mesh,
    deformableCloud& cloud,
    incompressibleFlow& flow
)
:
    mesh_(mesh),
    cloud_(cloud),
    flow_(flow),
    moves_(moves(mesh))
{
    if (moves_)
    {
        refuse();
        const string reason("the points of the mesh move");
        cloud.effects().require("refinement", false, reason);
        cloud.effects().decide("refinement", false, reason);
    }
}


void Foam::meshMotion::refuse() const
{
    const auto fatal = [&](const char* what, const char* remedy)
    {
        FatalErrorInFunction
            << "The points of the mesh move (" << polyMeshType(mesh_) << " in "
            << mesh_.time().constant()/"dynamicMeshDict" << "), but " << what << '.'
            << nl << "    " << remedy << exit(FatalError);
    };
    if (cloud_.hasFluid() && !flow_.solved())
    {
        fatal
        (
            "the flow is frozen",
            "Let the flow be solved (effects, fluid on), or remove dynamicMeshDict."
        );
    }
    if (cloud_.hasFluid() && !cloud_.coupled())
    {
        fatal
        (
            "the flow does not feel the clumps, whose drag knows no mesh that moves",
            "Let the flow feel them (effects, feedback on)."
        );
    }
}


void Foam::meshMotion::checkCells() const
{
    const scalar least = gMin(mesh_.V().field());
    if (least > 0)
    {
        return;
    }
    const scalarField& V = mesh_.V();
    label cell = findMin(V);
    const bool here = V.size() && V[cell] <= least;
    const point place
    (
        returnReduce
        (
            here ? mesh_.cellCentres()[cell] : point::max, minOp<point>()
        )
    );
    FatalErrorInFunction
        << "At time " << mesh_.time().timeName() << " the mesh collapses: its points"
        << " have moved through each other at " << place << ", where a mesh cell has the"
        << " volume " << least << " m3." << nl
        << "    A gap between walls that move cannot close: leave two mesh cells of"
        << " fluid in it, or let the motion end before (endTime)." << exit(FatalError);
}


void Foam::meshMotion::checkFluxes() const
{
    const volVectorField& U = flow_.U();
    const surfaceScalarField swept(fvc::meshPhi(U));
    scalar in = 0;
    scalar sum = 0;
    bool open = !flow_.p().needReference();
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        if (patch.coupled() || patch.type() == "empty")
        {
            continue;
        }
        const scalarField flux(patch.Sf() & Up);
        const scalarField& motion = swept.boundaryField()[patchi];
        // A wall that turns, or along which points slide, sweeps nothing but rounding
        const scalar speed = wayOfPoints(patch.patch())/mesh_.time().deltaTValue();
        const scalarField size
        (
            max(mag(motion), patch.magSf()*max(mag(Up), speed))
        );
        in += ::Foam::sum(size);
        sum += ::Foam::sum(flux);
        open = open || !Up.fixesValue() || Up.assignable();
        if (!isA<wallPolyPatch>(patch.patch()))
        {
            continue;
        }
        if (gMax(mag(flux - motion)()) > 1e-6*gMax(size))
        {
            FatalErrorInFunction
                << "The wall patch " << patch.name() << " moves, but U there ("
                << Up.type() << ") is not its velocity: fluid would flow through the wall."
                << nl << "    Set { type movingWallVelocity; value uniform (0 0 0); } for"
                << " this patch in U. (A wall in which points only slide along, such as"
                << " those beside a piston, may keep noSlip.)" << exit(FatalError);
        }
    }
    reduce(in, sumOp<scalar>());
    reduce(sum, sumOp<scalar>());
    if (!returnReduce(open, orOp<bool>()) && mag(sum) > 1e-6*in)
    {
        FatalErrorInFunction
            << "At time " << mesh_.time().timeName() << " the walls change the volume of"
            << " the domain by " << -sum*mesh_.time().deltaTValue() << " m3 in a step of "
            << mesh_.time().deltaTValue() << " s, but the fluid is incompressible and"
            << " has no way out or in." << nl
            << "    Fix the pressure at a patch (U pressureInletOutletVelocity), or let"
            << " the walls keep the volume." << exit(FatalError);
    }
}


Foam::scalar Foam::meshMotion::speedOverRadius() const
{
    if (!moves_ || !flow_.solved() || !cloud_.nClumps())
    {
        return 0;
    }
    scalar speed = 0;
    for (const fvPatchVectorField& Up : flow_.U().boundaryField())
    {
        if (isA<wallPolyPatch>(Up.patch().patch()) && Up.size())
        {
            speed = max(speed, max(mag(Up & Up.patch().nf())));
        }
    }
    scalar radius = GREAT;
    for (const clumpType& type : cloud_.types())
    {
        radius = min(radius, min(type.bodyRadii()));
    }
    return returnReduce(speed, maxOp<scalar>())/radius;
}


void Foam::meshMotion::beginStep()
{
    if (!moves_)
    {
        return;
    }
    const timeBreakdown::timer t(cloud_.timing(), "refinement");

    const pointField places(cloud_.places());
    const label step = mesh_.time().timeIndex();
    if (movedIn_ == step)
    {
        // The step is repeated, and volumes and fluxes are those since its beginning
        mesh_.movePoints(pointField(mesh_.oldPoints()));
    }
    movedIn_ = step;
    mesh_.update();
    if (mesh_.topoChanging())
    {
        FatalErrorInFunction
            << polyMeshType(mesh_) << " in "
            << mesh_.time().constant()/"dynamicMeshDict" << " has changed the topology"
            << " of the mesh at time " << mesh_.time().timeName() << '.' << nl
            << "    Points may move, or mesh cells be refined (clumpRefineFvMesh)."
            << exit(FatalError);
    }
    checkCells();
    cloud_.pointsMoved(places);
    if (flow_.solved())
    {
        flow_.pointsMoved();
        checkFluxes();
    }
}


void Foam::meshMotion::endStep()
{
    if (!moves_)
    {
        return;
    }
    const scalar overlap = cloud_.motion().overlaps().second();
    if (overlap > deepest)
    {
        FatalErrorInFunction
            << "At time " << mesh_.time().timeName() << " a wall is pressed into a clump"
            << " by " << overlap << " radii of its spheres: walls that move close on a"
            << " clump that cannot give way." << nl
            << "    End the motion before (endTime), leave the clump a way out, or give"
            << " a stiffer wallContactModel where the clump can be moved."
            << exit(FatalError);
    }
    if (flow_.solved())
    {
        flow_.keepFaceVelocity();
    }
}
