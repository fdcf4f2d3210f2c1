/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Application
    clumpResistance

Description
    Measures the hydrodynamic resistance of a clump of a case of rbcIbFoam, with the mesh,
    the models and the pressure-velocity algorithm of the case, see
    resistanceMeasurement.

    Options
    \verbatim
        clumpResistance <n>     the clump with the number n
            -steps <n>          steps from rest, default 20
            -deltaT <dt>        time step [s], default that of the case
            -rotation           also of the angular velocities
    \endverbatim
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "dynamicFvMesh.H"
#include "fluidCoupling.H"
#include "incompressibleFlow.H"
#include "meshCheck.H"
#include "meshRefinement.H"
#include "obliqueFlux.H"
#include "rateViscosity.H"
#include "resistanceMeasurement.H"
#include "rotationalCorrection.H"
#include "runMonitor.H"
#include "sourcesInBodies.H"
#include "symmetricMomentum.H"

int main(int argc, char* argv[])
{
    argList::addNote("Hydrodynamic resistance matrix of a clump of a case");
    resistanceMeasurement::addOptions();

    #include "setRootCase.H"
    Info<< "Create time" << nl << endl;
    completeTime runTime(args);
    #include "createDynamicFvMesh.H"
    meshCheck::check(mesh);
    runTime.need("phi", "U");

    deformableCloud cloud(mesh);
    incompressibleFlow flow(mesh, cloud.hasFluid(), !cloud.effects().frozen(), false);
    flow.setFluids(cloud.fluids());
    #include "createFieldRefs.H"

    runMonitor monitor(runTime, cloud, flow, args);
    resistanceMeasurement resistance(runTime, cloud, flow, args);
    rateViscosity viscosity(cloud, flow);
    cloud.effects().decide("convection", false, "a resistance is linear");
    if (cloud.startWithFlow(U, nu))
    {
        phi = fvc::flux(U);
    }
    monitor.start();

    while (monitor.run())
    {
        resistance.beginStep();
        monitor.beginStep();
        refineAroundClumps(mesh, cloud, flow);
        cloud.immerse(nu, false, piso.nCorrPIMPLE() > 1);
        viscosity.begin();

        while (piso.loop())
        {
            viscosity.force();

            // The sources that do not depend on the velocity would act on a clump at rest, too
            tmp<fvVectorMatrix> sources(fvOptions(U));
            sourcesInBodies::remove
            (
                fvOptions, cloud.boundary().solidFraction(), sources.ref()
            );
            sources.ref().source() = Zero;

            fvVectorMatrix UEqn
            (
                flow.timeDerivative() + viscosity.stress() == sources
            );
            UEqn -= cloud.forcing(U);
            UEqn.lower();
            fvOptions.constrain(UEqn);
            if (piso.momentumPredictor())
            {
                flow.solveMomentum(UEqn);
            }

            while (piso.correct())
            {
                #include "pEqn.H"
            }
            viscosity.correct(true);
            turbulence.correct();
        }

        resistance.endStep();
        monitor.endStep();
    }
    monitor.end();

    return 0;
}
