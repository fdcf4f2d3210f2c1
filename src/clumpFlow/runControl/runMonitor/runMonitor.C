/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "runMonitor.H"
#include "clumpTotals.H"
#include "functionObjectTypes.H"
#include "logBuffer.H"
#include "unreadInput.H"

void Foam::runMonitor::addOptions()
{
    argList::addBoolOption
    (
        "estimate",
        "Run a few steps quietly, print what the case will cost, write nothing"
    );
    argList::addBoolOption
    (
        "quiet",
        "Print warnings and lines of progress instead of each step"
    );
}


Foam::runMonitor::runMonitor
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
    effects_(cloud.effects()),
    timing_(cloud.timing()),
    accuracy_
    (
        cloud.properties(),
        refCast<const fvMesh>(cloud.pMesh()).solutionDict(),
        runTime.controlDict()
    ),
    report_(runTime, cloud, args.found("quiet") || args.found("estimate")),
    watchdog_(runTime, cloud),
    repeated_(runTime, flow, watchdog_.state()),
    estimate_
    (
        runTime, cloud, args.found("estimate"),
        flow.solved() ? flow.control().nCorrPIMPLE() : 0
    ),
    layers_(cloud),
    clumpProperties_("clumpProperties", runTime)
{
    functionObjectTypes::check(runTime);
}


void Foam::runMonitor::start() const
{
    effects_.print(Info);
    if (cloud_.coupled() && effects_.active("refinement"))
    {
        // The mesh is not yet that of the run
        accuracy_.printMeasured(Info);
    }
    else if (cloud_.coupled())
    {
        accuracy_.print(Info, mostSpheres(cloud_), cellsPerDiameter(cloud_));
    }

    // Fields of a time directory
    const polyMesh& mesh = cloud_.pMesh();
    const double n = sizeof(scalar)*double(mesh.nCells());
    runTime_.startLoop
    (
        cloud_.hasFluid()
      ? List<double>({3*n, n, n, sizeof(scalar)*double(mesh.nInternalFaces())})
      : List<double>(1, n)
    );
    Info<< "Starting time loop" << nl << endl;
    report_.start();
}


bool Foam::runMonitor::run() const
{
    const timeBreakdown::timer t(timing_, "write");
    return !(estimate_.wanted() && estimate_.done()) && runTime_.run();
}


void Foam::runMonitor::beginStep()
{
    repeated_.begin();
    ++runTime_;
    report_.beginStep();
}


bool Foam::runMonitor::repeats(couplingIteration& coupling)
{
    const timeBreakdown::timer t(timing_, "checks");
    const string& wrong = watchdog_.judge();
    const word key("couplingResidual");
    scalar before = watchdog_.state().getOrDefault<scalar>(key, GREAT);
    const string disagreement(coupling.disagreement(before));
    watchdog_.state().remove(key);
    if (before < GREAT)
    {
        watchdog_.state().set(key, before);
    }
    const bool thrown = watchdog_.curable();
    if
    (
        (thrown || disagreement.size())
     && repeated_.divide
        (
            thrown ? wrong : Pstream::master() ? disagreement : string()
        )
    )
    {
        cloud_.refuse();
        return true;
    }
    repeated_.accept();
    return false;
}


void Foam::runMonitor::check()
{
    const timeBreakdown::timer t(timing_, "checks");
    watchdog_.check();
}


void Foam::runMonitor::check
(
    const volVectorField& U,
    const volScalarField& p,
    const surfaceScalarField& phi
)
{
    const timeBreakdown::timer t(timing_, "checks");
    watchdog_.check(report_.continuityError(), U, p, phi);
    if (cloud_.coupled())
    {
        layers_.add(U, flow_.nu());
    }
}


void Foam::runMonitor::write() const
{
    const timeBreakdown::timer t(timing_, "write");
    runTime_.write();
}


void Foam::runMonitor::endStep()
{
    if (runTime_.timeIndex() == runTime_.startTimeIndex() + 1)
    {
        unreadInput::tell(refCast<const fvMesh>(cloud_.pMesh()));
    }
    report_.endStep();
    estimate_.add();
}


void Foam::runMonitor::end() const
{
    logBuffer::quieten(false);
    repeated_.end();
    if (report_.idle())
    {
        report_.explainIdle();
    }
    else if (estimate_.wanted())
    {
        estimate_.print
        (
            cloud_.pMesh().globalData().nTotalCells(), accuracy_
        );
    }
    else
    {
        runTime_.endLoop();
        layers_.end();
        report_.end();
    }
}
