/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "watchdog.H"
#include "checkedEntries.H"
#include "clumpMotion.H"
#include "clumpTotals.H"
#include "flowDriving.H"
#include "foamCompat.H"
#include "fvcDiv.H"
#include "repeatedStep.H"
#include "StringStream.H"
#include "wallPolyPatch.H"

namespace
{

using namespace Foam;

//- Largest distance from the first sphere
scalar extent(const pointField& x)
{
    scalar result = 0;
    for (const point& p : x)
    {
        result = max(result, mag(p - x[0]));
    }
    return result;
}


//- ", patch bottom": the wall patch of this processor that is nearest
string nearestWall(const polyMesh& mesh, const point& x)
{
    scalar nearest = GREAT;
    string result;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<wallPolyPatch>(pp) && pp.size())
        {
            const scalar d = min(mag(pp.faceCentres() - x));
            if (d < nearest)
            {
                nearest = d;
                result = ", patch " + pp.name();
            }
        }
    }
    return result;
}

}


void Foam::watchdog::halve(const bool halves)
{
    halves_ = halves;
    state_.set("halveStep", halves_);
}


void Foam::watchdog::stop(const string& what, const string& remedy)
{
    if (!returnReduce(what.size() > 0, orOp<bool>()))
    {
        return;
    }
    List<string> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = what;
    gatherToAll(all);

    string said;
    for (const string& s : all)
    {
        said += s;
    }

    runTime_.writeAside("unstable");
    FatalErrorInFunction
        << "The run has become unstable at time " << runTime_.timeName()
        << ":" << nl << said.c_str() << remedy.c_str() << nl
        << "The state has been written to " << runTime_.timeName()
        << ".unstable. The next run continues from the last time before it;"
        << nl << "rename this folder to " << runTime_.timeName()
        << " to inspect the state. The limits are in controlDict, watchdog."
        << exit(FatalError);
}


Foam::string Foam::watchdog::place
(
    const scalarField& values,
    const string& said,
    const volVectorField& U,
    const volScalarField& p
)
{
    scalar most = -1;
    label cell = -1;
    forAll(values, i)
    {
        // Or not a number
        if (!(values[i] <= most))
        {
            most = values[i];
            cell = i;
        }
    }
    scalarList all(Pstream::nProcs(), scalar(-1));
    all[Pstream::myProcNo()] = most;
    gatherToAll(all);
    label owner = 0;
    forAll(all, i)
    {
        if (!(all[i] <= all[owner]))
        {
            owner = i;
        }
    }
    if (owner != Pstream::myProcNo() || cell < 0)
    {
        return string();
    }
    OStringStream os;
    os  << said.c_str() << " at " << U.mesh().cellCentres()[cell]
        << flowDriving::patches(cell, U, p).c_str() << nl;
    return os.str();
}


Foam::scalar Foam::watchdog::roundingSpeed(const fvMesh& mesh) const
{
    return 1e-3*Foam::cbrt(gMin(mesh.V()))/runTime_.deltaTValue();
}


Foam::scalar Foam::watchdog::driving
(
    const volVectorField& U,
    const volScalarField& p,
    const surfaceScalarField& phi
) const
{
    return max
    (
        max(maxSpeed(cloud_), flowDriving::speed(U, p, phi)),
        roundingSpeed(U.mesh())
    );
}


void Foam::watchdog::checkContinuity
(
    const scalar error,
    const volVectorField& U,
    const volScalarField& p,
    const surfaceScalarField& phi
)
{
    halve
    (
        halves_
     || returnReduce(error, maxOp<scalar>()) > 0.5*maxContinuity_
    );
    if (!(error < maxContinuity_))
    {
        volScalarField local(fvc::div(phi));
        if (cloud_.coupled())
        {
            local -= cloud_.dilation();
        }
        OStringStream said;
        said<< "    mean continuity error " << error << "; the largest is";
        stop
        (
            place(mag(local.primitiveField()), said.str(), U, p),
            "Set 'consistent yes' in PISO, reduce relTol of p, or reduce"
            " deltaT."
        );
    }
}


void Foam::watchdog::checkGrowth
(
    const volVectorField& U,
    const volScalarField& p,
    const surfaceScalarField& phi
)
{
    const scalarField speeds(mag(U.primitiveField()));
    const scalar speed = gMax(speeds);
    reversal_.check(U, p, phi, speed > roundingSpeed(U.mesh()));

    if (!growth_.valid())
    {
        growth_.reset(new flowGrowth(runTime_.startTime().value(), speed));
    }
    const scalar growth =
        growth_->add(runTime_.value(), speed, driving(U, p, phi));

    if (runTime_.writeTime())
    {
        growth_->write(state_.subDictOrAdd("growth"));
    }

    if (!(growth < maxGrowth_))
    {
        OStringStream said;
        said<< "    the largest velocity has grown to " << speed << " m/s, "
            << growth << " times what the boundary conditions, the clumps"
            << " and the earlier flow account for," << nl << "   ";
        stop
        (
            place(speeds, said.str(), U, p),
            "Check the boundary conditions of U and p (where p is fixed, U must"
            " be zeroGradient," "\n"
            "inletOutlet or pressureInletOutletVelocity), set 'consistent yes'"
            " in PISO, or reduce deltaT." "\n"
            "Where a force in fvOptions starts the flow, increase maxGrowth."
        );
    }
}


