/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"

void Foam::deformableCloud::solve(const scalar dt)
{
    for (clumpParcel& p : *this)
    {
        p.step().overshootsBefore = p.overshoots();
    }
    {
        const timeBreakdown::timer t(timing_, "loads");
        loads_.sample(ghosts_);
    }

    // Those whose coupling coefficient is raised overshoot; a few times suffice
    constexpr label most = 3;
    for (label n = 0; n < most; ++n)
    {
        solveOnce(dt);
        if (!coupled() || !adaptCoupling(dt, n > 0))
        {
            break;
        }
    }
    for (clumpParcel& p : *this)
    {
        p.step().change = p.step().end.u - p.step().imposedU;
    }
}


bool Foam::deformableCloud::adaptCoupling
(
    const scalar dt,
    const bool repeated
)
{
    bool again = false;
    for (clumpParcel& p : *this)
    {
        again = coupling_->adapt(p, dt, repeated) || again;
    }
    return returnReduce(again, orOp<bool>());
}


void Foam::deformableCloud::solveOnce(const scalar dt)
{
    momentum_ = clumpMomentum();
    passing_.clear();
    contactSummary_ = contactSummary();
    for (clumpParcel& p : *this)
    {
        if (!coupled())
        {
            p.step().begin(p.state());
        }
        setSteadyForces(p, dt);
        p.step().holdForce = Zero;
    }

    label n = 0;
    do
    {
        advanceAll(dt);
    }
    while (loads_.changeHolds(*this, dt, n++));

    for (clumpParcel& p : *this)
    {
        clumpStep& step = p.step();
        if (!type(p).fixed() && !type(p).hasSurface())
        {
            momentum_.addStep(type(p), p.state(), step);
        }
        step.guessed = true;
    }
    endCorrector(dt);
}


void Foam::deformableCloud::advanceAll(const scalar dt)
{
    for (clumpParcel& p : *this)
    {
        clumpStep& step = p.step();
        if (step.guessed)
        {
            // Bonds that broke in a solution that was not accepted
            step.end.broken = p.state().broken;
        }
        step.forces = step.steadyForces;
        step.forces.f += type(p).masses()/type(p).mass()*step.holdForce;
    }
    if (!loads_.empty())
    {
        const timeBreakdown::timer t(timing_, "loads");
        label index = 0;
        for (clumpParcel& p : *this)
        {
            loads_.add(p, index++, p.step().forces);
        }
    }

    if (effects_.active("contact") || effects_.active("walls"))
    {
        advanceTogether(dt);
    }
    else
    {
        const timeBreakdown::timer t(timing_, "clumps");
        for (clumpParcel& p : *this)
        {
            advance(p, dt);
        }
    }
}


void Foam::deformableCloud::addWeight
(
    const clumpParcel& p,
    externalForces& ext
) const
{
    if (effects_.active("gravity"))
    {
        const timeBreakdown::timer t(timing_, "gravity");
        const scalar rho = hasFluid() ? fluidDensity() : 0;
        const clumpType& ct = type(p);
        if (ct.hasSurface())
        {
            ext.f += membranes_.weight(p, rho, g_);
        }
        else
        {
            ext.f += ct.excessMasses(rho, p.state().x)*g_;
        }
    }
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

    addWeight(p, ext);
    if (ct.hasSurface())
    {
        momentum_.addFluid(p, vectorField());
        return;
    }
    if (hasFluid())
    {
        coupling_->addForces(p, dt, ext);
    }
    if (coupled())
    {
        momentum_.addFluid(p, coupling_->interiorForces(p, dt));
    }
    const externalForces& ofMembranes = p.step().ofMembranes;
    if (ofMembranes.f.size())
    {
        ext.f += ofMembranes.f;
        ext.k += ofMembranes.k;
    }
}


void Foam::deformableCloud::advance(clumpParcel& p, const scalar dt)
{
    clumpState& end = p.step().end;
    end = p.state();
    p.step().guessed = false;
    if (type(p).fixed())
    {
        return;
    }
    if (type(p).hasSurface())
    {
        membranes_.advance(p, coupling_->viscosity());
        ++nSolves_;
        return;
    }
    integrator_->advance(bonds(p), p.step().forces, dt, end);
    ++nSolves_;
}


void Foam::deformableCloud::findContacts(const scalar dt, const scalar slack)
{
    const bool betweenClumps = effects_.active("contact");
    const bool atWalls = effects_.active("walls");
    if (coupled())
    {
        gaps_.setViscosity(coupling_->viscosity());
    }
    if (atWalls)
    {
        walls_.updateMotions(ghosts_);
    }

    // In further outer correctors the clumps are still where the step began
    if (contacting_.resume(dt, slack, betweenClumps, atWalls))
    {
        return;
    }
    {
        const timeBreakdown::timer t
        (
            timing_, betweenClumps ? "contact" : "walls"
        );
        contacting_.find(*this, dt, slack, betweenClumps);
    }
    if (atWalls)
    {
        const timeBreakdown::timer t(timing_, "walls");
        contacting_.findPlanes();
    }
    contacting_.endSearch();
}


void Foam::deformableCloud::advanceTogether(const scalar dt)
{
    // A tenth of a radius on either side finds the contacts of a steady motion
    scalar slack = 0;
    for (const clumpType& ct : types_)
    {
        slack = max(slack, 0.1*min(ct.radii()));
    }

    // Those that touch at the start or did so in the last outer corrector
    boolList together(size(), false);
    for (clumpParcel& p : *this)
    {
        if (!p.step().guessed)
        {
            p.step().end = p.state();
        }
    }
    findContacts(dt, slack);
    slack = contacting_.slack();
    bool any = contacting_.addTouching(together);

    label index = 0;
    {
        const timeBreakdown::timer t(timing_, "clumps");
        for (clumpParcel& p : *this)
        {
            if (!together[index++])
            {
                advance(p, dt);
            }
        }
    }

    // And those that do on their way
    for (bool solved = false; true; )
    {
        const bool added = contacting_.addTouching(together);
        any = any || added;
        if (any && (added || !solved))
        {
            const timeBreakdown::timer t(timing_, "clumps");
            nSolves_ += integrator_->advance(contacting_, dt);
            index = 0;
            for (clumpParcel& p : *this)
            {
                p.step().guessed = together[index++];
            }
            solved = true;
            continue;
        }

        const scalar deviation = contacting_.deviation();
        if (deviation <= slack)
        {
            break;
        }
        slack = 1.5*deviation;
        findContacts(dt, slack);
        solved = false;
    }

    contacting_.addReceived();
    passing_ = contacting_.passing();
    contactSummary_ = contacting_.summary();
}


void Foam::deformableCloud::endCorrector(const scalar dt)
{
    momentum_.finish(dt);
    for (clumpParcel& p : *this)
    {
        clumpStep& step = p.step();
        step.end.a =
            type(p).hasSurface()
          ? membraneStep::acceleration(p, dt, mesh_.time().deltaT0Value())
          : vectorField((step.end.u - step.imposedU)/dt);
        step.end.b = (step.end.w - step.imposedW)/dt;
    }
}
