/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpSuspension.H"
#include "clumpFields.H"
#include "clumpSource.H"
#include "fluidCoupling.H"
#include "standingMesh.H"
#include "symmetryPlanes.H"

bool Foam::clumpSuspension::injects() const
{
    return source_->injects();
}


void Foam::clumpSuspension::setOwnImages()
{
    UList<clumpImage>& images = ghosts_.own(size());
    label index = 0;
    for (const clumpParcel& p : *this)
    {
        images[index].set
        (
            p, type(p), p.state(), index,
            p.step().extrapolation, p.step().extrapolationTime
        );
        ++index;
    }
}


void Foam::clumpSuspension::setFadeFactors()
{
    label index = 0;
    for (clumpParcel& p : *this)
    {
        clumpImage& image = ghosts_.images()[index++];
        image.fadeFactor =
            type(p).ofSpheres() ? openPatches_.fadeFactor(type(p), image.x) : 1;
        p.step().fadeFactor = image.fadeFactor;
    }
}


void Foam::clumpSuspension::updateGhosts()
{
    const timeBreakdown::timer t(timing_, "ghosts");
    setOwnImages();
    ghosts_.updateNeighbours();
    openPatches_.update(ghosts_);
    if (coupled())
    {
        setFadeFactors();
        label index = 0;
        for (const clumpParcel& p : *this)
        {
            coupling_->setRotation(ghosts_.images()[index++], p.state());
        }
    }
    ghosts_.exchange();
}


void Foam::clumpSuspension::removeLeaving()
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


void Foam::clumpSuspension::track()
{
    const standingMesh standing(mesh_);
    clumpParcel::trackingData td(*this);
    td.reached = [this](const clumpParcel& p, const label patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        if (symmetryPlanes::isOne(patch))
        {
            FatalErrorInFunction
                << "The centre of clump " << p.origId() << " of type "
                << type(p).name() << " has reached the plane of symmetry "
                << patch.name() << ", at time " << mesh_.time().timeName()
                << ". Half a clump in the plane is not modelled: contact must keep it"
                << " off (a contactModel other than none, effect contact), with steps"
                << " in which it does not pass its mirror image, or both sides must be"
                << " meshed." << exit(FatalError);
        }
        if (openPatches_.found(patchi))
        {
            count_.leave(p, patchi);
        }
    };
    Cloud<clumpParcel>::move(*this, td, mesh_.time().deltaTValue());
}


Foam::pointField Foam::clumpSuspension::places() const
{
    pointField result(size());
    label index = 0;
    for (const clumpParcel& p : *this)
    {
        result[index++] = p.position();
    }
    return result;
}


void Foam::clumpSuspension::stay(const UList<point>& places)
{
    const timeBreakdown::timer t(timing_, "clumps");
    label index = 0;
    for (clumpParcel& p : *this)
    {
        p.stay(places[index++]);
    }
    track();
}


bool Foam::clumpSuspension::transfer()
{
    const timeBreakdown::timer t(timing_, "clumps");
    if (coupled())
    {
        couplingCoefficient::report(*this, nClumps());
    }
    breakage_.divide(*this, *source_, count_);
    removeLeaving();
    const scalar dt = mesh_.time().deltaTValue();
    for (clumpParcel& p : *this)
    {
        p.slideBack(dt*meshVelocity_);
        p.recentre(type(p));
    }
    track();
    return source_->inject(*this, count_, start_.followFlow()) > 0;
}


void Foam::clumpSuspension::writeFields() const
{
    clumpFields::write(*this, types_);
    writtenTypes::write(name(), mesh_.time(), types_);
}


void Foam::clumpSuspension::writeObjects(objectRegistry& obr) const
{
    IOField<label>& typeIds(cloud::createIOField<label>("typeId", size(), obr));
    IOField<vector>& U(cloud::createIOField<vector>("U", size(), obr));
    IOField<point>& position
    (
        cloud::createIOField<point>("position", size(), obr)
    );
    label i = 0;
    for (const clumpParcel& p : *this)
    {
        typeIds[i] = p.typeId();
        U[i] = p.state().velocity(type(p));
        position[i] = p.centre(type(p));
        ++i;
    }
}


bool Foam::clumpSuspension::coupled() const
{
    return hasFluid() && coupling_->twoWay();
}


Foam::scalar Foam::clumpSuspension::fluidDensity() const
{
    return hasFluid() ? coupling_->density() : 0;
}


const Foam::fluidCoupling& Foam::clumpSuspension::coupling() const
{
    return *coupling_;
}


const Foam::immersedBoundary& Foam::clumpSuspension::boundary() const
{
    return coupling_->boundary();
}


Foam::tmp<Foam::fvVectorMatrix> Foam::clumpSuspension::forcing
(
    const volVectorField& U
) const
{
    tmp<fvVectorMatrix> result(boundary().forcing(U));
    for (const clumpKind& kind : kinds_)
    {
        result.ref() +=
            kind.force()/dimensionedScalar("rho", dimDensity, fluidDensity());
    }
    return result;
}


Foam::vector Foam::clumpSuspension::forceOnFluid(const volVectorField& U) const
{
    vector result(boundary().forceOnFluid(U, fluidDensity()));
    for (const clumpKind& kind : kinds_)
    {
        result += gSum(mesh_.V()*kind.force().primitiveField());
    }
    return result;
}


const Foam::fluidsInside* Foam::clumpSuspension::fluids() const
{
    for (const clumpKind& kind : kinds_)
    {
        if (kind.fluids())
        {
            return kind.fluids();
        }
    }
    return nullptr;
}
