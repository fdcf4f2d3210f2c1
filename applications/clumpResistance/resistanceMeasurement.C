/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "resistanceMeasurement.H"
#include "incompressibleFlow.H"
#include "OFstream.H"
#include "readableDuration.H"

void Foam::resistanceMeasurement::addOptions()
{
    argList::addArgument("clump", "The number of the clump");
    argList::addOption
    (
        "steps", "number", "Steps from rest (20)"
    );
    argList::addOption
    (
        "deltaT", "time", "Time step [s] (of the case)"
    );
    argList::addBoolOption
    (
        "rotation", "The spheres' angular velocities, too"
    );
}


Foam::resistanceMeasurement::resistanceMeasurement
(
    completeTime& runTime,
    deformableCloud& cloud,
    incompressibleFlow& flow,
    const argList& args
)
:
    runTime_(runTime),
    cloud_(cloud),
    flow_(flow),
    steps_(args.getOrDefault<label>("steps", 20)),
    done_(0)
{
    if (!cloud.coupled())
    {
        FatalErrorInFunction
            << "The case has no flow that feels the clumps, and no resistance."
            << exit(FatalError);
    }
    if (steps_ < 1)
    {
        FatalErrorInFunction
            << "Option -steps is " << steps_ << "; it must be 1 or above."
            << exit(FatalError);
    }
    matrix_.reset
    (
        new resistanceMatrix
        (
            cloud, args.get<label>(1), args.found("rotation")
        )
    );

    runTime.functionObjects().off();
    runTime.writeNothing();
    runTime.setDeltaT
    (
        args.getOrDefault<scalar>("deltaT", runTime.deltaTValue()), false
    );
    runTime.setEndTime
    (
        runTime.value() + (matrix_->size() + 1)*steps_*runTime.deltaTValue()
    );
    Info<< "Clump " << args.get<label>(1) << ": "
        << matrix_->size() << " columns, " << steps_ << " steps of "
        << runTime.deltaTValue() << " s" << nl << endl;
}


void Foam::resistanceMeasurement::beginStep()
{
    if (done_ % steps_ == 0)
    {
        matrix_->setVelocity(column());
        flow_.reset();
    }
}


void Foam::resistanceMeasurement::endStep()
{
    ++done_;
    if (done_ % steps_)
    {
        return;
    }
    const volScalarField& nu = flow_.nu();
    cloud_.gatherForces(flow_.U(), flow_.p(), nu);

    // The column that these steps were
    const label ended = column() - 1;
    matrix_->store(ended);
    const label nLeft = matrix_->size() - 1 - ended;
    Info<< "Resistance: " << ended + 2 << " of " << matrix_->size() + 1
        << " flows computed, "
        << readableDuration(nLeft*clock_.elapsedTime()/(ended + 2)).c_str() << " left"
        << endl;

    if (ended == matrix_->size() - 1)
    {
        const scalar largest = gMax(nu.primitiveField());
        if (gMin(nu.primitiveField()) < 0.99*largest)
        {
            WarningInFunction
                << "The viscosity is not uniform: it depends on the motions of the"
                << " measurement, which are not those of the case." << endl;
        }
        matrix_->print(Info, cloud_.fluidDensity()*largest);
        if (Pstream::master())
        {
            OFstream file(runTime_.globalPath()/"resistance.csv");
            matrix_->write(file);
        }
    }
}
