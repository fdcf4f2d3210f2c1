/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"

Foam::vectorField Foam::deformableCloud::imposedAngularVelocities
(
    const clumpType& type,
    const clumpState& s
) const
{
    if (!rotationModel_.valid())
    {
        return vectorField(type.size(), Zero);
    }
    return rotationModel_->angularVelocities(type, s);
}


void Foam::deformableCloud::prepareMeshChange()
{
    ghosts_.update(*this);
    immersedBoundary_->setCloseness(ghosts_.images());
    storeGlobalPositions();
}


void Foam::deformableCloud::meshChanged()
{
    immersedBoundary_->meshChanged();
    walls_.clear();
    wallClearance_ = 0;
}


void Foam::deformableCloud::immerse
(
    const volScalarField& nu
)
{
    imposed_.setSize(size());
    lastChange_.setSize(size());
    raised_.setSize(size());
    raised_ = false;
    label index = 0;
    for (const clumpParcel& parcel : *this)
    {
        imposed_[index] = parcel.state();
        lastChange_[index] =
            mesh_.time().deltaT0Value()*parcel.state().a;
        ++index;
    }

    {
        const effects::timer t(effects_, "ghosts");
        ghosts_.update(*this);
    }
    const effects::timer t(effects_, "solid fraction");
    immersedBoundary_->update(ghosts_.images(), nu);
    ghosts_.returnDilations();
    impose();
}


void Foam::deformableCloud::impose()
{
    for (label i = 0; i < ghosts_.nOwn(); ++i)
    {
        clumpImage& image = ghosts_.images()[i];
        image.dilation.removeFrom(image.u, image.omega);
    }
    ghosts_.updateVelocities();
    immersedBoundary_->impose(ghosts_.images());
}


void Foam::deformableCloud::startWithFlow
(
    const volVectorField& U,
    const volScalarField& nu
)
{
    if (!coupled() || returnReduce(followFlow_.empty(), andOp<bool>()))
    {
        return;
    }
    ghosts_.update(*this);
    immersedBoundary_->update(ghosts_.images(), nu);
    immersedBoundary_->sampleVelocity(U, ghosts_.images());
    ghosts_.returnForces();

    label index = 0;
    for (clumpParcel& parcel : *this)
    {
        const clumpImage& image = ghosts_.images()[index++];
        const clumpType& ct = type(parcel);
        if (!followFlow_.found(parcel.origId()) || ct.fixed())
        {
            continue;
        }
        clumpState& s = parcel.state();
        forAll(s.u, i)
        {
            s.u[i] = image.force[i]/max(image.torque[i].x(), VSMALL);
        }
        s.w = vectorField(s.w.size(), Zero);
        s.w = s.angularVelocity(ct);
    }
    followFlow_.clear();
}


void Foam::deformableCloud::iterate
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu
)
{
    mu_ = rho_*gMax(nu.primitiveField());
    gatherForces(U, p, nu);

    // The step as it would end now; its velocities are kept, and the margin
    List<clumpState> start(size());
    label index = 0;
    for (const clumpParcel& parcel : *this)
    {
        start[index++] = parcel.state();
    }

    advance(mesh_.time().deltaTValue());

    index = 0;
    for (clumpParcel& parcel : *this)
    {
        clumpState trial(start[index]);
        trial.u = parcel.state().u;
        trial.w = parcel.state().w;
        imposed_[index].u = trial.u;
        imposed_[index].w = trial.w;

        clumpImage& image = ghosts_.images()[index];
        image.u = trial.u;
        image.omega = imposedAngularVelocities(type(parcel), trial);

        start[index].exchange = parcel.state().exchange;
        start[index].overshoots = parcel.state().overshoots;
        parcel.state() = start[index];
        ++index;
    }

    const effects::timer t(effects_, "solid fraction");
    impose();
}


void Foam::deformableCloud::gatherForces
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu
)
{
    const effects::timer t(effects_, "force integral");

    if (coupled())
    {
        immersedBoundary_->integrate(U, p, nu, rho_, ghosts_.images());
    }
    else
    {
        drag_->integrate(U, mu_, effects_.frozen(), ghosts_.images());
    }
    ghosts_.returnForces();

    label index = 0;
    for (clumpParcel& parcel : *this)
    {
        clumpImage& image = ghosts_.images()[index++];
        image.dilation.removeFromForces(image.force, image.torque);
        parcel.fluidForces() = image.force;
        parcel.fluidTorques() = Zero;

        if (rotationModel_.valid())
        {
            const effects::timer t(effects_, "rotation");
            rotationModel_->transpose
            (
                type(parcel),
                parcel.state(),
                image.torque,
                parcel.fluidForces(),
                parcel.fluidTorques()
            );
        }
    }
}


void Foam::deformableCloud::adaptExchange
(
    clumpParcel& parcel,
    const label index,
    const vectorField& now
)
{
    clumpState& s = parcel.state();
    vectorField& last = lastChange_[index];

    const bool overshoots =
        sum(now & last) < 0
     && sum(magSqr(now)) > sum(magSqr(last))
     && sum(magSqr(now)) > 1e-6*sum(magSqr(s.u));

    // A single one may be the change of an acceleration's sign, if small
    s.overshoots = overshoots ? s.overshoots + 1 : 0;
    const bool unstable =
        s.overshoots > 1
     || (overshoots && sum(magSqr(now)) > 0.01*sum(magSqr(s.u)));
    last = now;
    if (couplingScheme_->damps())
    {
        overshoots_ =
            overshoots_ || (unstable && s.exchange >= maxExchangeFactor);
        raised_[index] = raised_[index] || unstable;
        s.exchange =
            unstable
          ? min(2*s.exchange, maxExchangeFactor)
          : max(0.98*s.exchange, 1.0);
    }
    else
    {
        overshoots_ = overshoots_ || unstable;
    }
}


void Foam::deformableCloud::reportExchange(const label nRaised) const
{
    if (!nRaised)
    {
        return;
    }

    scalar largest = 0;
    label index = 0;
    for (const clumpParcel& parcel : *this)
    {
        if (raised_[index++])
        {
            largest = max(largest, parcel.state().exchange);
        }
    }
    reduce(largest, maxOp<scalar>());

    Info<< "Exchange overshoots: " << nRaised << " of " << nClumps_
        << " clumps, margin times " << largest << " at most"
        << (largest < maxExchangeFactor ? "" : ", the limit") << endl;
}


bool Foam::deformableCloud::needsShorterStep() const
{
    return coupled() && returnReduce(overshoots_, orOp<bool>());
}
