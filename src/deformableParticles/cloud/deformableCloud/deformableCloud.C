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
    accept();
}


void Foam::deformableCloud::accept()
{
    for (clumpParcel& parcel : *this)
    {
        parcel.accept();
    }
    contacting_.forget();
}


void Foam::deformableCloud::evolve()
{
    updateGhosts();
    decideEffects();
    solve(mesh_.time().deltaTValue());
    accept();
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


void Foam::deformableCloud::setOwnImages()
{
    UList<clumpImage>& images = ghosts_.own(size());
    label index = 0;
    for (const clumpParcel& p : *this)
    {
        images[index].set(p, type(p), p.state(), index);
        ++index;
    }
}


void Foam::deformableCloud::updateGhosts()
{
    const timeBreakdown::timer t(timing_, "ghosts");

    setOwnImages();
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
