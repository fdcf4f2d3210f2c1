/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "stepReport.H"
#include "clumpMotion.H"
#include "clumpWork.H"
#include "fvcDiv.H"
#include "logBuffer.H"
#include "readableDuration.H"
#include "surfaceFields.H"

Foam::scalar Foam::stepReport::since(const clock::time_point& t)
{
    return std::chrono::duration<double>(clock::now() - t).count();
}


Foam::stepReport::stepReport
(
    const Time& runTime,
    const deformableCloud& cloud,
    const bool quiet
)
:
    runTime_(runTime),
    cloud_(cloud),
    firstTime_(runTime.value()),
    start_(clock::now()),
    stepStart_(start_),
    continuityError_(0),
    cumulativeError_(0),
    nSteps_(0),
    end_(runTime.endTime().value()),
    quiet_(quiet),
    said_(start_),
    saidPart_(0)
{}


Foam::scalar Foam::stepReport::part() const
{
    const scalar total = end_ - firstTime_;
    const scalar done = runTime_.value() - firstTime_;
    return done < total ? done/total : 1;
}


Foam::string Foam::stepReport::left() const
{
    return readableDuration((1/part() - 1)*since(start_));
}


void Foam::stepReport::printOverlaps() const
{
    const sceneEffects& effects = cloud_.effects();
    if (effects.active("contact") || effects.active("walls"))
    {
        const Pair<scalar> overlaps(cloud_.motion().overlaps());
        Info<< "Overlap max: clumps " << 100*overlaps.first() << " %, walls "
            << 100*overlaps.second() << " % of the radius" << nl;
    }
}


void Foam::stepReport::printProgress()
{
    const label percent(100*part());
    const bool last =
        runTime_.value()
      > min(end_, runTime_.endTime().value()) - 0.5*runTime_.deltaTValue();
    if (last || (percent > saidPart_ && since(said_) > 2))
    {
        logBuffer::quieten(false);
        Info<< "Time " << runTime_.timeName() << " of "
            << Time::timeName(end_) << ", " << percent << " %, "
            << readableDuration(since(start_)).c_str() << ", left " << left().c_str()
            << ", " << cloud_.nClumps() << " clumps" << endl;
        logBuffer::quieten(true);
        said_ = clock::now();
        saidPart_ = percent;
    }
}


void Foam::stepReport::start() const
{
    logBuffer::quieten(quiet_);
}


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


void Foam::stepReport::endStep()
{
    ++nSteps_;
    if (runTime_.stopAt() == Time::saEndTime)
    {
        end_ = runTime_.endTime().value();
    }
    printOverlaps();
    Info<< "Step " << since(stepStart_) << " s, total "
        << readableDuration(since(start_)).c_str() << ", left " << left().c_str()
        << ", " << cloud_.nClumps() << " clumps" << nl;
    runTime_.printExecutionTime(Info);

    if (quiet_)
    {
        printProgress();
    }
}


void Foam::stepReport::explainIdle() const
{
    if (runTime_.value() < runTime_.endTime().value() - ROOTVSMALL)
    {
        Info<< "Nothing to compute: the case stands at time "
            << runTime_.timeName() << ", and to endTime in system/controlDict, "
            << Time::timeName(runTime_.endTime().value()) << ", less than half a step"
            << " is left (deltaT " << runTime_.deltaTValue() << " s)." << nl
            << "    To continue, raise endTime or reduce deltaT." << nl << nl
            << "End" << nl << endl;
        return;
    }
    Info<< "Nothing to compute: the case stands at time " << runTime_.timeName()
        << ", and endTime in system/controlDict is "
        << Time::timeName(runTime_.endTime().value()) << '.' << nl
        << "    To continue, raise endTime. To start anew, remove the later times"
        << " and the tables (./Allclean of a tutorial; foamListTimes -rm"
        << (Pstream::parRun() ? " -processor" : "")
        << " and rm -r postProcessing)." << nl << nl << "End" << nl << endl;
}


void Foam::stepReport::end() const
{
    cloud_.timing().print(Info, since(start_));

    const scalar measured = clumpWork(cloud_).measuredCellsPerSphere();
    const clumpWork work
    (
        cloud_, measured > 0 ? measured : clumpWork::usualCellsPerSphere
    );
    if (Pstream::parRun())
    {
        work.print(Info);
    }
    else if (measured > 0)
    {
        Info<< "A sphere of a clump has taken as much time as " << round(measured)
            << " mesh cells." << nl << endl;
    }
    Info<< "End" << nl << endl;
}
