/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "stepReport.H"
#include "fvcDiv.H"
#include "spokenTime.H"
#include "surfaceFields.H"

Foam::scalar Foam::stepReport::since(const clock::time_point& t)
{
    return std::chrono::duration<double>(clock::now() - t).count();
}


Foam::stepReport::stepReport
(
    const Time& runTime,
    const deformableCloud& cloud
)
:
    runTime_(runTime),
    cloud_(cloud),
    firstTime_(runTime.value()),
    start_(clock::now()),
    stepStart_(start_),
    continuityError_(0),
    cumulativeError_(0)
{}


void Foam::stepReport::beginStep()
{
    stepStart_ = clock::now();
    Info<< "Time = " << runTime_.timeName() << nl << endl;
}


void Foam::stepReport::continuity(const surfaceScalarField& phi)
{
    volScalarField error(fvc::div(phi));
    if (cloud_.coupled())
    {
        error -= cloud_.dilation();
    }
    const scalar dt = runTime_.deltaTValue();
    const DimensionedField<scalar, volMesh>& V = error.mesh().V();

    continuityError_ = dt*mag(error)().weightedAverage(V).value();
    const scalar global = dt*error.weightedAverage(V).value();
    cumulativeError_ += global;

    Info<< "time step continuity errors : sum local = " << continuityError_
        << ", global = " << global
        << ", cumulative = " << cumulativeError_ << endl;
}


void Foam::stepReport::endStep() const
{
    const scalar done = runTime_.value() - firstTime_;
    const scalar left = runTime_.endTime().value() - runTime_.value();

    Info<< "Step " << since(stepStart_) << " s, total "
        << spokenTime(since(start_)).c_str() << ", left "
        << spokenTime(max(left, scalar(0))/done*since(start_)).c_str()
        << ", " << cloud_.nClumps() << " clumps" << nl;
    runTime_.printExecutionTime(Info);
}


void Foam::stepReport::end() const
{
    cloud_.timing().print(Info, since(start_));
    Info<< "End" << nl << endl;
}
