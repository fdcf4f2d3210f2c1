/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpMotion.H"
#include "fluidCoupling.H"

void Foam::clumpMotion::findContacts(const scalar dt)
{
    const bool betweenClumps = clumps_.effects().active("contact");
    const bool atWalls = clumps_.effects().active("walls");
    if (coupling_)
    {
        gaps_.setViscosity(coupling_->viscosity());
    }
    if (atWalls)
    {
        // A clump that has come to another processor needs the walls around it there
        walls_.update(clumps_.ghosts());
        walls_.updateMotions(clumps_.ghosts(), gaps_);
    }

    // In further outer correctors the clumps are still where the step began
    if (contacting_.resume(dt, betweenClumps, atWalls))
    {
        return;
    }
    {
        const timeBreakdown::timer t
        (
            clumps_.timing(), betweenClumps ? "contact" : "walls"
        );
        contacting_.find(clumps_, dt, betweenClumps);
    }
    if (atWalls)
    {
        const timeBreakdown::timer t(clumps_.timing(), "walls");
        contacting_.findPlanes();
    }
    contacting_.endSearch();
}


void Foam::clumpMotion::advanceTogether(const scalar dt)
{
    // Those that touch, or come near, at the start or in the last outer corrector
    boolList together(clumps_.size(), false);
    for (clumpParcel& p : clumps_)
    {
        if (!p.step().hasGuess)
        {
            p.step().end = p.state();
        }
    }
    findContacts(dt);
    contacting_.addTouching(together, contacting_.touched());

    label index = 0;
    {
        const timeBreakdown::timer t(clumps_.timing(), "clumps");
        for (clumpParcel& p : clumps_)
        {
            if (!together[index++])
            {
                advance(p, dt);
            }
        }
    }

    // And those that do on their way
    for (bool solved = false; !solved || !contacting_.complete; )
    {
        contacting_.addTouching(together, true);
        bool deviated = false;
        if (contacting_.mustSolve(solved, deviated))
        {
            const timeBreakdown::timer t(clumps_.timing(), "clumps");
            nSolves_ += contacting_.advance(*integrator_, dt);
            index = 0;
            for (clumpParcel& p : clumps_)
            {
                p.step().hasGuess = together[index++];
            }
            solved = true;
            approximate_ = !contacting_.endsStep;
            continue;
        }

        if (!deviated)
        {
            break;
        }
        contacting_.widen();
        findContacts(dt);
        solved = false;
    }

    contacting_.addReceived();
    passing_ = contacting_.passing();
    contactSummary_ = contacting_.summary();
}
