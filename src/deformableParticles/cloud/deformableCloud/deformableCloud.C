/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "clumpInjector.H"

void Foam::deformableCloud::evolve
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu
)
{
    if (!coupled())
    {
        lookAhead();
        updateGhosts();
    }
    gatherForces(U, p, nu);
    decideEffects();
    solve(mesh_.time().deltaTValue());

    flowChange_ = Zero;
    if (coupled())
    {
        flowChange_ =
            (U() - U.oldTime()())().weightedAverage(mesh_.V()).value();
    }
}


void Foam::deformableCloud::accept()
{
    for (clumpParcel& parcel : *this)
    {
        parcel.accept
        (
            type(parcel), mesh_.time().deltaTValue()*meshVelocity_, flowChange_
        );
    }
    contacting_.forget();
}


void Foam::deformableCloud::decideEffects()
{
    decisions_.decide
    (
        *this, nClumps(), ghosts_, g_, hasFluid() ? fluidDensity() : 0
    );
}


void Foam::deformableCloud::lookAhead()
{
    const scalar dt = mesh_.time().deltaTValue();
    for (clumpParcel& p : *this)
    {
        // The nodes of a membrane are met at the end of the step, see membraneStep
        const bool nodes = type(p).hasSurface();
        p.step().ahead = (nodes ? 1 : 0.5)*dt*velocityOverMesh(p);
        p.step().span = nodes ? dt : 0;
    }
}


void Foam::deformableCloud::evolve()
{
    updateGhosts();
    decideEffects();
    solve(mesh_.time().deltaTValue());
}


void Foam::deformableCloud::moveParcels()
{
    const timeBreakdown::timer t(timing_, "clumps");

    if (coupled())
    {
        coupling_->report(*this, nClumps());
    }

    removeLeaving();
    for (clumpParcel& p : *this)
    {
        p.slideBack(mesh_.time().deltaTValue()*meshVelocity_);
        p.recentre(type(p));
    }
    clumpParcel::trackingData td(*this);
    td.reached = [this](const clumpParcel& p, const label patchi)
    {
        if (openPatches_.found(patchi))
        {
            count_.leave(p, patchi);
        }
    };
    Cloud<clumpParcel>::move(*this, td, mesh_.time().deltaTValue());
    if (injector_->inject(*this, count_))
    {
        // The distances to the walls were measured without the new clumps. The
        // walls themselves depend on the mesh and the neighbours only
        walls_.newClumps();
    }

    count_.endStep(size());
    timing_.endStep
    (
        [&](const char* part) { return effects_.takesPart(part); }
    );
}


void Foam::deformableCloud::removeLeaving()
{
    if (openPatches_.empty())
    {
        return;
    }
    for (clumpParcel& p : *this)
    {
        const clumpType& ct = type(p);
        const openPatches::place at
        (
            openPatches_.nearest(ct, p.centres(), ct.reach())
        );
        if
        (
            at.gap <= 0 && !ct.fixed()
         && (p.state().velocity(ct) & at.inwards) < 0
        )
        {
            count_.leave(p, at.patchi);
            deleteParticle(p);
        }
    }
}


void Foam::deformableCloud::setPresence()
{
    label index = 0;
    for (clumpParcel& p : *this)
    {
        clumpImage& image = ghosts_.images()[index++];
        image.presence = openPatches_.presence(type(p), image.x);
        p.step().presence = image.presence;
    }
}


void Foam::deformableCloud::setOwnImages()
{
    UList<clumpImage>& images = ghosts_.own(size());
    label index = 0;
    for (const clumpParcel& p : *this)
    {
        images[index].set
        (
            p, type(p), p.state(), index, p.step().ahead, p.step().span
        );
        ++index;
    }
}


void Foam::deformableCloud::updateGhosts()
{
    const timeBreakdown::timer t(timing_, "ghosts");

    setOwnImages();
    ghosts_.updateNeighbours();
    openPatches_.update(ghosts_);
    if (coupled())
    {
        setPresence();
        label index = 0;
        for (const clumpParcel& p : *this)
        {
            coupling_->setRotation(ghosts_.images()[index++], p.state());
        }
    }
    ghosts_.exchange();
}
