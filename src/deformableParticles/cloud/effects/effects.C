/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "effects.H"
#include "checkedEntries.H"
#include "HashTable.H"
#include "IOmanip.H"
#include "messageStream.H"
#include "DynamicList.H"
#include <cstring>

namespace
{

const char* const selectableNames[] =
{
    "fluid", "feedback", "convection", "refinement", "gravity", "rotation",
    "loads", "damping", "conservation", "contact", "walls"
};

//- Without a time of their own: a switch (feedback), or too small a part of
//  the clumps' step to look at the clock for
const char* const untimedNames[] =
    {"fluid", "feedback", "damping", "conservation"};

const char* const partNames[] =
{
    "ghosts", "solid fraction", "flow", "force integral", "clumps", "checks",
    "write"
};

}


Foam::effects::effects(const dictionary& dict)
:
    announce_(false),
    frozen_(false),
    running_(nullptr),
    since_(clock::now())
{
    DynamicList<entry> all;
    for (const char* name : selectableNames)
    {
        bool timed = true;
        for (const char* other : untimedNames)
        {
            timed = timed && std::strcmp(name, other);
        }
        all.append
        (
            {name, true, timed, choice::automatic, true, "", 0, 0, 0}
        );
    }
    for (const char* name : partNames)
    {
        all.append
        (
            {word(name, false), false, true, choice::on, true, "", 0, 0, 0}
        );
    }
    entries_.transfer(all);

    if (!dict.found("effects"))
    {
        return;
    }

    const dictionary& chosen = getDict(dict, "effects");
    for (const word& name : chosen.toc())
    {
        HashTable<label> valid;
        for (const char* known : selectableNames)
        {
            valid.insert(known, 0);
        }
        if (!valid.found(name))
        {
            FatalIOErrorInLookup(chosen, "effect", name, valid)
                << exit(FatalIOError);
        }

        const word value(chosen.get<word>(name));
        HashTable<label> choices({{"off", 0}, {"on", 1}, {"auto", 2}});
        if (name == "fluid")
        {
            choices.insert("frozen", 1);
            frozen_ = value == "frozen";
        }
        if (!choices.found(value))
        {
            FatalIOErrorInLookup(chosen, name, value, choices)
                << exit(FatalIOError);
        }

        entry& e = find(name.c_str());
        e.chosen = choice(choices[value]);
        if (e.chosen != choice::automatic)
        {
            e.active = e.chosen == choice::on;
            e.reason = "set by the user";
        }
    }
}


Foam::effects::entry& Foam::effects::find(const char* name)
{
    for (entry& e : entries_)
    {
        if (!std::strcmp(e.name.c_str(), name))
        {
            return e;
        }
    }
    FatalErrorInFunction << "No effect " << name << exit(FatalError);
    return entries_[0];
}


const Foam::effects::entry& Foam::effects::find(const char* name) const
{
    return const_cast<effects&>(*this).find(name);
}


void Foam::effects::runFor(entry* e)
{
    const clock::time_point now = clock::now();
    if (running_)
    {
        running_->seconds +=
            std::chrono::duration<double>(now - since_).count();
    }
    running_ = e;
    since_ = now;
}


void Foam::effects::decide
(
    const char* name,
    const bool on,
    const string& reason
)
{
    entry& e = find(name);

    if (e.chosen != choice::automatic)
    {
        return;
    }
    if (announce_ && e.active != on)
    {
        Info<< "Effect " << name << ": now " << (on ? "on" : "off") << ", "
            << reason.c_str() << endl;
    }
    e.active = on;
    e.reason = reason;
}


void Foam::effects::printTable(Ostream& os)
{
    os  << nl << "Effects" << nl;
    for (const entry& e : entries_)
    {
        if (e.selectable)
        {
            os  << "    " << e.name << ": " << (e.active ? "on" : "off")
                << ", " << e.reason.c_str() << nl;
        }
    }
    os  << endl;
    announce_ = true;
}


void Foam::effects::endStep()
{
    for (entry& e : entries_)
    {
        e.steps += e.active;
    }
}


void Foam::effects::printLedger(Ostream& os, const scalar total) const
{
    const int precision = os.precision(3);

    os  << nl << "Ledger (this processor)" << nl
        << setw(18) << "part" << setw(10) << "steps" << setw(10) << "calls"
        << setw(14) << "seconds" << setw(10) << "share" << nl;

    scalar sum = 0;
    for (const entry& e : entries_)
    {
        if (e.timed)
        {
            os  << setw(18) << e.name.c_str() << setw(10) << e.steps
                << setw(10) << e.calls << setw(14) << e.seconds
                << setw(9) << 100*e.seconds/max(total, VSMALL) << '%' << nl;
            sum += e.seconds;
        }
        else
        {
            os  << setw(18) << e.name.c_str() << setw(10) << e.steps << nl;
        }
    }
    os  << setw(18) << "rest" << setw(10) << ' ' << setw(10) << ' '
        << setw(14) << total - sum
        << setw(9) << 100*(total - sum)/max(total, VSMALL) << '%' << nl << endl;

    os.precision(precision);
}
