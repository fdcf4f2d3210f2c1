/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"

// Membranes in the fluid, see membraneStep and surfaceImmersion

void Foam::deformableCloud::setNodeForces
(
    clumpParcel& p,
    externalForces& ext
) const
{
    if (effects_.active("gravity"))
    {
        ext.f += membranes_[p.typeId()].weight(p, fluidDensity(), g_);
    }
}


void Foam::deformableCloud::checkMembranes() const
{
    if (surfaceImmersion::wanted(types_) && membranesTouch())
    {
        membraneContacts_.refuseSmallSpheres(getDict(dict_, "types"));
    }
}


bool Foam::deformableCloud::membranesTouch() const
{
    return contacts_.active() && !effects_.switchedOff("contact");
}


const Foam::wallSurface* Foam::deformableCloud::wallsOfMembranes() const
{
    return
        walls_.active() && !effects_.switchedOff("walls")
      ? &walls_.surface() : nullptr;
}


void Foam::deformableCloud::beginContacts(const bool moving)
{
    if (!coupling_->surfaces())
    {
        return;
    }
    if (!moving)
    {
        membraneContacts_.clear();
        return;
    }
    if (walls_.active() && !effects_.switchedOff("walls"))
    {
        walls_.update(ghosts_);
    }
    scalar width = GREAT;
    for (const clumpParcel& p : *this)
    {
        if (type(p).hasSurface())
        {
            width = min(width, Foam::cbrt(mesh_.V()[p.cell()]));
        }
    }
    membraneContacts_.begin
    (
        ghosts_,
        returnReduce(width, minOp<scalar>()),
        mesh_.time().deltaTValue(),
        meshVelocity_
    );
}


void Foam::deformableCloud::immerseMembranes()
{
    if (!coupling_->surfaces())
    {
        return;
    }
    coupling_->surfaces()->update(ghosts_);
    sampleLoads();
    label index = -1;
    for (clumpParcel& p : *this)
    {
        const clumpImage& image = ghosts_.images()[++index];
        if (type(p).hasSurface())
        {
            clumpStep& step = p.step();
            membranes_[p.typeId()].meet(p, image.x);
            step.nodes.smoothing =
                coupling_->surfaces()->smoothing(image, step.nodes.areaVectors);

            // As in solveOnce
            step.forces = externalForces(image.x.size());
            setNodeForces(p, step.forces);
            addLoads(p, index, step.forces);
        }
    }
}


void Foam::deformableCloud::imposeMembranes()
{
    if (!coupling_->surfaces())
    {
        return;
    }
    membraneContacts_.find(ghosts_, *this, membranesTouch(), wallsOfMembranes());
    label index = 0;
    for (clumpParcel& p : *this)
    {
        clumpImage& image = ghosts_.images()[index++];
        if (type(p).hasSurface())
        {
            membranes_[p.typeId()].impose
            (
                p, mesh_.time().deltaTValue(), mesh_.time().deltaT0Value()
            );
            image.force = p.step().nodes.force;
        }
    }
    coupling_->surfaces()->spread(ghosts_);
}


void Foam::deformableCloud::sampleMembranes(const volVectorField& U)
{
    if (!coupling_->surfaces())
    {
        return;
    }
    coupling_->surfaces()->sample(U, ghosts_);
    label index = 0;
    for (clumpParcel& p : *this)
    {
        const clumpImage& image = ghosts_.images()[index++];
        if (type(p).hasSurface())
        {
            nodeFlow& nodes = p.step().nodes;
            nodes.u = nodes.withoutFlux(image.sampled);
        }
    }
    sharpenSamples(U);
}


void Foam::deformableCloud::sharpenSamples(const volVectorField& U)
{
    const surfaceImmersion& surfaces = *coupling_->surfaces();
    const scalar mu = coupling_->viscosity();
    if (mu <= 0)
    {
        // Before the first step
        return;
    }
    const bool other = coupling_->interior();
    if (other)
    {
        surfaces.sampleShear(U, ghosts_);
    }
    label index = 0;
    for (clumpParcel& p : *this)
    {
        const clumpImage& image = ghosts_.images()[index++];
        if (!type(p).hasSurface())
        {
            continue;
        }
        nodeFlow& nodes = p.step().nodes;
        const scalar ratio = type(p).viscosityRatio();
        const vectorField n(nodes.areaVectors/mag(nodes.areaVectors));
        vectorField kink(n.size(), Zero);
        if (other)
        {
            // The part of the force follows in membraneStep
            kink = (1 - 1/ratio)*(image.sampled - n*(n & image.sampled));
            nodes.u -= 0.5*nodes.smoothing*kink;
        }
        const vectorField& F = nodes.force;
        kink -= 0.5*(1 + 1/ratio)/mu*(F - n*(n & F))/nodes.areas;
        nodes.u +=
            ratio/(3 + 2*ratio)*surfaces.variances(image, nodes.areaVectors)
           *type(p).surface().divergence(image.x, kink)*n;
    }
}
