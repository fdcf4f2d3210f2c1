/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pathWindow.H"
#include "SubList.H"
#include <limits>

Foam::functionObjects::pathWindow::pathWindow(const UList<vector>& state)
:
    begin_(state[0]),
    points_(SubList<vector>(state, state.size() - 1, 1))
{}


Foam::List<Foam::vector> Foam::functionObjects::pathWindow::state() const
{
    List<vector> result(1, begin_);
    result.append(points_);
    return result;
}


void Foam::functionObjects::pathWindow::add
(
    const vector& point,
    const scalar window
)
{
    if (points_.empty())
    {
        begin_ = point;
    }

    // The last point is always that of the last time; it is replaced where it is too
    // close to the one before
    const label n = points_.size();
    const scalar spacing = (1 - 1e-6)*window/nPoints;
    const bool again = n > 0 && point.x() <= points_[n - 1].x();
    if (again || (n > 1 && points_[n - 1].x() - points_[n - 2].x() < spacing))
    {
        points_.last() = point;
    }
    else
    {
        points_.append(point);
    }

    const scalar from = point.x() - (1 + 1e-6)*window;
    label first = 0;
    while (first < points_.size() - 2 && points_[first].x() < from)
    {
        ++first;
    }
    if (first)
    {
        points_ = List<vector>
        (
            SubList<vector>(points_, points_.size() - first, first)
        );
    }
}


bool Foam::functionObjects::pathWindow::full(const scalar window) const
{
    // Less the distance of two points, as those before the window are left out
    return last().x() - points_[0].x() > (1 - 2.0/nPoints)*window
        || last().x() - begin_.x() > (1 + 2.0/nPoints)*window;
}


Foam::scalar Foam::functionObjects::pathWindow::inclination
(
    const scalar way
) const
{
    label k = points_.size() - 1;
    while (k > 0 && mag(last().y() - points_[k].y()) < way)
    {
        --k;
    }
    const vector d(last() - points_[k]);
    return
        mag(d.y()) > VSMALL
      ? d.z()/d.y() : std::numeric_limits<scalar>::quiet_NaN();
}


Foam::scalar Foam::functionObjects::pathWindow::slope
(
    const direction component
) const
{
    const label n = points_.size();
    if (n < 2)
    {
        return std::numeric_limits<scalar>::quiet_NaN();
    }
    const vector mean(sum(points_)/n);
    scalar products = 0;
    scalar squares = 0;
    for (const vector& point : points_)
    {
        const scalar t = point.x() - mean.x();
        products += t*(point[component] - mean[component]);
        squares += sqr(t);
    }
    return products/squares;
}
