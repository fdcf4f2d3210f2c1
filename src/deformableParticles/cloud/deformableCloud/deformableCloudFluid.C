/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "clumpInjector.H"

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
        lookAhead();
    }
    updateGhosts();
    if (coupling_->surfaces() && moving)
    {
        if (decisions_.wallsMayTouch())
        {
            walls_.update(ghosts_);
        }
        membranes_.beginContacts(*this, ghosts_, meshVelocity_);
    }
    else
    {
        membranes_.clearContacts();
    }

    const timeBreakdown::timer t(timing_, "solid fraction");
    coupling_->boundary().update(ghosts_.images(), nu);
    ghosts_.returnTensions();
    if (moving)
    {
        turnVelocities(corrected);
    }
    immerseMembranes();
    impose();
}


void Foam::deformableCloud::turnVelocities(const bool extrapolate)
{
    label index = 0;
    for (clumpParcel& p : *this)
    {
        clumpImage& image = ghosts_.images()[index++];
        if (coupling_->turn(p, mesh_.time().deltaTValue(), extrapolate))
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
        image.contraction = image.tension.contraction(image.u, image.omega);
    }
    ghosts_.updateVelocities();
    coupling_->boundary().impose(ghosts_.images());
    if (surfaceImmersion* surfaces = coupling_->surfaces())
    {
        membranes_.impose
        (
            *this, ghosts_, *surfaces, decisions_.clumpsMayTouch(),
            decisions_.wallsMayTouch() ? &walls_.surface() : nullptr
        );
    }
}


void Foam::deformableCloud::immerseMembranes()
{
    surfaceImmersion* surfaces = coupling_->surfaces();
    if (!surfaces)
    {
        return;
    }
    membranes_.immerse(*this, ghosts_, *surfaces);
    loads_.sample(ghosts_);
    label index = -1;
    for (clumpParcel& p : *this)
    {
        ++index;
        if (type(p).hasSurface())
        {
            // As in solveOnce
            externalForces& ext = p.step().forces;
            ext = externalForces(type(p).size());
            addWeight(p, ext);
            loads_.add(p, index, ext);
        }
    }
}


void Foam::deformableCloud::sampleMembranes(const volVectorField& U)
{
    if (surfaceImmersion* surfaces = coupling_->surfaces())
    {
        membranes_.sample(U, *this, ghosts_, *surfaces, coupling_->viscosity());
    }
}


void Foam::deformableCloud::predict
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu
)
{
    gatherForces(U, p, nu);
    solve(mesh_.time().deltaTValue());
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
        sampleMembranes(U);
    }

    label index = 0;
    for (clumpParcel& parcel : *this)
    {
        clumpImage& image = ghosts_.images()[index++];
        if (!type(parcel).hasSurface())
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
            if (!type(parcel).hasSurface())
            {
                coupling_->takeTorques(parcel, image);
            }
        }
    }
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
    updateGhosts();
    coupling_->sampleVelocity(U, nu, ghosts_.images());
    ghosts_.returnForces();
    if (coupled())
    {
        immerseMembranes();
        sampleMembranes(U);
    }

    bool some = false;
    label index = 0;
    for (clumpParcel& p : *this)
    {
        const clumpImage& image = ghosts_.images()[index++];
        if (start_.followsFlow(p) && !type(p).fixed())
        {
            if (type(p).hasSurface())
            {
                p.state().u = p.step().nodes.u;
            }
            else
            {
                coupling_->followFlow(p, image);
            }
            const vector held
            (
                loads_.held(p.typeId()) & p.state().velocity(type(p))
            );
            p.state().u -= held;
        }
        some = some || (!start_.followsFlow(p) && max(mag(p.state().u)) > 0);
    }
    start_.end();

    // What starts with a velocity of its own starts with the fluid inside it
    if (!coupled() || !returnReduce(some, orOp<bool>()))
    {
        return false;
    }
    immerse(nu, false);
    const immersedBoundary& b = boundary();
    U += b.solidFraction()*(b.solidVelocity() - U);
    U.correctBoundaryConditions();
    return true;
}


void Foam::deformableCloud::changeVelocities(const vector& dU)
{
    for (clumpParcel& p : *this)
    {
        p.state().u += dU;
    }
    momentum_.correction = dU;
}


bool Foam::deformableCloud::someFixed() const
{
    bool result = false;
    for (const clumpParcel& p : *this)
    {
        result = result || type(p).fixed();
    }
    return returnReduce(result, orOp<bool>());
}


Foam::symmTensor Foam::deformableCloud::held() const
{
    symmTensor result(Zero);
    if (someFixed())
    {
        result += symmTensor(I);
    }
    return result + loads_.held();
}


Foam::vector Foam::deformableCloud::meanVelocity() const
{
    vector momentum(Zero);
    scalar mass = 0;
    for (const clumpParcel& p : *this)
    {
        momentum += type(p).mass()*p.state().velocity(type(p));
        mass += type(p).mass();
    }
    reduce(momentum, sumOp<vector>());
    reduce(mass, sumOp<scalar>());
    return momentum/max(mass, VSMALL);
}


Foam::vector Foam::deformableCloud::excessMomentum() const
{
    const scalar dt = mesh_.time().deltaTValue();
    vector result(Zero);
    for (const clumpParcel& p : *this)
    {
        const clumpType& ct = type(p);
        const clumpState& s = p.state();
        if (ct.hasSurface())
        {
            continue;
        }
        result +=
            p.step().presence
           *sum
            (
                ct.masses()*s.u - fluidDensity()*ct.volumes()*(s.u - dt*s.a)
            );
    }
    return result;
}


Foam::scalar Foam::deformableCloud::excessMass() const
{
    scalar result = 0;
    for (const clumpParcel& p : *this)
    {
        if (type(p).hasSurface())
        {
            continue;
        }
        result += type(p).mass() - fluidDensity()*sum(type(p).volumes());
    }
    return result;
}


void Foam::deformableCloud::prepareMeshChange()
{
    updateGhosts();
    coupling_->boundary().setCloseness(ghosts_.images());
    storeGlobalPositions();
}


void Foam::deformableCloud::meshChanged()
{
    ghosts_.meshChanged();
    contacting_.meshChanged();
    coupling_->boundary().meshChanged();
    if (coupling_->surfaces())
    {
        coupling_->surfaces()->meshChanged();
    }
    decisions_.renewWalls(ghosts_);
    injector_->meshChanged();
    openPatches_.clear();
}
