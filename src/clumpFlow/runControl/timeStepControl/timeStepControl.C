/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "timeStepControl.H"
#include "checkedEntries.H"
#include "fvcSurfaceIntegrate.H"
#include "pimpleControl.H"
#include "surfaceFields.H"
#include "volFields.H"

void Foam::timeStepControl::read()
{
    const dictionary& dict = runTime_.controlDict();

    getPositive(dict, "deltaT");
    adjusts_ = dict.getOrDefault("adjustTimeStep", false);
    maxCo_ = getPositiveOrDefault(dict, "maxCo", 1);
    maxDisplacement_ = getPositiveOrDefault(dict, "maxDisplacement", 0.25);
    maxDeltaT_ = getPositiveOrDefault(dict, "maxDeltaT", GREAT);
    maxViscousNumber_ = getPositiveOrDefault(dict, "maxViscousNumber", GREAT);
}


void Foam::timeStepControl::checkPressure()
{
    if (warned_)
    {
        return;
    }
    if (viscousNumber_ > 1e5)
    {
        warned_ = true;
        WarningInFunction
            << "The viscous number nu dt/dx^2 is " << viscousNumber_
            << ": in a step, momentum diffuses over "
            << label(Foam::sqrt(viscousNumber_)) << " mesh cells. Check nu in"
            << " constant/transportProperties, in m2/s (water: 1e-6), the scale of"
            << " the mesh, and deltaT." << endl;
    }
    else if (viscousNumber_ > viscousLimit_)
    {
        warned_ = true;
        WarningInFunction
            << "The viscous number nu dt/dx^2 = " << viscousNumber_
            << " is above " << viscousLimit_ << ", where PISO diverges. Set"
            << " 'consistent yes' in system/fvSolution, PISO, or divide the"
            << " time step by " << viscousNumber_/viscousLimit_ << '.' << endl;
    }
}


Foam::timeStepControl::timeStepControl(Time& runTime)
:
    runTime_(runTime),
    CourantNumber_(0),
    viscousNumber_(0),
    viscousLimit_(GREAT),
    warned_(false)
{
    // Other entries are those of OpenFOAM and of other solvers
    refuseMisspelt
    (
        runTime_.controlDict(),
        {
            "deltaT", "adjustTimeStep", "maxCo", "maxDisplacement", "maxDeltaT",
            "maxViscousNumber", "accuracyLevel", "watchdog", "functions", "libs",
            "startFrom", "startTime", "stopAt", "endTime", "writeControl",
            "writeInterval", "purgeWrite", "writeFormat", "writePrecision",
            "writeCompression", "timeFormat", "timePrecision", "runTimeModifiable",
            "checkMesh"
        }
    );
    read();

    // A continued run may end within half a step
    const scalar left = runTime_.endTime().value() - runTime_.value();
    if
    (
        runTime_.startTimeIndex() == 0 && left > 0
     && runTime_.deltaTValue() > 2*left
    )
    {
        FatalIOErrorInFunction(runTime_.controlDict())
            << "Entry 'deltaT' is " << runTime_.deltaTValue() << " s, but the whole"
            << " run takes " << left << " s, to the endTime "
            << runTime_.endTime().value() << ": there is no step to compute."
            << " Reduce deltaT." << exit(FatalIOError);
    }
}


Foam::scalar Foam::timeStepControl::viscousLimit
(
    const bool consistent,
    const label nCorrectors
)
{
    return consistent ? GREAT : nCorrectors < 4 ? 12 : 37;
}


void Foam::timeStepControl::measure
(
    const surfaceScalarField& phi,
    const volScalarField& nu,
    const pimpleControl& control
)
{
    const scalar dt = runTime_.deltaTValue();
    const scalarField& V = phi.mesh().V();
    const scalarField flux(fvc::surfaceSum(mag(phi))().primitiveField());

    measure
    (
        0.5*dt*gMax(flux/V),
        dt*gMax(nu.primitiveField())/sqr(Foam::cbrt(gMin(V))),
        viscousLimit(control.consistent(), control.nCorrPISO())
    );
    Info<< "Courant Number mean: " << 0.5*dt*gSum(flux)/gSum(V)
        << " max: " << CourantNumber_ << nl
        << "Viscous Number max: " << viscousNumber_ << endl;
}


void Foam::timeStepControl::measure
(
    const scalar CourantNumber,
    const scalar viscousNumber,
    const scalar viscousLimit
)
{
    CourantNumber_ = CourantNumber;
    viscousNumber_ = viscousNumber;
    viscousLimit_ = viscousLimit;
    checkPressure();
}


void Foam::timeStepControl::adjust
(
    const scalar displacementRate,
    const scalar shortening,
    const scalar releaseStep
)
{
    read();
    if (adjusts_)
    {
        const scalar dt = runTime_.deltaTValue();

        scalar used = dt*displacementRate/maxDisplacement_;
        used = max(used, CourantNumber_/maxCo_);
        used = max(used, viscousNumber_/min(viscousLimit_, maxViscousNumber_));
        used = max(used, dt/releaseStep);
        used = max(used, shortening);
        used = max(used, SMALL);

        runTime_.setDeltaT
        (
            min
            (
                dt*min(min(1/used, 1 + 0.1/used), scalar(1.2)),
                maxDeltaT_
            )
        );
    }
    Info<< "deltaT = " << runTime_.deltaTValue() << endl;
}
