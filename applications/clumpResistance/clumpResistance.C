/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Application
    clumpResistance

Description
    The hydrodynamic resistance of a clump as the mesh, the models and the
    pressure-velocity algorithm of a case make it.

    Every velocity component of every sphere is set to one in turn, the others to
    zero, and the flow solved from rest; the forces on all spheres are a column of
    \verbatim
        f = -R u
    \endverbatim
    What the case itself drives (walls, inlets, fvOptions) is solved once and
    subtracted. R should be symmetric (imposed velocity and distributed force are
    an adjoint pair); its largest eigenvalue bounds the exchange between fluid and
    clump, which is stable when zeta exceeds half of it, and zeta over the
    smallest is the lag in steps.

    With the time step of the case (option -deltaT to change it) and one step the
    answer is what the exchange meets; with many steps it is the steady
    resistance. The matrix goes to clumpResistance.csv in the case, in units of
    6 pi mu r of the first sphere.

    Usage
    \verbatim
        clumpResistance [-clump 0] [-steps 20] [-deltaT dt] [-rotation]
    \endverbatim
    -rotation adds the spheres' angular velocities, scaled by the radius.
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "singlePhaseTransportModel.H"
#include "turbulentTransportModel.H"
#include "pimpleControl.H"
#include "fvOptions.H"
#include "deformableCloud.H"
#include "stepReport.H"
#include "resistanceMatrix.H"
#include "rotationalCorrection.H"
#include "OFstream.H"

int main(int argc, char* argv[])
{
    argList::addNote("Discrete hydrodynamic resistance of a clump");
    argList::addOption("clump", "number", "Number of the clump (0)");
    argList::addOption("steps", "number", "Steps from rest (20)");
    argList::addOption("deltaT", "time", "Time step [s] (of the case)");
    argList::addBoolOption("rotation", "Include the spheres' angular velocities");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    deformableCloud cells(mesh);
    sceneEffects& active = cells.effects();
    const accuracyPreset& accuracy = cells.accuracy();
    if (!cells.coupled())
    {
        FatalErrorInFunction
            << "The case has no fluid that feels the clumps" << exit(FatalError);
    }

    accuracy.complete(mesh);
    #include "createPressureControl.H"
    #include "createFields.H"
    const auto& nu = mesh.lookupObject<volScalarField>("nu");
    stepReport report(runTime, cells);

    const label clump = args.getOrDefault<label>("clump", 0);
    const label steps = args.getOrDefault<label>("steps", 20);
    runTime.setDeltaT
    (
        args.getOrDefault<scalar>("deltaT", runTime.deltaTValue()), false
    );
    active.decide("convection", false, "a resistance is linear");

    resistanceMatrix R(cells, clump, args.found("rotation"));
    const label verbosity = messageStream::level;

    Info<< "Clump " << clump << ": " << R.size() << " columns, " << steps
        << " steps of " << runTime.deltaTValue() << " s" << endl;

    for (label column = -1; column < R.size(); ++column)
    {
        R.setVelocity(column);

        U.primitiveFieldRef() = Zero;
        U.correctBoundaryConditions();
        U.oldTime() == U;
        p = dimensionedScalar(p.dimensions(), Zero);
        phi = fvc::flux(U);
        phi.oldTime() == phi;

        messageStream::level = 0;
        for (label step = 0; step < steps; ++step)
        {
            ++runTime;
            cells.immerse(nu);
            while (piso.loop())
            {
                #include "UEqn.H"
                while (piso.correct())
                {
                    #include "pEqn.H"
                }
            }
        }
        messageStream::level = verbosity;

        cells.gatherForces(U, p, nu);
        R.store(column);
        Info<< '.' << flush;
    }
    Info<< nl << nl;

    R.print(Info, cells.fluidDensity()*gMax(nu.primitiveField()));
    if (Pstream::master())
    {
        OFstream file(runTime.globalPath()/"clumpResistance.csv");
        R.write(file);
    }

    Info<< "End" << nl << endl;
    return 0;
}
