/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpTangent.H"

namespace
{

typedef Foam::clumpTangent::block block;

//- Cholesky factor of a block in place, below the diagonal; on the diagonal its
//  inverse. False when not positive definite.
inline bool cholesky(block& A)
{
    for (int j = 0; j < 6; ++j)
    {
        double d = A(j, j);
        for (int k = 0; k < j; ++k)
        {
            d -= A(j, k)*A(j, k);
        }
        if (!(d > 0))
        {
            return false;
        }
        const double oneBy = 1/std::sqrt(d);
        A(j, j) = oneBy;
        for (int i = j + 1; i < 6; ++i)
        {
            double a = A(i, j);
            for (int k = 0; k < j; ++k)
            {
                a -= A(i, k)*A(j, k);
            }
            A(i, j) = a*oneBy;
        }
    }
    return true;
}


//- A L^-T, in place
inline void divideByTransposed(const block& L, block& A)
{
    for (int j = 0; j < 6; ++j)
    {
        for (int k = 0; k < j; ++k)
        {
            A.col(j) -= L(j, k)*A.col(k);
        }
        A.col(j) *= L(j, j);
    }
}


//- L^-1 x and L^-T x, in place
inline void forward(const block& L, double* x)
{
    for (int j = 0; j < 6; ++j)
    {
        x[j] *= L(j, j);
        for (int i = j + 1; i < 6; ++i)
        {
            x[i] -= L(i, j)*x[j];
        }
    }
}


inline void backward(const block& L, double* x)
{
    for (int j = 5; j >= 0; --j)
    {
        for (int i = j + 1; i < 6; ++i)
        {
            x[j] -= L(i, j)*x[i];
        }
        x[j] *= L(j, j);
    }
}

}


Foam::clumpTangent::clumpTangent(const sparsityPattern& pattern)
:
    pattern_(pattern),
    values_(pattern_.nBlocks()),
    factor_(pattern_.nBlocks())
{}


void Foam::clumpTangent::setZero()
{
    for (block& b : values_)
    {
        b.setZero();
    }
    rankOnes_.clear();
    translates_ = false;
}


void Foam::clumpTangent::addCoupling
(
    const label bondi,
    const label i,
    const label j,
    const block& B
)
{
    if (i > j)
    {
        values_[pattern_.pairBlock(bondi)] += B;
    }
    else
    {
        values_[pattern_.pairBlock(bondi)] += B.transpose();
    }
}


void Foam::clumpTangent::addRankOne(const scalar k, const Eigen::VectorXd& g)
{
    rankOnes_.push_back({false, k, g, g});
}


void Foam::clumpTangent::addConstraint(const Eigen::VectorXd& g)
{
    rankOnes_.push_back({true, 0, g, g});
}


bool Foam::clumpTangent::factoriseSum(const scalar shift)
{
    // Pairs are stored once
    Eigen::Matrix3d sum(Eigen::Matrix3d::Zero());
    for (label j = 0; j < size(); ++j)
    {
        for (label a = pattern_.start(j); a < pattern_.start(j + 1); ++a)
        {
            const Eigen::Matrix3d K(values_[a].topLeftCorner<3, 3>());
            sum += K;
            if (pattern_.row(a) != j)
            {
                sum += K.transpose();
            }
        }
    }
    sum.diagonal().array() += size()*shift;

    const Eigen::Matrix3d free(Eigen::Matrix3d::Identity() - held_);
    const scalar scale = max(sum.trace(), VSMALL);
    const Eigen::LLT<Eigen::Matrix3d> factor(free*sum*free + scale*held_);
    inverse_ = free*factor.solve(free);
    return factor.info() == Eigen::Success;
}


bool Foam::clumpTangent::factorise
(
    const scalar shift,
    const scalar rotationShift
)
{
    if (translates_)
    {
        return factoriseSum(shift);
    }
    factor_ = values_;
    const labelList& targets = pattern_.targets();
    label next = 0;

    for (label j = 0; j < size(); ++j)
    {
        block& D = factor_[pattern_.start(j)];
        if (shift > 0)
        {
            D.diagonal().head<3>().array() += shift;
            D.diagonal().tail<3>().array() += rotationShift;
        }

        if (!cholesky(D))
        {
            return false;
        }

        for (label a = pattern_.start(j) + 1; a < pattern_.start(j + 1); ++a)
        {
            divideByTransposed(D, factor_[a]);
        }
        for (label b = pattern_.start(j) + 1; b < pattern_.start(j + 1); ++b)
        {
            for (label a = b; a < pattern_.start(j + 1); ++a)
            {
                factor_[targets[next++]].noalias() -=
                    factor_[a].lazyProduct(factor_[b].transpose());
            }
        }
    }

    for (std::size_t m = 0; m < rankOnes_.size(); ++m)
    {
        rankOne& term = rankOnes_[m];
        term.Ag = term.g;
        substitute(term.Ag);
        correct(term.Ag, m);
    }

    return true;
}


void Foam::clumpTangent::substitute(Eigen::VectorXd& x) const
{
    for (label j = 0; j < size(); ++j)
    {
        auto xj = x.segment<6>(6*j);
        forward(factor_[pattern_.start(j)], &x[6*j]);
        for (label a = pattern_.start(j) + 1; a < pattern_.start(j + 1); ++a)
        {
            x.segment<6>(6*pattern_.row(a)).noalias() -= factor_[a]*xj;
        }
    }
    for (label j = size() - 1; j >= 0; --j)
    {
        auto xj = x.segment<6>(6*j);
        for (label a = pattern_.start(j) + 1; a < pattern_.start(j + 1); ++a)
        {
            xj.noalias() -= factor_[a].transpose()*x.segment<6>(6*pattern_.row(a));
        }
        backward(factor_[pattern_.start(j)], &x[6*j]);
    }
}


void Foam::clumpTangent::solve(Eigen::VectorXd& x) const
{
    if (translates_)
    {
        Eigen::Vector3d sum(Eigen::Vector3d::Zero());
        for (label i = 0; i < size(); ++i)
        {
            sum += x.segment<3>(6*i);
        }
        const Eigen::Vector3d d(inverse_*sum);
        x.setZero();
        for (label i = 0; i < size(); ++i)
        {
            x.segment<3>(6*i) = d;
        }
        return;
    }
    substitute(x);

    correct(x, rankOnes_.size());
}


void Foam::clumpTangent::correct
(
    Eigen::VectorXd& x,
    const std::size_t n
) const
{
    for (std::size_t m = 0; m < n; ++m)
    {
        const rankOne& term = rankOnes_[m];
        const scalar gx = term.g.dot(x);
        const scalar gAg = term.g.dot(term.Ag);
        x -= term.Ag*(term.constrains ? gx/gAg : term.k*gx/(1 + term.k*gAg));
    }
}


Eigen::MatrixXd Foam::clumpTangent::dense() const
{
    Eigen::MatrixXd K(Eigen::MatrixXd::Zero(6*size(), 6*size()));

    for (label j = 0; j < size(); ++j)
    {
        for (label a = pattern_.start(j); a < pattern_.start(j + 1); ++a)
        {
            const label i = pattern_.row(a);
            K.block<6, 6>(6*j, 6*i) = values_[a].transpose();
            K.block<6, 6>(6*i, 6*j) = values_[a];
        }
    }
    for (const rankOne& term : rankOnes_)
    {
        K.noalias() += term.k*term.g*term.g.transpose();
    }
    return K;
}
