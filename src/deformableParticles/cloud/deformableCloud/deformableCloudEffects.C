/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"

void Foam::deformableCloud::refuseIdleEffects() const
{
    effects_.require("gravity", mag(g_) > 0, "constant/g is absent or zero");
    effects_.require
    (
        "contact", contacts_.active(), "the type of contactModel is none"
    );
    effects_.require
    (
        "walls", walls_.active(), "the type of wallContactModel is none"
    );
    for (const word& entry : gapForces::entries())
    {
        const string reason(idleReason(entry));
        effects_.require(entry.c_str(), reason.empty(), reason);
        if (const gapModel* model = gaps_.model(entry))
        {
            const string idle
            (
                model->idleReason(Foam::cbrt(gMax(mesh_.V().field())))
            );
            if (idle.size())
            {
                FatalIOErrorInFunction(getDict(dict_, entry))
                    << idle.c_str() << exit(FatalIOError);
            }
        }
        if
        (
            reason.empty() && !effects_.switchedOff(entry.c_str())
         && gaps_.model(entry)->needsFluid() && !integrator_->implicit()
        )
        {
            FatalIOErrorInFunction(getDict(dict_, entry))
                << "Entry '" << entry << "' needs an implicit integrator:"
                << " the resistance of a narrow gap would limit the step of an"
                << " explicit one. Valid here: implicitEuler"
                << exit(FatalIOError);
        }
    }
}


void Foam::deformableCloud::decideEffects()
{
    decideGravity();
    decideContact();
    decideWalls();
    decideGaps();
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
        mag(g_) == 0 ? "constant/g is absent or zero"
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
        effects_.decide
        (
            "contact", false,
            nClumps() ? "one clump in the domain" : "no clump in the domain"
        );
    }
    else
    {
        const bool near = returnReduce
        (
            contacts_.near
            (
                ghosts_.images(), ghosts_.nOwn(), mesh_.time().deltaTValue(),
                gapRange(false)
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
    const scalar displacement = maxSpeed()*mesh_.time().deltaTValue();
    if (walls_.gapMeasured(*this, displacement, gapRange(true)))
    {
        effects_.decide("walls", walls_.near(), walls_.gap());
    }
}


void Foam::deformableCloud::renewWalls()
{
    walls_.clear();
    if (effects_.active("walls"))
    {
        walls_.update(ghosts_);
    }
}


Foam::string Foam::deformableCloud::idleReason(const word& entry) const
{
    const gapModel* model = gaps_.model(entry);
    if (!model)
    {
        return "there is no entry " + entry;
    }
    if (model->needsFluid() && !effects_.active("feedback"))
    {
        return "the flow does not feel the clumps";
    }
    const bool between = contacts_.active() && !effects_.switchedOff("contact");
    const bool atWalls =
        model->atWalls() && walls_.active() && !effects_.switchedOff("walls");
    if (!between && !atWalls)
    {
        return "contact is off";
    }
    return "";
}


Foam::scalar Foam::deformableCloud::gapRange(const bool atWalls) const
{
    scalar width = 0;
    scalar result = 0;
    for (const word& entry : gapForces::entries())
    {
        if (effects_.switchedOff(entry.c_str()) || idleReason(entry).size())
        {
            continue;
        }
        if (width == 0)
        {
            for (const clumpParcel& p : *this)
            {
                width = max(width, Foam::cbrt(mesh_.V()[p.cell()]));
            }
            reduce(width, maxOp<scalar>());
        }
        const gapModel& model = *gaps_.model(entry);
        if (!atWalls || model.atWalls())
        {
            result = max(result, model.range(width));
        }
    }
    return result;
}


void Foam::deformableCloud::decideGaps()
{
    const bool contact = effects_.active("contact");
    const bool walls = effects_.active("walls");
    for (const word& entry : gapForces::entries())
    {
        const string reason(idleReason(entry));
        const gapModel* model = gaps_.model(entry);
        const bool near = contact || (model && model->atWalls() && walls);
        effects_.decide
        (
            entry.c_str(),
            reason.empty() && near,
            reason.size() ? reason
          : contact ? string("clumps are near")
          : near ? string("walls are near")
          : string("nothing is near")
        );
        gaps_.setActive(entry, effects_.active(entry.c_str()));
    }
}
