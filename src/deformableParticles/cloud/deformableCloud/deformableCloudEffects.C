/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"

void Foam::deformableCloud::refuseIdleEffects() const
{
    effects_.require("gravity", mag(g_) > 0, "constant/g has no gravity");
    effects_.require
    (
        "contact", contacts_.active(), "the type of contactModel is none"
    );
    effects_.require
    (
        "walls", walls_.active(), "the type of wallContactModel is none"
    );
}


void Foam::deformableCloud::decideEffects()
{
    decideGravity();
    decideContact();
    decideWalls();
}


void Foam::deformableCloud::decideGravity()
{
    if (!effects_.automatic("gravity"))
    {
        return;
    }
    const scalar rho = hasFluid() ? fluidDensity() : 0;
    scalar excess = 0;
    for (const clumpType& ct : types_)
    {
        excess = max(excess, mag(ct.mass() - rho*ct.volume())/ct.mass());
    }
    const bool on = mag(g_) > 0 && excess > 1e-6;
    effects_.decide
    (
        "gravity",
        on,
        mag(g_) == 0 ? "constant/g has no gravity"
      : on ? "the densities of clumps and fluid differ"
      : "the densities of clumps and fluid are equal"
    );
}


void Foam::deformableCloud::decideContact()
{
    if (!effects_.automatic("contact"))
    {
        return;
    }
    if (!contacts_.active())
    {
        effects_.decide("contact", false, "contactModel none");
    }
    else if (nClumps() < 2 && !ghosts_.meetsItself())
    {
        effects_.decide("contact", false, "one clump in the domain");
    }
    else
    {
        const bool near = returnReduce
        (
            contacts_.near
            (
                ghosts_.images(), ghosts_.nOwn(), mesh_.time().deltaTValue()
            ),
            orOp<bool>()
        );
        effects_.decide
        (
            "contact", near, near ? "clumps are near" : "no clumps are near"
        );
    }
}


void Foam::deformableCloud::decideWalls()
{
    if (!effects_.automatic("walls"))
    {
        if (effects_.active("walls"))
        {
            walls_.update(ghosts_);
        }
        return;
    }
    if (!walls_.active())
    {
        effects_.decide("walls", false, "wallContactModel none");
        return;
    }
    walls_.update(ghosts_);
    if (walls_.gapMeasured(*this, maxSpeed()*mesh_.time().deltaTValue()))
    {
        effects_.decide("walls", walls_.near(), walls_.gap());
    }
}
