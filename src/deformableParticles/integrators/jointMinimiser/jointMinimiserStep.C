/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "jointMinimiser.H"
#include "foamCompat.H"
#include "newtonMinimiser.H"
#include "PstreamReduceOps.H"
#include <Eigen/Eigenvalues>

namespace
{
    //- Residual of the step, relative to that of none: as with a tangent that is kept
    constexpr Foam::scalar remains = 0.01;

    //- (r, z) [J] beyond which numbers may overflow
    constexpr Foam::scalar hopeless = 1e100;

    //- Largest eigenvalue of K^-1 (K - C), with a margin for kept tangents
    constexpr Foam::scalar largestEigenvalue = 2.05;

    //- Smallest one for which Chebyshev's iteration takes less than 200 steps
    constexpr Foam::scalar smallestEigenvalue = 4e-4;
}


void Foam::jointMinimiser::multiply
(
    const motions& p,
    const motions& Kp,
    motions& Ap
) const
{
    Ap = Kp;
    group_.couple(p, Ap);
    forAll(sinceThen_, m)
    {
        const label n = p[m].isZero(0) ? 0 : sinceThen_[m].size();
        for (label i = 0; i < n; ++i)
        {
            const auto move = p[m].segment<3>(6*i);
            const vector force
            (
                sinceThen_[m][i] & vector(move.x(), move.y(), move.z())
            );
            Ap[m].segment<3>(6*i) +=
                Eigen::Vector3d(force.x(), force.y(), force.z());
        }
    }
}


Foam::vector2D Foam::jointMinimiser::products(const motions& Az) const
{
    vector2D result(Zero);
    forAll(potentials_, m)
    {
        result += vector2D(r_[m].dot(z_[m]), Az[m].dot(z_[m]));
    }
    reduce(result, sumOp<vector2D>());
    return result;
}


void Foam::jointMinimiser::conjugateGradients()
{
    const label most = 200;

    motions Az(r_);
    multiply(z_, r_, Az);
    vector2D now(products(Az));
    const scalar first = now.x();

    // Of the tridiagonal matrix with the eigenvalues
    DynamicList<scalar> diagonal, beside;
    scalar a = 0, b = 0;

    for (label n = 0; n < most; ++n)
    {
        const scalar before = n ? b/a : 0;
        const scalar curvature = now.y() - before*now.x();
        if (curvature <= SMALL*now.x())
        {
            if (n == 0)
            {
                d_ = z_;
            }
            group_.leastEigenvalue = 0;
            return;
        }
        beside.append(n ? Foam::sqrt(b)/a : 0);
        a = now.x()/curvature;
        diagonal.append(1/a + before);

        forAll(potentials_, m)
        {
            p_[m] = z_[m] + b*p_[m];
            Ap_[m] = Az[m] + b*Ap_[m];
            d_[m] += a*p_[m];
            r_[m] -= a*Ap_[m];
            z_[m] = r_[m];
            tangent(m).solve(z_[m]);
        }
        multiply(z_, r_, Az);
        const vector2D next(products(Az));
        b = next.x()/now.x();
        now = next;
        if (now.x() <= sqr(remains)*first)
        {
            break;
        }
    }

    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigenvalues;
    const label n = diagonal.size();
    eigenvalues.computeFromTridiagonal
    (
        Eigen::Map<const Eigen::VectorXd>(diagonal.cdata(), n),
        Eigen::Map<const Eigen::VectorXd>(beside.cdata() + 1, n - 1),
        Eigen::EigenvaluesOnly
    );
    group_.leastEigenvalue = eigenvalues.eigenvalues().minCoeff();
}


bool Foam::jointMinimiser::chebyshev(const scalar least)
{
    const scalar middle = 0.5*(largestEigenvalue + least);
    const scalar half = 0.5*(largestEigenvalue - least);
    const scalar ratio = middle/half;
    const label number = label(std::acosh(1/remains)/std::acosh(ratio)) + 1;

    scalar rho = 1/ratio;
    boolList moves(potentials_.size());
    forAll(potentials_, m)
    {
        moves[m] = !rests(ownSizes_[m]);
        p_[m] = moves[m]/middle*z_[m];
        Kp_[m] = moves[m]/middle*r_[m];
    }
    bool usable = true;
    for (label n = 0; n < number; ++n)
    {
        multiply(p_, Kp_, Ap_);
        const scalar next = 1/(2*ratio - rho);
        scalar size = 0;
        forAll(potentials_, m)
        {
            if (!moves[m] && Ap_[m].isZero(0))
            {
                continue;
            }
            d_[m] += p_[m];
            r_[m] -= Ap_[m];
            z_[m] = r_[m];
            tangent(m).solve(z_[m]);
            if (!moves[m] && rests(newtonMinimiser::largest(type(m), z_[m])))
            {
                continue;
            }
            moves[m] = true;
            size += r_[m].dot(z_[m]);
            p_[m] = rho*next*p_[m] + 2*next/half*z_[m];
            Kp_[m] = rho*next*Kp_[m] + 2*next/half*r_[m];
        }
        rho = next;

        // With negative eigenvalues it grows. The other processors go on
        if (size > hopeless)
        {
            usable = false;
            for (motions* list : {&r_, &z_, &p_, &Kp_})
            {
                for (Eigen::VectorXd& v : *list)
                {
                    v.setZero();
                }
            }
        }
    }
    return usable;
}


bool Foam::jointMinimiser::findStep(const bool mayChebyshev)
{
    for (Eigen::VectorXd& d : d_)
    {
        d.setZero();
    }
    const scalar least = 0.8*group_.leastEigenvalue;
    const bool byChebyshev =
        mayChebyshev && least > smallestEigenvalue && least < largestEigenvalue;
    here_[atEnd] = 0;
    if (!byChebyshev)
    {
        conjugateGradients();
    }
    else if (!chebyshev(least))
    {
        here_[atEnd] = GREAT;
    }

    here_[slopeBefore] = 0;
    forAll(potentials_, m)
    {
        if (!rests(ownSizes_[m]))
        {
            here_[atEnd] += r_[m].dot(z_[m]);
        }
        here_[slopeBefore] += g_[m].dot(d_[m]);
    }
    here_[passable] = -group_.passable(d_);

    // One that is of no use to any processor, or too long for one
    here_[untried] =
        here_[passable] > -1 || (byChebyshev && here_[atEnd] > enough*sums_[atStart]);
    return byChebyshev;
}
