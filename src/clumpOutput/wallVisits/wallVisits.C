/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallVisits.H"
#include "stateList.H"
#include <limits>

namespace
{

Foam::scalar ratio(const Foam::scalar a, const Foam::scalar b)
{
    return
        b > 0 ? a/b : std::numeric_limits<Foam::scalar>::quiet_NaN();
}

}


Foam::functionObjects::wallVisits::wallVisits(const dictionary& state)
{
    stateReader numbers(state, "wall");
    time_ = numbers.number();
    clumpTime_ = numbers.number();
    wallTime_ = numbers.number();
    arrivals_ = numbers.number();
    departures_ = numbers.number();
    while (!numbers.done())
    {
        const label id = label(numbers.number());
        at_[id] = numbers.number() > 0.5;
    }
}


Foam::dictionary Foam::functionObjects::wallVisits::state() const
{
    DynamicList<scalar> numbers;
    for (const scalar x : {time_, clumpTime_, wallTime_, arrivals_, departures_})
    {
        numbers.append(x);
    }
    for (const auto& clump : at_)
    {
        numbers.append(clump.first);
        numbers.append(clump.second);
    }
    dictionary result;
    setStateList(result, "wall", numbers);
    return result;
}


void Foam::functionObjects::wallVisits::add
(
    const std::map<label, bool>& now,
    const scalar dt
)
{
    time_ += dt;
    clumpTime_ += dt*now.size();
    for (const auto& clump : now)
    {
        const auto before = at_.find(clump.first);
        const bool was = before == at_.end() ? clump.second : before->second;
        arrivals_ += clump.second && !was;
        departures_ += was && !clump.second;
    }
    at_ = now;
    wallTime_ += dt*atWall();
}


Foam::label Foam::functionObjects::wallVisits::atWall() const
{
    label n = 0;
    for (const auto& clump : at_)
    {
        n += clump.second;
    }
    return n;
}


Foam::scalar Foam::functionObjects::wallVisits::share() const
{
    return ratio(atWall(), clumps());
}


Foam::scalar Foam::functionObjects::wallVisits::timeShare() const
{
    return ratio(wallTime_, clumpTime_);
}


Foam::scalar Foam::functionObjects::wallVisits::stay() const
{
    return ratio(wallTime_, departures_);
}


Foam::scalar Foam::functionObjects::wallVisits::flux(const scalar area) const
{
    return ratio(arrivals_ - departures_, area*time_);
}
