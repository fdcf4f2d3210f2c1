/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "lagDispersion.H"
#include "stateList.H"
#include <cmath>
#include <limits>

Foam::functionObjects::lagDispersion::lagDispersion
(
    const dictionary& state,
    const scalarMinMax& range
)
:
    lag_(stateReader(state, "lag").number()),
    range_(range)
{
    stateReader sums(state, "sums");
    ended_ = clusterMean(sums);
    blocks_ = clusterMean(sums);
    way_ = sums.threeNumbers();
    while (!sums.done())
    {
        block& b = open_[sums.number()];
        b.n = sums.number();
        b.squares = sums.threeNumbers();
    }

    stateReader paths(state, "paths");
    while (!paths.done())
    {
        path& p = paths_[label(paths.number())];
        p.last = paths.number();
        p.n = paths.number();
        p.squares = paths.threeNumbers();
        p.places.resize(label(paths.number()));
        for (vector& x : p.places)
        {
            x = paths.threeNumbers();
        }
    }
}


Foam::dictionary Foam::functionObjects::lagDispersion::state() const
{
    DynamicList<scalar> sums;
    ended_.append(sums);
    blocks_.append(sums);
    appendTo(sums, way_);
    for (const auto& b : open_)
    {
        sums.append(b.first);
        sums.append(b.second.n);
        appendTo(sums, b.second.squares);
    }

    DynamicList<scalar> paths;
    for (const auto& entry : paths_)
    {
        const path& p = entry.second;
        paths.append(entry.first);
        paths.append(p.last);
        paths.append(p.n);
        appendTo(paths, p.squares);
        paths.append(p.places.size());
        for (const vector& x : p.places)
        {
            appendTo(paths, x);
        }
    }

    dictionary result;
    setStateList(result, "lag", scalarList(1, lag_));
    setStateList(result, "sums", sums);
    setStateList(result, "paths", paths);
    return result;
}


Foam::scalar Foam::functionObjects::lagDispersion::number(const scalar t) const
{
    // The sum of many steps differs from a multiple by rounding
    return std::floor(m*t/lag_ + 1e-6);
}


void Foam::functionObjects::lagDispersion::add
(
    path& p,
    const scalar number,
    const vector& x
)
{
    if (p.places.size() && number != p.last + 1)
    {
        p.places.clear();
    }
    if (p.places.size() > m)
    {
        for (label i = 0; i < m; ++i)
        {
            p.places[i] = p.places[i + 1];
        }
        p.places.resize(m);
    }
    p.places.append(x);
    p.last = number;
    if (p.places.size() > m && range_.contains(p.places[0].x()))
    {
        const vector d(x - p.places[0]);
        const vector squares(cmptMultiply(d, d));
        p.n += 1;
        p.squares += squares;
        way_ += d;
        block& b = open_[std::floor((number - 1)/(m*m))];
        b.n += 1;
        b.squares += squares;
    }
}


void Foam::functionObjects::lagDispersion::begin
(
    const label id,
    const scalar t,
    const vector& x
)
{
    path& p = paths_[id];
    const scalar k = number(t);
    if (k > std::floor(m*t/lag_ - 1e-6))
    {
        add(p, k, x);
    }
}


void Foam::functionObjects::lagDispersion::follow
(
    const label id,
    const scalar t0,
    const vector& x0,
    const scalar t1,
    const vector& x1
)
{
    path& p = paths_[id];
    const scalar last = number(t1);
    for (scalar k = number(t0) + 1; k <= last; k += 1)
    {
        const scalar f = min(max((k*lag_/m - t0)/(t1 - t0), scalar(0)), scalar(1));
        add(p, k, f > 1 - 1e-6 ? x1 : vector(x0 + f*(x1 - x0)));
    }
}


void Foam::functionObjects::lagDispersion::end(const label id)
{
    const auto p = paths_.find(id);
    if (p == paths_.end())
    {
        return;
    }
    if (p->second.n > 0)
    {
        ended_.add(p->second.n, p->second.squares);
    }
    paths_.erase(p);
}


void Foam::functionObjects::lagDispersion::endAll()
{
    while (!paths_.empty())
    {
        end(paths_.begin()->first);
    }
}


void Foam::functionObjects::lagDispersion::reach(const scalar t)
{
    // The block of the next place is the first one that can grow
    const scalar next = std::floor(number(t)/(m*m));
    while (!open_.empty() && open_.begin()->first < next)
    {
        const block& b = open_.begin()->second;
        blocks_.add(b.n, b.squares);
        open_.erase(open_.begin());
    }
}


Foam::functionObjects::clusterMean
Foam::functionObjects::lagDispersion::clumps() const
{
    clusterMean result(ended_);
    for (const auto& p : paths_)
    {
        if (p.second.n > 0)
        {
            result.add(p.second.n, p.second.squares);
        }
    }
    return result;
}


Foam::vector Foam::functionObjects::lagDispersion::mean() const
{
    const scalar count = n();
    return
        count > 0
      ? vector(way_/count)
      : vector::uniform(std::numeric_limits<scalar>::quiet_NaN());
}


Foam::vector Foam::functionObjects::lagDispersion::error() const
{
    const vector ofPaths(clumps().error());
    const vector ofBlocks(blocks_.error()/Foam::sqrt(1 - 0.25/m));

    // One of them may be nan
    vector result;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        result[d] = std::fmax(ofPaths[d], ofBlocks[d]);
    }
    return result;
}
