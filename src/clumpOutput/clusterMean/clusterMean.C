/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clusterMean.H"
#include "stateList.H"
#include <limits>

namespace
{

const Foam::scalar undefined = std::numeric_limits<Foam::scalar>::quiet_NaN();

}


Foam::functionObjects::clusterMean::clusterMean(stateReader& state)
:
    clusters_(state.number()),
    n_(state.number()),
    nn_(state.number()),
    sum_(state.threeNumbers()),
    squares_(state.threeNumbers()),
    products_(state.threeNumbers())
{}


void Foam::functionObjects::clusterMean::append(DynamicList<scalar>& state) const
{
    state.append(clusters_);
    state.append(n_);
    state.append(nn_);
    appendTo(state, sum_);
    appendTo(state, squares_);
    appendTo(state, products_);
}


void Foam::functionObjects::clusterMean::add(const scalar n, const vector& sum)
{
    clusters_ += 1;
    n_ += n;
    nn_ += sqr(n);
    sum_ += sum;
    squares_ += cmptMultiply(sum, sum);
    products_ += n*sum;
}


Foam::vector Foam::functionObjects::clusterMean::mean() const
{
    return n_ > 0 ? vector(sum_/n_) : vector::uniform(undefined);
}


Foam::vector Foam::functionObjects::clusterMean::error() const
{
    if (clusters_ < least || n_ <= 0)
    {
        return vector::uniform(undefined);
    }
    const vector M(mean());
    const scalar factor = clusters_/(clusters_ - 1)/sqr(n_);
    vector result;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        // Below zero by rounding only
        const scalar squares =
            squares_[d] - 2*M[d]*products_[d] + sqr(M[d])*nn_;
        result[d] = Foam::sqrt(factor*max(squares, scalar(0)));
    }
    return result;
}
