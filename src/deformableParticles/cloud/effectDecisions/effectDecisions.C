/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "effectDecisions.H"
#include "checkedEntries.H"
#include "clumpTotals.H"
#include "symmetryPlanes.H"

Foam::effectDecisions::effectDecisions
(
    const clumpSuspension& clumps,
    const clumpContacts& contacts,
    wallContacts& walls,
    gapForces& gaps
)
:
    clumps_(clumps),
    effects_(clumps.effects()),
    contacts_(contacts),
    walls_(walls),
    gaps_(gaps)
{}


void Foam::effectDecisions::refuseIdle(const bool implicit) const
{
    const dictionary& dict = clumps_.properties();
    effects_.require("gravity", mag(clumps_.g()) > 0, "constant/g is absent or zero");
    warnOfMirroredWeight();
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
    if (const gapModel* model = gaps_.film())
    {
        const string idle
        (
            model->idleReason(Foam::cbrt(gMax(clumps_.mesh().V().field())))
        );
        if (idle.size())
        {
            FatalIOErrorInFunction(getDict(dict, "lubrication"))
                << idle.c_str() << exit(FatalIOError);
        }
    }
    if
    (
        (contacts_.laws().frictional() || walls_.laws().frictional())
     && !implicit
    )
    {
        FatalIOErrorInFunction(getDict(dict, "integrator"))
            << "Entries 'friction' and 'rollingFriction' of a contact model need an"
            << " implicit integrator. Valid here: implicitEuler" << exit(FatalIOError);
    }
    if
    (
        reason.empty() && !effects_.switchedOff("lubrication")
     && !implicit
    )
    {
        FatalIOErrorInFunction(getDict(dict, "lubrication"))
            << "Entry 'lubrication' needs an implicit integrator: the resistance"
            << " of a narrow gap would limit the step of an explicit one. Valid"
            << " here: implicitEuler" << exit(FatalIOError);
    }
    if (gaps_.hasLaws() && !(implicit && clumpsMayTouch() && wallsMayTouch()))
    {
        FatalIOErrorInFunction(getDict(dict, "surfaceForces"))
            << "Entry 'surfaceForces' needs " << nl
            << (
                implicit
              ? "    contact between clumps and with walls, which keeps apart what"
                " attracts each other: contactModel and wallContactModel other than"
                " none, and the effects contact and walls."
              : "    an implicit integrator. Valid here: implicitEuler"
               )
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::effectDecisions::weight() const
{
    const scalar rho = clumps_.fluidDensity();
    scalar result = 0;
    for (const clumpType& ct : clumps_.types())
    {
        result = max(result, mag(ct.mass() - rho*ct.volume())/ct.mass());
    }
    return mag(clumps_.g()) > 0 && result > 1e-6 ? result : 0;
}


void Foam::effectDecisions::warnOfMirroredWeight() const
{
    const vector& g = clumps_.g();
    if (effects_.switchedOff("gravity") || weight() == 0)
    {
        return;
    }
    const polyBoundaryMesh& patches = clumps_.mesh().boundaryMesh();
    const symmetryPlanes symmetric(patches);
    for (const symmetryPlanes::plane& plane : symmetric.planes())
    {
        if (mag(g & plane.n) > 1e-6*mag(g))
        {
            WarningInFunction
                << "Gravity " << g << " (constant/g) acts across the plane of symmetry "
                << patches[plane.patch].name() << ": half a device stands for a whole one in"
                << " which the weight of the mirror images is mirrored, too." << endl;
        }
    }
}


void Foam::effectDecisions::decide()
{
    decideGravity();
    decideContact();
    decideWalls();
    decideLubrication();
}


void Foam::effectDecisions::decideGravity()
{
    if (!effects_.automatic("gravity"))
    {
        return;
    }
    const bool on = weight() > 0;
    effects_.decide
    (
        "gravity",
        on,
        mag(clumps_.g()) == 0 ? "constant/g is absent or zero"
      : on ? "the densities of clumps and fluid differ"
      : "the densities of clumps and fluid are equal"
    );
}


void Foam::effectDecisions::decideContact()
{
    if (!effects_.automatic("contact"))
    {
        return;
    }
    if (!contacts_.active())
    {
        effects_.decide("contact", false, "contactModel none");
    }
    else if (clumps_.nClumps() < 2 && !clumps_.ghosts().reachesOwnImage())
    {
        effects_.decide
        (
            "contact", false,
            clumps_.nClumps() ? "one clump in the domain" : "no clump in the domain"
        );
    }
    else
    {
        const ghostExchange& ghosts = clumps_.ghosts();
        const bool near = returnReduce
        (
            contacts_.near
            (
                ghosts.images(), ghosts.nOwn(),
                clumps_.mesh().time().deltaTValue(), gapRange()
            ),
            orOp<bool>()
        );
        effects_.decide
        (
            "contact", near, near ? "clumps are near" : "no clumps are near"
        );
    }
}


void Foam::effectDecisions::decideWalls()
{
    if (!effects_.automatic("walls"))
    {
        if (effects_.active("walls"))
        {
            walls_.update(clumps_.ghosts());
        }
        return;
    }
    if (!walls_.active())
    {
        effects_.decide("walls", false, "wallContactModel none");
        return;
    }
    walls_.update(clumps_.ghosts());
    const scalar displacement =
        maxSpeed(clumps_)*clumps_.mesh().time().deltaTValue();
    if (walls_.gapMeasured(clumps_, displacement, gapRange()))
    {
        effects_.decide("walls", walls_.near(), walls_.gap());
    }
}


void Foam::effectDecisions::renewWalls()
{
    walls_.clear();
    if (effects_.active("walls"))
    {
        walls_.update(clumps_.ghosts());
    }
}


Foam::string Foam::effectDecisions::lubricationIdle() const
{
    return
        !gaps_.film()
      ? "there is no entry lubrication"
      : !effects_.active("feedback")
      ? "the flow does not feel the clumps"
      : !clumpsMayTouch() && !wallsMayTouch()
      ? "contact is off"
      : "";
}


bool Foam::effectDecisions::mayLubricate() const
{
    return !effects_.switchedOff("lubrication") && lubricationIdle().empty();
}


Foam::scalar Foam::effectDecisions::gapRange() const
{
    const bool films = mayLubricate();
    if (!films && !gaps_.hasLaws())
    {
        return 0;
    }
    scalar width = 0;
    for (const clumpParcel& p : clumps_)
    {
        width = max(width, Foam::cbrt(clumps_.mesh().V()[p.cell()]));
    }
    reduce(width, maxOp<scalar>());
    return max
    (
        films ? gaps_.film()->range(width, true) : 0, gaps_.lawRange(width)
    );
}


void Foam::effectDecisions::decideLubrication()
{
    const bool contact = effects_.active("contact");
    const bool near =
        contact || effects_.active("walls")
     || clumps_.kinds().size();
    const string reason(lubricationIdle());
    effects_.decide
    (
        "lubrication",
        reason.empty() && near,
        reason.size() ? reason
      : contact ? string("clumps are near")
      : effects_.active("walls") ? string("walls are near")
      : near ? string("surfaces are present")
      : string("nothing is near")
    );
    gaps_.setFilm(effects_.active("lubrication"));
}


bool Foam::effectDecisions::clumpsMayTouch() const
{
    return contacts_.active() && !effects_.switchedOff("contact");
}


bool Foam::effectDecisions::wallsMayTouch() const
{
    return walls_.active() && !effects_.switchedOff("walls");
}
