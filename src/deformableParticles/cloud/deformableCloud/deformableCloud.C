/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"

void Foam::deformableCloud::evolve
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu
)
{
    if (!coupled())
    {
        updateGhosts();
    }
    gatherForces(U, p, nu);
    decideEffects();
    solve(mesh_.time().deltaTValue());

    for (clumpParcel& parcel : *this)
    {
        parcel.accept();
    }
}


void Foam::deformableCloud::evolve()
{
    updateGhosts();
    decideEffects();
    solve(mesh_.time().deltaTValue());

    for (clumpParcel& parcel : *this)
    {
        parcel.accept();
    }
}


void Foam::deformableCloud::solve(const scalar dt)
{
    momentum_ = clumpMomentum();
    for (clumpParcel& p : *this)
    {
        if (!coupled())
        {
            p.step().begin(p.state());
        }
        p.step().end = p.state();
        setSteadyForces(p, dt);
    }

    const label nSub = subSteps(dt);
    const scalar h = dt/nSub;

    for (label sub = 0; sub < nSub; ++sub)
    {
        for (clumpParcel& p : *this)
        {
            p.step().forces = p.step().steadyForces;
        }
        addLoads(mesh_.time().value() - dt + (sub + 1)*h);
        addContacts();
        addWalls();

        const timeBreakdown::timer t(timing_, "clumps");
        for (clumpParcel& p : *this)
        {
            advance(p, h, dt);
        }
    }
    endCorrector(dt);
}


void Foam::deformableCloud::setSteadyForces
(
    clumpParcel& p,
    const scalar dt
)
{
    const clumpType& ct = type(p);
    externalForces& ext = p.step().steadyForces;
    ext = externalForces(ct.size());

    if (effects_.active("gravity"))
    {
        const timeBreakdown::timer t(timing_, "gravity");
        const scalar rho = hasFluid() ? fluidDensity() : 0;
        ext.f +=
        (
            ct.masses() - rho*ct.volumes()*ct.relativeVolume(p.state().x)
        )*g_;
    }
    if (hasFluid())
    {
        coupling_->addForces(p, dt, ext);
    }
    if (coupled())
    {
        momentum_.addFluid(p, coupling_->interiorForces(p, dt));
    }
}


Foam::label Foam::deformableCloud::subSteps(const scalar dt) const
{
    if (!effects_.active("contact"))
    {
        return 1;
    }
    UPtrList<const externalForces> forces(size());
    label index = 0;
    for (const clumpParcel& p : *this)
    {
        forces.set(index++, &p.step().steadyForces);
    }
    return contacts_.subSteps(ghosts_.images(), forces, dt);
}


void Foam::deformableCloud::addLoads(const scalar t)
{
    if (loads_.empty())
    {
        return;
    }
    const timeBreakdown::timer clock(timing_, "loads");

    for (clumpParcel& p : *this)
    {
        for (const load& l : loads_)
        {
            if (l.clumpType() == type(p).name())
            {
                l.add(t, p.step().end.x + p.position(), p.step().forces);
            }
        }
    }
}


void Foam::deformableCloud::addContacts()
{
    if (!effects_.active("contact"))
    {
        return;
    }
    const timeBreakdown::timer t(timing_, "contact");

    setOwnImages(contactGhosts_, true);
    contactGhosts_.update();
    UList<clumpImage>& images = contactGhosts_.images();

    label index = 0;
    for (const clumpParcel& p : *this)
    {
        images[index++].force = p.step().forces.f;
    }
    contacts_.addForces(images, contactGhosts_.nOwn());
    index = 0;
    for (clumpParcel& p : *this)
    {
        p.step().forces.f = images[index++].force;
    }
}


void Foam::deformableCloud::addWalls()
{
    if (!effects_.active("walls"))
    {
        return;
    }
    const timeBreakdown::timer t(timing_, "walls");

    for (clumpParcel& p : *this)
    {
        walls_.addForces(p, p.step().forces);
    }
}


void Foam::deformableCloud::advance
(
    clumpParcel& p,
    const scalar h,
    const scalar dt
)
{
    const clumpType& ct = type(p);
    if (ct.fixed())
    {
        return;
    }
    clumpState& end = p.step().end;
    externalForces& ext = p.step().forces;
    const pointField x0(end.x);
    const vectorField u0(end.u);

    if (hasFluid())
    {
        // What a clump touches adds a resistance that it alone has not
        const externalForces& steady = p.step().steadyForces;
        const bool alone = ext.f == steady.f && ext.k == steady.k;

        coupling_->divideInterior(p, h, dt, ext);
        if (alone)
        {
            coupling_->deflate(p, h, ext);
        }
    }
    integrator_->advance(bonds(p), ext, h, end);
    momentum_.addStep(ct, ext, x0, u0, end, h/dt);
}


void Foam::deformableCloud::endCorrector(const scalar dt)
{
    momentum_.finish(dt);
    for (clumpParcel& p : *this)
    {
        clumpStep& step = p.step();
        step.end.a = (step.end.u - step.imposedU)/dt;
        step.end.b = (step.end.w - step.imposedW)/dt;
        if (coupled())
        {
            coupling_->adapt(p);
        }
    }
}


void Foam::deformableCloud::moveParcels()
{
    const timeBreakdown::timer t(timing_, "clumps");

    if (coupled())
    {
        coupling_->report(*this, nClumps_);
    }

    for (clumpParcel& p : *this)
    {
        p.recentre(type(p));
    }
    clumpParcel::trackingData td(*this);
    Cloud<clumpParcel>::move(*this, td, mesh_.time().deltaTValue());

    nClumps_ = returnReduce(size(), sumOp<label>());
    count_.set("nClumps", nClumps_);
    timing_.endStep
    (
        [&](const char* part) { return effects_.takesPart(part); }
    );
}


void Foam::deformableCloud::setOwnImages
(
    ghostExchange& ghosts,
    const bool atEnd
) const
{
    UList<clumpImage>& images = ghosts.own(size());
    label index = 0;
    for (const clumpParcel& p : *this)
    {
        const clumpState& s = atEnd ? p.step().end : p.state();
        images[index].set(p, type(p), s, index);
        ++index;
    }
}


void Foam::deformableCloud::updateGhosts()
{
    const timeBreakdown::timer t(timing_, "ghosts");

    setOwnImages(ghosts_, false);
    if (coupled())
    {
        label index = 0;
        for (const clumpParcel& p : *this)
        {
            coupling_->setRotation(ghosts_.images()[index++], p.state());
        }
    }
    ghosts_.update();
}
