/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Application
    rbcIbFoam

Group
    grpIncompressibleSolvers

Description
    Incompressible flow with deformable particles (red blood cells, capsules,
    fibres), resolved by the mesh: PISO with direct forcing in the mesh cells
    that the clumps cover or cut.

    Controls: system/fvSolution, PISO (see incompressibleFlow); the time step in
    system/controlDict (see timeStepControl); everything of the clumps in
    constant/clumpProperties (see deformableCloud).

    With constant/dynamicMeshDict the mesh refines around the clumps
    (clumpRefineFvMesh on the field clumpCloseness, see immersedBoundary), or its
    points and walls move (dynamicMotionSolverFvMesh and others, see meshMotion).

    Without a fluid (no constant/transportProperties) the clumps move alone. With a
    frozen flow, or with feedback off (clumpProperties, effects), the flow drags
    them.

    Options
    \verbatim
        -estimate       runs a few steps and prints what the case will cost
        -quiet          prints warnings and lines of progress instead of each step
    \endverbatim
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "clumpMotion.H"
#include "dynamicFvMesh.H"
#include "closedMomentum.H"
#include "clumpTotals.H"
#include "convectionCriterion.H"
#include "couplingIteration.H"
#include "fluidCoupling.H"
#include "heldMeanVelocity.H"
#include "incompressibleFlow.H"
#include "meshCheck.H"
#include "meshMotion.H"
#include "meshRefinement.H"
#include "obliqueFlux.H"
#include "rateViscosity.H"
#include "rotationalCorrection.H"
#include "runMonitor.H"
#include "slidingMesh.H"
#include "sourcesInBodies.H"
#include "symmetricMomentum.H"
#include "timeStepControl.H"

int main(int argc, char* argv[])
{
    argList::addNote("Incompressible flow with resolved deformable particles");
    runMonitor::addOptions();

    #define NO_CONTROL
    #include "postProcess.H"
    #include "setRootCase.H"
    Info<< "deformableParticles " << DEFORMABLE_PARTICLES_VERSION << nl << nl
        << "Create time" << nl << endl;
    completeTime runTime(args);
    #include "createDynamicFvMesh.H"
    meshMotion::start(mesh);
    meshCheck::check(mesh);
    runTime.need("phi", "U");
    #include "createFields.H"
    #include "createFieldRefs.H"
    #include "createControls.H"
    monitor.start();

    while (monitor.run())
    {
        #include "setTimeStep.H"

        do
        {
            monitor.beginStep();
            motion.beginStep();

            if (flow.solved())
            {
                #include "solveFlow.H"
            }

            // --- Clumps
            if (flow.solved())
            {
                fvOptions.correct(U);
            }
            if (cloud.hasFluid())
            {
                cloud.evolve(U, p, nu);
            }
            else
            {
                cloud.evolve();
            }
        }
        while (monitor.repeats(coupling));

        cloud.accept();
        momentum.correct();
        monitor.check();
        if (flow.solved())
        {
            coupling.endStep();
            monitor.check(U, p, phi);
        }
        motion.endStep();
        cloud.moveParcels();

        monitor.write();
        monitor.endStep();
    }
    coupling.end();
    monitor.end();

    return 0;
}
