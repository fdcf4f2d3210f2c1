/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"

Foam::vectorField Foam::deformableCloud::imposedSpins
(
    const clumpParcel& p
) const
{
    if (!rotationModel_.valid())
    {
        return vectorField(type(p).size(), Zero);
    }
    return rotationModel_->spins(type(p), p.state());
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
    const volScalarField& nu,
    const bool closed
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
    immersedBoundary_->update(ghosts_.images(), nu, closed);
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
        imposed_[index].u = parcel.state().u;
        imposed_[index].w = parcel.state().w;
        start[index].exchange = parcel.state().exchange;
        start[index].overshoots = parcel.state().overshoots;
        parcel.state() = start[index];
        parcel.state().u = imposed_[index].u;
        parcel.state().w = imposed_[index].w;
        ++index;
    }
    {
        const effects::timer t(effects_, "ghosts");
        ghosts_.update(*this);
    }
    index = 0;
    for (clumpParcel& parcel : *this)
    {
        parcel.state() = start[index++];
    }

    const effects::timer t(effects_, "solid fraction");
    immersedBoundary_->impose(ghosts_.images());
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
        const clumpImage& image = ghosts_.images()[index++];
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
    if (exchangeModel_->damps())
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
