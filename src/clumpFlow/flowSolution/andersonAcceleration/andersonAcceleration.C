/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "andersonAcceleration.H"
#include "foamCompat.H"
#include <Eigen/Cholesky>

Foam::andersonAcceleration::andersonAcceleration(const label depth)
:
    depth_(depth),
    first_(true)
{}


void Foam::andersonAcceleration::clear()
{
    dX_.clear();
    dR_.clear();
    x_.clear();
    r_.clear();
    first_ = true;
}


void Foam::andersonAcceleration::remember
(
    const scalarField& x,
    const scalarField& r
)
{
    if (!first_)
    {
        if (dX_.size() == depth_)
        {
            for (label i = 1; i < depth_; ++i)
            {
                dX_[i - 1].transfer(dX_[i]);
                dR_[i - 1].transfer(dR_[i]);
            }
            dX_.setSize(depth_ - 1);
            dR_.setSize(depth_ - 1);
        }
        dX_.append(scalarField(x - x_));
        dR_.append(scalarField(r - r_));
    }
    x_ = x;
    r_ = r;
    first_ = false;
}


Foam::scalarField Foam::andersonAcceleration::correction
(
    const scalarField& x,
    const scalarField& r
)
{
    scalarField result(x.size(), Zero);
    if (depth_ == 0)
    {
        return result;
    }
    remember(x, r);
    const label n = dR_.size();
    if (n == 0)
    {
        return result;
    }

    // All products in one collective operation
    List<scalar> products;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j <= i; ++j)
        {
            products.append(sumProd(dR_[i], dR_[j]));
        }
        products.append(sumProd(dR_[i], r));
    }
    reduceList(products, plusEqOp<scalar>());

    Eigen::MatrixXd A(n, n);
    Eigen::VectorXd b(n);
    const scalar* product = products.cdata();
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j <= i; ++j)
        {
            A(i, j) = A(j, i) = *product++;
        }
        b(i) = *product++;

        // Differences may be parallel
        A(i, i) *= 1 + 1e-6;
    }
    const Eigen::VectorXd g(A.ldlt().solve(b));
    if (g.allFinite())
    {
        for (label i = 0; i < n; ++i)
        {
            result -= g[i]*(dX_[i] + dR_[i]);
        }
    }
    return result;
}