Foam::watchdog::watchdog
(
    completeTime& runTime,
    const deformableCloud& cloud
)
:
    runTime_(runTime),
    cloud_(cloud),
    deep_(false),
    deepBefore_(false),
    curable_(true),
    halves_(false),
    state_
    (
        IOobject
        (
            "watchdog", runTime.timeName(), "uniform", runTime,
            IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE
        )
    )
{
    const dictionary dict
    (
        withPresentNames
        (
            runTime.controlDict().subOrEmptyDict("watchdog"),
            {{"maxWay", "maxDisplacement"}}
        )
    );
    checkEntries
    (
        dict, {"maxDisplacement", "maxExtent", "maxContinuity", "maxGrowth"}
    );
    maxDisplacement_ = getPositiveOrDefault(dict, "maxDisplacement", 2);
    maxExtent_ = getPositiveOrDefault(dict, "maxExtent", 5);
    maxContinuity_ = getPositiveOrDefault(dict, "maxContinuity", 0.1);
    maxGrowth_ = getPositiveOrDefault(dict, "maxGrowth", 30);
    halves_ = state_.getOrDefault("halveStep", false);
    if (state_.found("growth"))
    {
        growth_.reset(new flowGrowth(getDict(state_, "growth")));
    }
}


Foam::string Foam::watchdog::throughWalls()
{
    // A sphere that has gone through in this step had its centre behind the wall
    // before; now the wall may not act on it any more
    deep_ = cloud_.motion().overlaps().second() > 1;
    OStringStream said;
    for (const clumpParcel& p : cloud_)
    {
        const clumpType& type = cloud_.type(p);
        if (type.fixed())
        {
            continue;
        }

        const pointField x(p.position() + p.step().end.x);
        label behind = -1;
        for
        (
            label i = 0;
            (deep_ || deepBefore_) && i < x.size() && behind < 0;
            ++i
        )
        {
            const scalar r = type.radii()[i];
            wallSurface::nearPlace wall;
            if
            (
                cloud_.motion().walls().surface().nearest(x[i], 4*r, wall)
             && wall.height < -r
            )
            {
                behind = i;
            }
        }

        // From where tracking through the mesh has ended
        const point before(p.state().centre(type));
        const scalar outside = mag(before);
        const scalar reach = max(mag(p.state().x - before) + type.radii());
        if (behind < 0 && outside < reach)
        {
            continue;
        }
        said<< "    clump " << p.origId() << " at " << average(x) << ": ";
        if (behind >= 0)
        {
            said<< "sphere " << behind << " has passed through a wall";
        }
        else
        {
            said<< "it is outside the mesh, behind a wall";
        }
        said<< nearestWall(cloud_.pMesh(), average(x)).c_str() << nl;
    }
    return said.str();
}


Foam::string Foam::watchdog::smallerStep() const
{
    return
        runTime_.controlDict().getOrDefault("adjustTimeStep", false)
      ? "Reduce maxDisplacement or maxDeltaT in system/controlDict"
      : "Reduce deltaT or set adjustTimeStep yes";
}


Foam::string Foam::watchdog::thrown()
{
    OStringStream said;
    label index = 0;
    for (const clumpParcel& p : cloud_)
    {
        const clumpType& type = cloud_.type(p);
        const clumpState& s = p.step().end;
        OStringStream name;
        name<< "    clump " << p.origId() << " at "
            << p.position() + s.centre(type) << ": ";
        if (cloud_.motion().passing().size() && cloud_.motion().passing()[index++])
        {
            said<< name.str().c_str() << "passes through another clump in one step"
                << nl;
        }
        if (!p.step().solved)
        {
            said<< name.str().c_str() << "its step has no solution"
                << nl;
        }
        const scalar displacement =
            runTime_.deltaTValue()
           *max(mag(s.u - cloud_.meshVelocity())/type.bodyRadii());
        const scalar r = max(type.radii());
        const scalar size =
            (extent(s.x) + r)/(extent(type.centres()) + r);

        if (!(displacement < maxDisplacement_))
        {
            said<< name.str().c_str() << "a sphere is displaced by "
                << displacement << " radii in one step" << nl;
            // Nodes of a surface have the velocity to which the outer correctors drove the flow
            curable_ =
                curable_
             && (
                    !type.ofSpheres()
                 || displacement < repeatedStep::mostParts*maxDisplacement_
                );
        }
        if (!(size < maxExtent_))
        {
            said<< name.str().c_str() << size << " times as long as at rest" << nl;
        }
    }
    return said.str();
}


const Foam::string& Foam::watchdog::judge()
{
    curable_ = true;
    wrong_ = throughWalls();
    if (returnReduce(wrong_.size() > 0, orOp<bool>()))
    {
        remedy_ =
            cloud_.effects().switchedOff("walls")
          ? string("Switch the effect walls on in constant/clumpProperties.")
          : "The wall yields too much to the force that presses the clump against"
            " it. Increase\nreducedModulus (or stress) of wallContactModel in"
            " constant/clumpProperties, or: " + smallerStep() + '.';
        return wrong_;
    }
    wrong_ = thrown();
    remedy_ =
        smallerStep()
      + (
            cloud_.coupled()
          ? ", increase the coefficient of the couplingScheme, or increase"
            " nOuterCorrectors."
          : "."
        );
    return wrong_;
}


bool Foam::watchdog::curable() const
{
    return
        returnReduce(wrong_.size() > 0, orOp<bool>())
     && returnReduce(curable_, andOp<bool>());
}


void Foam::watchdog::check()
{
    deepBefore_ = deep_;
    halve(cloud_.motion().needsShorterStep());
    stop(wrong_, remedy_);
}


void Foam::watchdog::check
(
    const scalar continuity,
    const volVectorField& U,
    const volScalarField& p,
    const surfaceScalarField& phi
)
{
    checkContinuity(continuity, U, p, phi);
    checkGrowth(U, p, phi);
}
