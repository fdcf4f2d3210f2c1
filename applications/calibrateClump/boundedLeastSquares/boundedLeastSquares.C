/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "boundedLeastSquares.H"
#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

double sumOfSquares(const Eigen::VectorXd& f)
{
    return f.size() ? f.squaredNorm() : std::numeric_limits<double>::max();
}

}


Foam::boundedLeastSquares::boundedLeastSquares
(
    const function& f,
    const double tolerance,
    const int maxIterations
)
:
    f_(f),
    tolerance_(tolerance),
    maxIterations_(maxIterations)
{}


Eigen::MatrixXd Foam::boundedLeastSquares::jacobian
(
    const Eigen::VectorXd& x,
    const Eigen::VectorXd& fx
) const
{
    // The equilibria are exact to 1e-10
    const double h = 1e-4;
    Eigen::MatrixXd J(Eigen::MatrixXd::Zero(fx.size(), x.size()));

    for (int i = 0; i < x.size(); ++i)
    {
        Eigen::VectorXd plus(x), minus(x);
        plus[i] = std::min(x[i] + h, 1.0);
        minus[i] = std::max(x[i] - h, 0.0);

        Eigen::VectorXd above(f_(plus)), below(f_(minus));
        if (!above.size())
        {
            above = fx;
            plus[i] = x[i];
        }
        if (!below.size())
        {
            below = fx;
            minus[i] = x[i];
        }
        if (plus[i] > minus[i])
        {
            J.col(i) = (above - below)/(plus[i] - minus[i]);
        }
    }
    return J;
}


Eigen::VectorXd Foam::boundedLeastSquares::step
(
    const Eigen::VectorXd& x,
    const Eigen::MatrixXd& A,
    const Eigen::VectorXd& g,
    const double lambda,
    std::vector<bool> held
)
{
    const int n = x.size();
    Eigen::VectorXd d(Eigen::VectorXd::Zero(n));

    for (bool passed = true; passed; )
    {
        // The equation of one that is held becomes d_i = what it has moved
        Eigen::MatrixXd M(A);
        Eigen::VectorXd b(-g);
        for (int i = 0; i < n; ++i)
        {
            if (held[i])
            {
                M.row(i).setZero();
                M(i, i) = 1;
                b[i] = d[i];
            }
            else
            {
                M(i, i) += lambda*A(i, i);
            }
        }
        const Eigen::VectorXd solved(M.colPivHouseholderQr().solve(b));

        passed = false;
        for (int i = 0; i < n; ++i)
        {
            if (!held[i])
            {
                d[i] = std::min(std::max(x[i] + solved[i], 0.0), 1.0) - x[i];
                held[i] = !(x[i] + solved[i] >= 0 && x[i] + solved[i] <= 1);
                passed = passed || held[i];
            }
        }
    }
    return d;
}


double Foam::boundedLeastSquares::minimise(Eigen::VectorXd& x) const
{
    const int n = x.size();
    Eigen::VectorXd f(f_(x));
    double sum = sumOfSquares(f);
    double lambda = 1e-3;

    for (int iteration = 0; f.size() && iteration < maxIterations_; ++iteration)
    {
        const Eigen::MatrixXd J(jacobian(x, f));
        const Eigen::VectorXd g(J.transpose()*f);
        const Eigen::MatrixXd A(J.transpose()*J);

        // A parameter that changes nothing stays where it is
        std::vector<bool> held(n);
        for (int i = 0; i < n; ++i)
        {
            held[i] =
                !(A(i, i) > 0)
             || (x[i] <= 0 && g[i] > 0)
             || (x[i] >= 1 && g[i] < 0);
        }

        bool taken = false;
        double fall = 0;
        while (!taken)
        {
            const Eigen::VectorXd d(step(x, A, g, lambda, held));
            if (d.lpNorm<Eigen::Infinity>() <= tolerance_)
            {
                return sum;
            }

            const double predicted = sum - (f + J*d).squaredNorm();
            const Eigen::VectorXd xNew(x + d);
            const Eigen::VectorXd fNew(f_(xNew));
            const double newSum = sumOfSquares(fNew);
            fall = sum - newSum;

            taken = predicted > 0 && fall > 1e-4*predicted;
            if (taken)
            {
                lambda = std::max(lambda*(fall > 0.5*predicted ? 0.1 : 1), 1e-12);
                x = xNew.cwiseMax(0).cwiseMin(1);
                f = fNew;
                fall /= sum;
                sum = newSum;
            }
            else
            {
                lambda *= 4;
            }
        }

        if (fall <= tolerance_)
        {
            break;
        }
    }
    return sum;
}
