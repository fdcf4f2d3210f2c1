/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "clumpMotion.H"
#include "fluidCoupling.H"

void Foam::deformableCloud::extrapolatePositions()
{
    const scalar dt = mesh_.time().deltaTValue();
    for (clumpParcel& p : *this)
    {
        // See clumpKind
        const bool nodes = kind(p);
        p.step().extrapolation = (nodes ? 1 : 0.5)*dt*velocityOverMesh(p);
        p.step().extrapolationTime = nodes ? dt : 0;
    }
}


void Foam::deformableCloud::immerse
(
    const volScalarField& nu,
    const bool moving,
    const bool corrected
)
{
    for (clumpParcel& p : *this)
    {
        p.step().begin(p.state());
        p.step().change = mesh_.time().deltaT0Value()*p.state().a;
        p.step().imposedChange = p.step().change;
    }
    if (moving)
    {
        extrapolatePositions();
    }
    const bool films = motion().decisions().mayLubricate();
    scalar range =
        kinds_.size() || motion().gaps().hasLaws()
      ? motion().decisions().gapRange() : 0;
    for (const clumpKind& kind : kinds_)
    {
        range = max(range, films ? kind.range() : 0);
    }
    ghosts_.setRange(range);
    updateGhosts();

    const timeBreakdown::timer t(timing_, "solid fraction");
    coupling_->setViscosity(nu);
    for (clumpKind& kind : kinds_)
    {
        if (moving)
        {
            kind.beginContacts
            (
                *this, ghosts_, meshVelocity_,
                motion().gaps(), films, coupling_->viscosity()
            );
        }
        else
        {
            kind.clearContacts();
        }
    }
    coupling_->boundary().update(ghosts_.images(), nu);
    ghosts_.returnConstraints();
    label index = 0;
    for (clumpParcel& p : *this)
    {
        const constraintForces& constraint = ghosts_.images()[index++].constraint;
        p.step().solidVolumes = constraint.solidVolumes;
        p.step().solidMoments = constraint.solidMoments;
        p.step().solidInertias = constraint.solidInertias;
    }
    if (moving)
    {
        turnVelocities(corrected);
    }
    immerseKinds();
    impose();
}


void Foam::deformableCloud::setForcing(const volScalarField& nu)
{
    const timeBreakdown::timer t(timing_, "solid fraction");
    coupling_->boundary().setForcing(nu);
}


void Foam::deformableCloud::setViscosities(const volScalarField& nu)
{
    coupling_->boundary().setViscosities(nu, ghosts_.images());
    ghosts_.returnViscosities();
    label index = 0;
    for (clumpParcel& p : *this)
    {
        const vector2D& sums = ghosts_.images()[index++].viscosity;
        p.step().lastNu = p.step().nu;
        p.step().nu = sums.y() > 0 ? sums.x()/sums.y() : 0;
    }
    for (const clumpKind& kind : kinds_)
    {
        kind.setViscosities(nu, *this, ghosts_);
    }
}


void Foam::deformableCloud::turnVelocities(const bool extrapolate)
{
    label index = 0;
    for (clumpParcel& p : *this)
    {
        clumpImage& image = ghosts_.images()[index++];
        const bool turned =
            coupling_->turn(p, mesh_.time().deltaTValue(), extrapolate);
        if (motion().impose(p) || turned)
        {
            setVelocities(p, image);
        }
    }
}


void Foam::deformableCloud::setVelocities
(
    const clumpParcel& p,
    clumpImage& image
) const
{
    clumpState imposed(p.state());
    imposed.u = p.step().imposedU;
    imposed.w = p.step().imposedW;

    image.u = imposed.u;
    coupling_->setRotation(image, imposed);
}


void Foam::deformableCloud::impose()
{
    for (label i = 0; i < ghosts_.nOwn(); ++i)
    {
        clumpImage& image = ghosts_.images()[i];
        image.contraction = image.constraint.contraction(image.u, image.omega);
    }
    ghosts_.updateVelocities();
    coupling_->boundary().impose(ghosts_.images());
    for (clumpKind& kind : kinds_)
    {
        kind.impose
        (
            *this, ghosts_, motion().decisions().clumpsMayTouch(),
            motion().touchedWalls()
        );
    }
}


void Foam::deformableCloud::immerseKinds()
{
    for (clumpKind& kind : kinds_)
    {
        kind.immerse(*this, ghosts_, coupling_->viscosity());
    }
    if (kinds_.size())
    {
        motion().setNodeForces();
    }
}


