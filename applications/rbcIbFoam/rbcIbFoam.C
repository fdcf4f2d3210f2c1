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
    fibres), resolved by the mesh: PISO with direct forcing in the solid
    fraction of the clumps.

    Controls in system/fvSolution, PISO: nOuterCorrectors (1: PISO),
    nCorrectors, nNonOrthogonalCorrectors, consistent, momentumPredictor,
    extrapolatePressure.
    With nu dt/dx^2 above about 10 set consistent yes.

    With constant/dynamicMeshDict the mesh refines around the clumps
    (dynamicRefineFvMesh on the field clumpCloseness, see immersedBoundary).

    Without a fluid (no constant/transportProperties) the clumps move alone; in a
    frozen one or where it does not feel them (clumpProperties, effects) they are
    dragged by it.

    rbcIbFoam -estimate runs a few steps and prints what the case will cost.
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "dynamicFvMesh.H"
#include "singlePhaseTransportModel.H"
#include "turbulentTransportModel.H"
#include "pimpleControl.H"
#include "fvOptions.H"
#include "deformableCloud.H"
#include "completeTime.H"
#include "costEstimate.H"
#include "pressureExtrapolation.H"
#include "rotationalCorrection.H"
#include "timeStepLimits.H"
#include "stepReport.H"
#include "watchdog.H"

int main(int argc, char* argv[])
{
    argList::addNote
    (
        "Incompressible flow with resolved deformable particles"
    );

    argList::addBoolOption
    (
        "estimate",
        "Run a few steps, print what the case will cost, write nothing"
    );

    #define CREATE_CONTROL createPressureControl.H
    #include "postProcess.H"
    #include "setRootCase.H"
    Info<< "Create time" << nl << endl;
    completeTime runTime(args);
    #include "createDynamicFvMesh.H"

    deformableCloud cells(mesh);
    sceneEffects& active = cells.effects();
    const accuracyPreset& accuracy = cells.accuracy();

    // Function objects run in here
    const auto goesOn = [&]()
    {
        const timeBreakdown::timer t(cells.timing(), "write");
        return runTime.run();
    };

    timeStepLimits(runTime.controlDict(), accuracy);

    if (!cells.hasFluid())
    {
        const auto evolve = [&]() { cells.evolve(); };
        #include "clumpLoop.H"
        return 0;
    }

    accuracy.complete(mesh);
    #include "createPressureControl.H"
    runTime.need("phi");
    #include "createFields.H"
    const auto& nu = mesh.lookupObject<volScalarField>("nu");
    if (active.frozen())
    {
        const auto evolve = [&]() { cells.evolve(U, p, nu); };
        #include "clumpLoop.H"
        return 0;
    }

    pressureExtrapolation extrapolation(p, piso.dict(), piso.nCorrPIMPLE());
    stepReport report(runTime, cells);
    watchdog guard(runTime, cells);
    costEstimate estimate(runTime, cells, args.found("estimate"));
    estimate.outerCorrectors(piso.nCorrPIMPLE());
    #include "decideConvection.H"
    active.print(Info);
    accuracy.print(Info, cells.mostSpheres(), cells.cellsPerDiameter());

    cells.startWithFlow(U, nu);
    Info<< "Starting time loop" << nl << endl;

    while (goesOn())
    {
        accuracy.complete(mesh);
        timeBreakdown::timer checks(cells.timing(), "checks");
        #include "flowNumbers.H"
        #include "decideConvection.H"
        const scalar viscousLimit =
            stepReport::viscousLimit(piso.consistent(), piso.nCorrPISO());
        #include "limitTimeStep.H"

        ++runTime;
        report.beginStep(CoNum, viscousNum);
        report.checkPressure(viscousNum, viscousLimit);
        checks.stop();

        if (active.active("refinement"))
        {
            #include "refineMesh.H"
        }

        extrapolation.beginStep();
        if (cells.coupled())
        {
            cells.immerse(nu);
        }

        while (piso.loop())
        {
            if (cells.coupled() && !piso.firstIter())
            {
                cells.iterate(U, p, nu);
            }

            const timeBreakdown::timer t(cells.timing(), "flow");

            #include "UEqn.H"

            while (piso.correct())
            {
                #include "pEqn.H"
            }

            laminarTransport.correct();
            turbulence->correct();
        }
        fvOptions.correct(U);
        extrapolation.endStep();

        cells.evolve(U, p, nu);
        {
            const timeBreakdown::timer t(cells.timing(), "checks");
            guard.check();
            guard.check(report.continuityError(), U, p, phi);
        }
        cells.moveParcels();

        #include "endStep.H"
    }
    #include "endRun.H"
    return 0;
}
