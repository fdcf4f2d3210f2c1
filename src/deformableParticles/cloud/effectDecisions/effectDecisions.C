/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "effectDecisions.H"
#include "checkedEntries.H"

Foam::effectDecisions::effectDecisions
(
    const fvMesh& mesh,
    const dictionary& clumpProperties,
    const PtrList<clumpType>& types,
    sceneEffects& effects,
    const clumpContacts& contacts,
    wallContacts& walls,
    gapForces& gaps
)
:
    mesh_(mesh),
    dict_(clumpProperties),
    types_(types),
    effects_(effects),
    contacts_(contacts),
    walls_(walls),
    gaps_(gaps)
{}


void Foam::effectDecisions::refuseIdle
(
    const vector& g,
    const bool implicit
) const
{
    effects_.require("gravity", mag(g) > 0, "constant/g is absent or zero");
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
     && !implicit
    )
    {
        FatalIOErrorInFunction(getDict(dict_, "integrator"))
            << "Entries 'friction' and 'rollingFriction' of a contact model need an"
            << " implicit integrator. Valid here: implicitEuler" << exit(FatalIOError);
    }
    if
    (
        reason.empty() && !effects_.switchedOff("lubrication")
     && !implicit
    )
    {
        FatalIOErrorInFunction(getDict(dict_, "lubrication"))
            << "Entry 'lubrication' needs an implicit integrator: the resistance"
            << " of a narrow gap would limit the step of an explicit one. Valid"
            << " here: implicitEuler" << exit(FatalIOError);
    }
}


void Foam::effectDecisions::decide
(
    const Cloud<clumpParcel>& clumps,
    const label nClumps,
    const ghostExchange& ghosts,
    const vector& g,
    const scalar rho
)
{
    decideGravity(g, rho);
    decideContact(clumps, nClumps, ghosts);
    decideWalls(clumps, ghosts);
    decideLubrication();
}


void Foam::effectDecisions::decideGravity(const vector& g, const scalar rho)
{
    if (!effects_.automatic("gravity"))
    {
        return;
    }
    scalar excess = 0;
    for (const clumpType& ct : types_)
    {
        excess = max(excess, mag(ct.mass() - rho*ct.volume())/ct.mass());
    }
    const bool on = mag(g) > 0 && excess > 1e-6;
    effects_.decide
    (
        "gravity",
        on,
        mag(g) == 0 ? "constant/g is absent or zero"
      : on ? "the densities of clumps and fluid differ"
      : "the densities of clumps and fluid are equal"
    );
}


void Foam::effectDecisions::decideContact
(
    const Cloud<clumpParcel>& clumps,
    const label nClumps,
    const ghostExchange& ghosts
)
{
    if (!effects_.automatic("contact"))
    {
        return;
    }
    if (!contacts_.active())
    {
        effects_.decide("contact", false, "contactModel none");
    }
    else if (nClumps < 2 && !ghosts.meetsItself())
    {
        effects_.decide
        (
            "contact", false,
            nClumps ? "one clump in the domain" : "no clump in the domain"
        );
    }
    else
    {
        const bool near = returnReduce
        (
            contacts_.near
            (
                ghosts.images(), ghosts.nOwn(), mesh_.time().deltaTValue(),
                gapRange(clumps)
            ),
            orOp<bool>()
        );
        effects_.decide
        (
            "contact", near, near ? "clumps are near" : "no clumps are near"
        );
    }
}


void Foam::effectDecisions::decideWalls
(
    const Cloud<clumpParcel>& clumps,
    const ghostExchange& ghosts
)
{
    if (!effects_.automatic("walls"))
    {
        if (effects_.active("walls"))
        {
            walls_.update(ghosts);
        }
        return;
    }
    if (!walls_.active())
    {
        effects_.decide("walls", false, "wallContactModel none");
        return;
    }
    walls_.update(ghosts);
    scalar speed = 0;
    for (const clumpParcel& p : clumps)
    {
        speed = max(speed, max(mag(p.state().u)));
    }
    reduce(speed, maxOp<scalar>());
    const scalar displacement = speed*mesh_.time().deltaTValue();
    if (walls_.gapMeasured(clumps, displacement, gapRange(clumps)))
    {
        effects_.decide("walls", walls_.near(), walls_.gap());
    }
}


void Foam::effectDecisions::renewWalls(const ghostExchange& ghosts)
{
    walls_.clear();
    if (effects_.active("walls"))
    {
        walls_.update(ghosts);
    }
}


Foam::string Foam::effectDecisions::lubricationIdle() const
{
    return
        !gaps_.model()
      ? "there is no entry lubrication"
      : !effects_.active("feedback")
      ? "the flow does not feel the clumps"
      : !clumpsMayTouch() && !wallsMayTouch()
      ? "contact is off"
      : "";
}


Foam::scalar Foam::effectDecisions::gapRange
(
    const Cloud<clumpParcel>& clumps
) const
{
    if (effects_.switchedOff("lubrication") || lubricationIdle().size())
    {
        return 0;
    }
    scalar width = 0;
    for (const clumpParcel& p : clumps)
    {
        width = max(width, Foam::cbrt(mesh_.V()[p.cell()]));
    }
    return gaps_.model()->range(returnReduce(width, maxOp<scalar>()));
}


void Foam::effectDecisions::decideLubrication()
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


bool Foam::effectDecisions::clumpsMayTouch() const
{
    return contacts_.active() && !effects_.switchedOff("contact");
}


bool Foam::effectDecisions::wallsMayTouch() const
{
    return walls_.active() && !effects_.switchedOff("walls");
}
