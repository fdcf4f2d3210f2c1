/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "repeatedStep.H"
#include "foamCompat.H"

bool Foam::repeatedStep::adjusts() const
{
    return runTime_.controlDict().getOrDefault("adjustTimeStep", false);
}


bool Foam::repeatedStep::ended() const
{
    return
        adjusts()
      ? nAccepted_ > 1
      : runTime_.value() > wholeEnds_ - 1e-6*whole_;
}


void Foam::repeatedStep::keep()
{
    const word key("dividedStep");
    state_.remove(key);
    if (whole_ > 0 && !adjusts() && !ended())
    {
        dictionary divided;
        divided.add("deltaT", runTime_.deltaTValue());
        divided.add("whole", whole_);
        divided.add("wholeEnds", wholeEnds_);
        state_.add(key, divided);
    }
}


Foam::repeatedStep::repeatedStep
(
    completeTime& runTime,
    incompressibleFlow& flow,
    dictionary& state
)
:
    runTime_(runTime),
    flow_(flow),
    state_(state),
    whole_(0),
    wholeEnds_(0),
    nAccepted_(0),
    nTotal_(0)
{
    if (state.found("dividedStep"))
    {
        const dictionary& divided = state.subDict("dividedStep");
        divided.readEntry("whole", whole_);
        divided.readEntry("wholeEnds", wholeEnds_);
        runTime_.setDeltaT(divided.get<scalar>("deltaT"), false);
    }
}


void Foam::repeatedStep::begin()
{
    // Not sooner: what follows a step, as the function objects, has the length of that step
    if (whole_ > 0 && ended())
    {
        if (!adjusts())
        {
            runTime_.setDeltaT(whole_, false);
        }
        whole_ = 0;
    }
    start_.reset(new TimeState(runTime_));
    if (flow_.solved())
    {
        p_.reset(new volScalarField("pBeforeStep", flow_.p()));
        if (!flow_.Newtonian())
        {
            nu_.reset(new volScalarField("nuBeforeStep", flow_.nu()));
        }
    }
}


void Foam::repeatedStep::goBack()
{
    // Before the time: at another time index, oldTime() would be what there is now
    if (flow_.solved())
    {
        flow_.p() == *p_;
        flow_.U() == flow_.U().oldTime();
        flow_.phi() == flow_.phi().oldTime();
        if (nu_.valid())
        {
            flow_.p().mesh().lookupObjectRef<volScalarField>("nu") == *nu_;
        }
    }
    runTime_.returnTo(*start_);
}


bool Foam::repeatedStep::divide(const string& reason)
{
    const scalar dt = runTime_.deltaTValue();
    if (whole_ > 0 && 0.5*dt < (1 - 1e-6)*whole_/mostParts)
    {
        return false;
    }
    List<string> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = reason;
    gatherToAll(all);

    // A quiet run shows the first
    Info<< (nTotal_ ? "" : "--> ") << "The step to time " << runTime_.timeName()
        << " is repeated with the time step " << 0.5*dt << " s:" << nl;
    for (const string& said : all)
    {
        Info<< said.c_str();
    }
    Info<< endl;

    goBack();
    if (whole_ <= 0)
    {
        whole_ = dt;
        wholeEnds_ = runTime_.value() + dt;
    }
    runTime_.setDeltaT(0.5*dt, adjusts());
    keep();
    nAccepted_ = 0;
    ++nTotal_;
    return true;
}


void Foam::repeatedStep::accept()
{
    ++nAccepted_;
    keep();
}


void Foam::repeatedStep::end() const
{
    if (nTotal_)
    {
        WarningInFunction
            << nTotal_ << " steps were repeated with half the time step, for reasons"
            << " that the log has; that of a quiet run has those of the first." << endl;
    }
}
