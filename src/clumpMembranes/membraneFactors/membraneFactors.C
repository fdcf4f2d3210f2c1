/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneFactors.H"
#include <Eigen/LU>

Foam::membraneFactors::membraneFactors(const membraneTangent& tangent)
{
    factors_.analyzePattern(tangent.lower());
}


bool Foam::membraneFactors::factorise(const membraneTangent& tangent)
{
    factors_.factorize(tangent.lower());
    usable_ =
        factors_.info() == Eigen::Success
     && factors_.vectorD().minCoeff() > 0;
    if (!usable_)
    {
        return false;
    }
    products_ = tangent.products();
    solved_.clear();
    for (const membraneProduct& term : products_)
    {
        solved_.push_back(factors_.solve(term.v));
    }
    return true;
}


Eigen::VectorXd Foam::membraneFactors::solve(const Eigen::VectorXd& r) const
{
    Eigen::VectorXd x(factors_.solve(r));
    const label n = products_.size();
    if (n)
    {
        Eigen::MatrixXd small(n, n);
        Eigen::VectorXd right(n);
        for (label a = 0; a < n; ++a)
        {
            const Eigen::VectorXd kv(products_[a].k*products_[a].v);
            right[a] = kv.dot(x);
            for (label b = 0; b < n; ++b)
            {
                small(a, b) = kv.dot(solved_[b]);
            }
            small(a, a) += 1;
        }
        const Eigen::VectorXd y(small.partialPivLu().solve(right));
        for (label a = 0; a < n; ++a)
        {
            x -= y[a]*solved_[a];
        }
    }
    return x;
}
