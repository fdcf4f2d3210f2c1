/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "timeBreakdown.H"
#include "IOmanip.H"
#include "error.H"
#include <cstring>

Foam::timeBreakdown::timeBreakdown()
:
    running_(nullptr),
    since_(clock::now())
{
    // In the order of the table
    const char* const names[] =
    {
        "flow", "convection", "refinement", "solid fraction", "rotation",
        "force integral", "ghosts", "clumps", "gravity", "loads", "contact",
        "walls", "checks", "write"
    };
    for (const char* name : names)
    {
        parts_.append({name, 0, 0, 0});
    }
}


Foam::timeBreakdown::part& Foam::timeBreakdown::find(const char* name)
{
    for (part& p : parts_)
    {
        if (!std::strcmp(p.name, name))
        {
            return p;
        }
    }
    FatalErrorInFunction
        << "No part of a time step is called " << name << exit(FatalError);
    return parts_[0];
}


const Foam::timeBreakdown::part& Foam::timeBreakdown::find
(
    const char* name
) const
{
    return const_cast<timeBreakdown&>(*this).find(name);
}


void Foam::timeBreakdown::chargeTo(part* p)
{
    const clock::time_point now = clock::now();
    if (running_)
    {
        running_->seconds +=
            std::chrono::duration<double>(now - since_).count();
    }
    running_ = p;
    since_ = now;
}


void Foam::timeBreakdown::endStep
(
    const std::function<bool(const char*)>& takesPart
)
{
    for (part& p : parts_)
    {
        p.steps += takesPart(p.name) ? 1 : 0;
    }
}


void Foam::timeBreakdown::print(Ostream& os, const scalar total) const
{
    const int precision = os.precision(3);

    os  << nl << "Time breakdown (this processor)" << nl
        << setw(18) << "part" << setw(10) << "steps" << setw(10) << "calls"
        << setw(14) << "seconds" << setw(10) << "share" << nl;

    scalar sum = 0;
    for (const part& p : parts_)
    {
        os  << setw(18) << p.name << setw(10) << p.steps << setw(10) << p.calls
            << setw(14) << p.seconds
            << setw(9) << 100*p.seconds/max(total, VSMALL) << '%' << nl;
        sum += p.seconds;
    }
    os  << setw(18) << "rest" << setw(10) << ' ' << setw(10) << ' '
        << setw(14) << total - sum
        << setw(9) << 100*(total - sum)/max(total, VSMALL) << '%' << nl << endl;

    os.precision(precision);
}
