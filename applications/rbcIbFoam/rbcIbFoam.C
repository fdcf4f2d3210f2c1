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

    Without a fluid (no constant/transportProperties) the clumps move alone.

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
    effects& active = cells.activeEffects();
    timeStepLimits(runTime.controlDict());

    if (!cells.wet())
    {
        #include "dryLoop.H"
        return 0;
    }

    #include "createPressureControl.H"
    runTime.need("phi");
    #include "createFields.H"
    const auto& nu = mesh.lookupObject<volScalarField>("nu");

    pressureExtrapolation extrapolation(p, piso.dict(), piso.nCorrPIMPLE());
    stepReport report(runTime, cells);
    watchdog guard(runTime, cells);
    costEstimate estimate(runTime, cells, args.found("estimate"));
    if (estimate.wanted())
    {
        runTime.functionObjects().off();
        runTime.writeNothing();
    }
    #include "decideConvection.H"
    active.printTable(Info);

    Info<< "Starting time loop" << nl << endl;

    while (runTime.run())
    {
        #include "flowNumbers.H"
        #include "decideConvection.H"
        const scalar viscousLimit =
            stepReport::viscousLimit(piso.consistent(), piso.nCorrPISO());
        #include "limitTimeStep.H"

        ++runTime;
        report.beginStep(CoNum, viscousNum);
        report.checkPressure(viscousNum, viscousLimit);

        if (mesh.dynamic())
        {
            #include "refineMesh.H"
        }

        extrapolation.beginStep();
        cells.immerse(nu, p.needReference());

        while (piso.loop())
        {
            if (!piso.firstIter())
            {
                cells.iterate(U, p, nu);
            }

            const effects::timer t(active, "flow");

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
        guard.check(report.continuityError());
        cells.moveParcels();

        if (estimate.wanted())
        {
            estimate.add(report.stepSeconds(), active.seconds("clumps"));
            if (estimate.done())
            {
                break;
            }
            continue;
        }
        {
            const effects::timer t(active, "write");
            runTime.write();
        }
        report.endStep();
    }

    if (estimate.wanted())
    {
        estimate.print(mesh.globalData().nTotalCells(), piso.nCorrPIMPLE());
        return 0;
    }

    report.end();
    return 0;
}
