/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "costEstimate.H"
#include "memInfo.H"
#include "readableDuration.H"
#include "StringStream.H"
#include <ctime>

namespace
{

using namespace Foam;

//- Three digits
string rounded(const scalar value)
{
    OStringStream os;
    os.precision(3);
    os << value;
    return os.str();
}


void printLine(const char* what, const scalar seconds, const char* gain)
{
    Info<< "    " << what << readableDuration(seconds).c_str() << gain << nl;
}

}


void Foam::costEstimate::printOthers
(
    const label n,
    const scalar mesh,
    const scalar clumps
) const
{
    const scalar step = mesh + clumps;

    // Other kinds of clumps need the flow, and their nodes are no choice of accuracy alone
    bool onlySpheres = true;
    bool severalSpheres = false;
    for (const clumpType& type : cloud_.types())
    {
        onlySpheres = onlySpheres && type.ofSpheres();
        severalSpheres = severalSpheres || (type.ofSpheres() && type.size() > 1);
    }

    Info<< "    With other settings the run would take" << nl;
    printLine("half the time step                ", 2*n*step,
        ", half the error of rotation and drift");
    printLine("twice the time step               ", 0.5*n*step,
        ", twice the error of rotation and drift");
    if (nOuterCorrectors_)
    {
        const scalar finer = Foam::pow(2.0, 3.7);
        printLine("half the mesh cell width          ", n*(finer*mesh + clumps),
            ", a quarter of the error of the drag");
        printLine("twice the mesh cell width         ", n*(mesh/finer + clumps),
            ", four times the error of the drag");
        printLine("one outer corrector more          ",
            n*(mesh*(1 + 1.0/nOuterCorrectors_) + clumps),
            ", a smaller error of coupling and pressure in a step");
        if (onlySpheres)
        {
            printLine("fluid frozen                      ", n*clumps,
                ", with the flow of the start time");
        }
    }
    if (severalSpheres)
    {
        printLine("twice the spheres per clump       ", n*(mesh + 2*clumps),
            ", a quarter of the error of stretching");
    }
    Info<< "    Rotation and drift across the stream are those of a clump in shear, the"
        << " drag that of a" << nl << "    clump at rest, stretching that by two opposite"
        << " forces; doc/accuracy.md has the errors" << nl;
}


Foam::costEstimate::costEstimate
(
    completeTime& runTime,
    const deformableCloud& cloud,
    const bool wanted,
    const label nOuterCorrectors
)
:
    runTime_(runTime),
    cloud_(cloud),
    wanted_(wanted),
    remainingTime_(runTime.endTime().value() - runTime.value()),
    setUp_(scalar(std::clock())/CLOCKS_PER_SEC),
    nOuterCorrectors_(nOuterCorrectors)
{
    if (wanted)
    {
        runTime.functionObjects().off();
        runTime.writeNothing();
    }
}


bool Foam::costEstimate::done() const
{
    return returnReduce
    (
        steps_.size() >= 12 && clock_.elapsedTime() > 3, andOp<bool>()
    );
}


void Foam::costEstimate::print
(
    const label nCells,
    const accuracyLevel& accuracy
) const
{
    const label half = steps_.size()/2;
    const scalar step =
        average(SubList<scalar>(steps_, steps_.size() - half, half));
    const timeBreakdown& timing = cloud_.timing();
    const scalar total = clock_.elapsedTime();
    const scalar clumps = min(timing.seconds("clumps")/total, scalar(1))*step;
    const label n = round(remainingTime_/runTime_.deltaTValue());
    const label peak = returnReduce
    (
        label(memInfo().update().peak()), sumOp<label>()
    );

    Info<< nl << "Estimate from " << steps_.size() << " steps" << nl
        << "    " << nCells << " mesh cells, " << cloud_.nClumps() << " clumps, "
        << Pstream::nProcs() << " processors, " << peak/1024 << " MB" << nl
        << "    " << n << " steps of " << rounded(step).c_str() << " s each, start "
        << rounded(setUp_).c_str() << " s: "
        << rounded(n*step + setUp_).c_str() << " s ("
        << readableDuration(n*step + setUp_).c_str() << ")" << nl;
    if (cloud_.injects())
    {
        Info<< "    Clumps that enter during the run are not in this estimate: a"
            << " run from a later time includes them" << nl;
    }
    timing.print(Info, total);
    printOthers(n, step - clumps, clumps);
    accuracy.printMeasured(Info);
    Info<< nl << "Nothing was written" << nl << endl;
}
