/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "massDistribution.H"
#include <Eigen/Dense>

namespace
{

using namespace Foam;

typedef Eigen::Matrix<scalar, Eigen::Dynamic, 1> column;
typedef Eigen::Matrix<scalar, 10, 1> condition;
typedef Eigen::Matrix<scalar, 10, Eigen::Dynamic> conditions;
typedef Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic> matrix;

//- Least values, as parts of those to start from
constexpr scalar least = 0.1;

//- Weight of mass and centre against the moments of inertia, where not all can be met
constexpr scalar massWeight = 100;

//- What a condition may be missed by, for a given change: directions in which the spheres
//  hardly differ, as those across a chain that is nearly straight, are not used
constexpr scalar slack = 1e-7;


Eigen::Matrix3d asMatrix(const symmTensor& t)
{
    Eigen::Matrix3d m;
    m << t.xx(), t.xy(), t.xz(), t.xy(), t.yy(), t.yz(), t.xz(), t.yz(), t.zz();
    return m;
}


//- Six components that have the norm of the symmetric matrix
Eigen::Matrix<scalar, 6, 1> components(const Eigen::Matrix3d& m)
{
    const scalar q = Foam::sqrt(2.0);
    Eigen::Matrix<scalar, 6, 1> v;
    v << m(0, 0), m(1, 1), m(2, 2), q*m(0, 1), q*m(0, 2), q*m(1, 2);
    return v;
}


//- The v of least sum (v - v0)^2/(2 D) with A v = b and v >= least v0, by Newton's
//  method for the maximum of the dual function of the multipliers
column leastChange
(
    const conditions& A,
    const condition& b,
    const column& v0,
    const column& D
)
{
    condition multipliers(condition::Zero());
    const column floor(least*v0);
    const auto values = [&](const condition& l) -> column
    {
        return (v0 + D.cwiseProduct(A.transpose()*l)).cwiseMax(floor);
    };
    const auto dual = [&](const condition& l)
    {
        const column v(values(l));
        return
            0.5*(v - v0).cwiseAbs2().cwiseQuotient(D).sum()
          + l.dot(b - A*v) - 0.5*slack*l.squaredNorm();
    };

    for (label n = 0; n < 100; ++n)
    {
        const column v(values(multipliers));
        const condition rest(b - A*v - slack*multipliers);
        const column free
        (
            (v.array() > floor.array()).select(D, column::Zero(D.size()))
        );
        const matrix G(A*free.asDiagonal()*A.transpose());

        // Not along what no masses change, where the multipliers would grow without end
        const Eigen::SelfAdjointEigenSolver<matrix> modes(G);
        condition change(condition::Zero());
        for (label k = 0; k < 10; ++k)
        {
            const scalar g = modes.eigenvalues()[k];
            if (g > 0.01*slack)
            {
                const condition mode(modes.eigenvectors().col(k));
                change += mode.dot(rest)/(g + slack)*mode;
            }
        }
        if (change.norm() < 1e-13)
        {
            break;
        }

        scalar part = 1;
        const scalar before = dual(multipliers);
        while (part > 1e-6 && dual(multipliers + part*change) < before)
        {
            part *= 0.5;
        }
        multipliers += part*change;
    }
    return values(multipliers);
}

}


Foam::massDistribution::massDistribution
(
    const pointField& centres,
    const scalarField& radii,
    const point& centre,
    const symmTensor& inertia,
    const scalar accuracy
)
:
    masses_(pow3(radii)/sum(pow3(radii))),
    inertias_(radii.size()),
    error_(0)
{
    // With lengths over the radius of gyration
    const scalar length = Foam::sqrt(0.5*tr(inertia));
    const label n = radii.size();

    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes
    (
        asMatrix(inertia/sqr(length))
    );
    const Eigen::Matrix3d W(axes.operatorInverseSqrt());

    conditions A(10, n + 1);
    column v0(n + 1);
    column D(n + 1);
    forAll(radii, i)
    {
        const vector r((centres[i] - centre)/length);
        const symmTensor J(magSqr(r)*symmTensor(I) - sqr(r));
        A.col(i) <<
            massWeight, massWeight*r.x(), massWeight*r.y(), massWeight*r.z(),
            components(W*asMatrix(J)*W);
        v0[i] = masses_[i];
        D[i] = masses_[i];
    }
    A.col(n) << Eigen::Matrix<scalar, 4, 1>::Zero(), components(W*W);
    v0[n] = 0.4*sum(masses_*sqr(radii))/sqr(length);
    D[n] = sqr(v0[n]);
    condition b;
    b   << massWeight, 0, 0, 0, components(Eigen::Matrix3d::Identity());

    // What is met already
    const condition start(A*v0);
    for (label k = 0; k < 10; ++k)
    {
        if (mag(b[k] - start[k]) < accuracy*(k < 4 ? massWeight : 1))
        {
            b[k] = start[k];
        }
    }

    const column v(leastChange(A, b, v0, D));
    forAll(masses_, i)
    {
        masses_[i] = v[i];
    }
    masses_ /= sum(masses_);
    inertias_ = masses_*sqr(radii);
    inertias_ *= v[n]*sqr(length)/sum(inertias_);

    // Of the clump, about its own centre
    const point own(sum(masses_*centres));
    symmTensor J(sum(inertias_)*symmTensor(I));
    forAll(centres, i)
    {
        const vector r(centres[i] - own);
        J += masses_[i]*(magSqr(r)*symmTensor(I) - sqr(r));
    }
    const Eigen::Matrix3d off
    (
        W*asMatrix(J/sqr(length))*W - Eigen::Matrix3d::Identity()
    );
    error_ =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>
        (
            off, Eigen::EigenvaluesOnly
        ).eigenvalues().cwiseAbs().maxCoeff();
}