void Foam::deformableCloud::sampleKinds(const volVectorField& U)
{
    for (const clumpKind& kind : kinds_)
    {
        kind.sample(U, *this, ghosts_, coupling_->viscosity());
    }
}


void Foam::deformableCloud::imposeFlow(const volVectorField& U)
{
    DynamicList<clumpParcel*> all;
    for (clumpParcel& p : *this)
    {
        all.append(&p);
    }
    followFlow(U, all);
    imposeEnd();
}


const Foam::volScalarField& Foam::deformableCloud::dilation() const
{
    return boundary().dilation();
}


void Foam::deformableCloud::predict
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu
)
{
    gatherForces(U, p, nu);
    motion().solve(false);
}


void Foam::deformableCloud::imposeEnd()
{
    // The clumps stay where they were immersed, with the velocities of the step's end
    label index = 0;
    for (clumpParcel& p : *this)
    {
        p.step().imposedChange = p.step().end.u - p.step().imposedU;
        p.step().imposedU = p.step().end.u;
        p.step().imposedW = p.step().end.w;
        setVelocities(p, ghosts_.images()[index++]);
    }

    const timeBreakdown::timer t(timing_, "solid fraction");
    impose();
}


void Foam::deformableCloud::gatherForces
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu
)
{
    const timeBreakdown::timer t(timing_, "force integral");

    coupling_->integrate(U, p, nu, ghosts_.images());
    ghosts_.returnForces();
    if (coupled())
    {
        sampleKinds(U);
    }

    label index = 0;
    for (clumpParcel& parcel : *this)
    {
        clumpImage& image = ghosts_.images()[index++];
        if (type(parcel).ofSpheres())
        {
            parcel.step().lastFluidForces = parcel.fluidForces();
            coupling_->takeForces(parcel, image);
        }
    }

    if (coupling_->rotates())
    {
        const timeBreakdown::timer t(timing_, "rotation");
        index = 0;
        for (clumpParcel& parcel : *this)
        {
            const clumpImage& image = ghosts_.images()[index++];
            if (type(parcel).ofSpheres())
            {
                coupling_->takeTorques(parcel, image);
            }
        }
    }
}


void Foam::deformableCloud::followFlow
(
    const volVectorField& U,
    const UList<clumpParcel*>& clumps
) const
{
    // Images of these alone: those of the step stay as they are
    ghostExchange ghosts(mesh_);
    UList<clumpImage>& images = ghosts.own(clumps.size());
    forAll(clumps, k)
    {
        const clumpParcel& p = *clumps[k];
        images[k].set(p, type(p), p.state(), k, p.step().extrapolation);
    }
    ghosts.update();
    coupling_->sampleVelocity(U, ghosts);
    for (const clumpKind& kind : kinds_)
    {
        kind.sampleFlow(U, ghosts);
    }

    forAll(clumps, k)
    {
        clumpParcel& p = *clumps[k];
        const clumpImage& image = ghosts.images()[k];
        clumpState& s = p.step().end;
        s = p.state();
        if (type(p).fixed())
        {
            continue;
        }
        if (kind(p))
        {
            s.u = image.sampled;
        }
        else
        {
            coupling_->followFlow(type(p), image, s);
        }
        const vector held(motion().held(p.typeId()) & s.velocity(type(p)));
        s.u -= held;
    }
}


void Foam::deformableCloud::giveFlow(const volVectorField& U)
{
    DynamicList<clumpParcel*> some;
    for (clumpParcel& p : *this)
    {
        if (start_.followsFlow(p))
        {
            some.append(&p);
        }
    }
    if (returnReduce(some.size(), sumOp<label>()))
    {
        followFlow(U, some);
        for (clumpParcel* p : some)
        {
            p->state() = p->step().end;
            count_.setVelocity(*p);
        }
    }
    start_.end();
}


bool Foam::deformableCloud::startWithFlow
(
    volVectorField& U,
    const volScalarField& nu
)
{
    if (coupled())
    {
        openPatches_.warnOfClosed(U);
    }
    if (!start_.starts())
    {
        return false;
    }
    bool some = false;
    for (const clumpParcel& p : *this)
    {
        some = some || (!start_.followsFlow(p) && max(mag(p.state().u)) > 0);
    }
    reduce(some, orOp<bool>());
    giveFlow(U);
    followedFlow_ = coupled() && !some && kinds_.empty();

    // What starts with a velocity of its own starts with the fluid inside it
    if (!coupled() || !some)
    {
        return false;
    }
    immerse(nu, false);
    const immersedBoundary& b = boundary();
    U += b.solidFraction()*(b.solidVelocity() - U);
    U.correctBoundaryConditions();
    return true;
}
