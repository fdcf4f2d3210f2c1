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
    const string reason(lubricationIdle());
    effects_.require("lubrication", reason.empty(), reason);
    if (const gapModel* model = gaps_.model())
    {
        const string idle
        (
            model->idleReason(Foam::cbrt(gMax(mesh_.V().field())))
        );
        if (idle.size())
        {
            FatalIOErrorInFunction(getDict(dict_, "lubrication"))
                << idle.c_str() << exit(FatalIOError);
        }
    }
    if
    (
        (contacts_.laws().frictional() || walls_.laws().frictional())
     && !integrator_->implicit()
    )
    {
        FatalIOErrorInFunction(getDict(dict_, "integrator"))
            << "Entries 'friction' and 'rollingFriction' of a contact model need an"
            << " implicit integrator. Valid here: implicitEuler" << exit(FatalIOError);
    }
    if
    (
        reason.empty() && !effects_.switchedOff("lubrication")
     && !integrator_->implicit()
    )
    {
        FatalIOErrorInFunction(getDict(dict_, "lubrication"))
            << "Entry 'lubrication' needs an implicit integrator: the resistance"
            << " of a narrow gap would limit the step of an explicit one. Valid"
            << " here: implicitEuler" << exit(FatalIOError);
    }
}


void Foam::deformableCloud::decideEffects()
{
    decideGravity();
    decideContact();
    decideWalls();
    decideLubrication();
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
                gapRange()
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
    if (walls_.gapMeasured(*this, displacement, gapRange()))
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


Foam::string Foam::deformableCloud::lubricationIdle() const
{
    const auto acts = [&](const bool model, const char* name)
    {
        return model && !effects_.switchedOff(name);
    };
    return
        !gaps_.model()
      ? "there is no entry lubrication"
      : !effects_.active("feedback")
      ? "the flow does not feel the clumps"
      : !acts(contacts_.active(), "contact") && !acts(walls_.active(), "walls")
      ? "contact is off"
      : "";
}


Foam::scalar Foam::deformableCloud::gapRange() const
{
    if (effects_.switchedOff("lubrication") || lubricationIdle().size())
    {
        return 0;
    }
    scalar width = 0;
    for (const clumpParcel& p : *this)
    {
        width = max(width, Foam::cbrt(mesh_.V()[p.cell()]));
    }
    return gaps_.model()->range(returnReduce(width, maxOp<scalar>()));
}


void Foam::deformableCloud::decideLubrication()
{
    const bool contact = effects_.active("contact");
    const bool near = contact || effects_.active("walls");
    const string reason(lubricationIdle());
    effects_.decide
    (
        "lubrication",
        reason.empty() && near,
        reason.size() ? reason
      : contact ? string("clumps are near")
      : near ? string("walls are near")
      : string("nothing is near")
    );
    gaps_.setActive(effects_.active("lubrication"));
}
