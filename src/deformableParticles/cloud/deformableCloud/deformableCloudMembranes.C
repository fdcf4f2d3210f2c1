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
    label index = 0;
    for (clumpParcel& p : *this)
    {
        clumpImage& image = ghosts_.images()[index++];
        if (type(p).hasSurface())
        {
            membranes_[p.typeId()].impose(p, mesh_.time().deltaTValue());
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
}
