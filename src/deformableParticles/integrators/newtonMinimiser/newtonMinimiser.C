/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "newtonMinimiser.H"
#include "foamCompat.H"

Foam::scalar Foam::newtonMinimiser::largest
(
    const clumpType& type,
    const Eigen::VectorXd& step
)
{
    scalar result = 0;
    for (label i = 0; i < type.size(); ++i)
    {
        result = max
        (
            result,
            max
            (
                step.segment<3>(6*i).norm()/type.radii()[i],
                step.segment<3>(6*i + 3).norm()
            )
        );
    }
    return result;
}


Foam::scalar Foam::newtonMinimiser::moveBy
(
    const clumpType& type,
    const clumpState& before,
    const Eigen::VectorXd& step,
    const scalar fraction,
    clumpState& s
)
{
    scalar moved = 0;
    forAll(s.x, i)
    {
        const vector dx(step[6*i], step[6*i + 1], step[6*i + 2]);
        const vector dq(step[6*i + 3], step[6*i + 4], step[6*i + 5]);

        s.x[i] = before.x[i] + fraction*dx;
        s.q[i] = rotation(fraction*dq)*before.q[i];
        normalise(s.q[i]);

        moved = max(moved, fraction*max(mag(dx)/type.radii()[i], mag(dq)));
    }
    return moved;
}


Foam::scalar Foam::newtonMinimiser::size
(
    const clumpType& type,
    const Eigen::VectorXd& gradient
)
{
    scalar sum = 0;
    for (label i = 0; i < type.size(); ++i)
    {
        sum +=
            gradient.segment<3>(6*i).squaredNorm()
          + gradient.segment<3>(6*i + 3).squaredNorm()/sqr(type.radii()[i]);
    }
    return Foam::sqrt(sum);
}


Foam::newtonMinimiser::newtonMinimiser
(
    const scalar tolerance,
    const label maxIterations
)
:
    tolerance_(tolerance),
    maxIterations_(maxIterations),
    nIterations_(0),
    nFactorisations_(0),
    lastStep_(0)
{}


Foam::label Foam::newtonMinimiser::factorise
(
    const incrementalPotential& potential,
    const clumpState& s,
    const scalar shift,
    const bool early,
    Eigen::VectorXd& gradient,
    clumpTangent& K
)
{
    const scalar r2 = sqr(max(potential.type().radii()));

    label nFactorisations = 1;
    potential.value(s, &gradient, &K);
    if (K.factorise(shift, shift*r2))
    {
        return nFactorisations;
    }

    // With inertia the material part is positive definite; it converges slowly
    // where the geometric part matters. In an equilibrium it is only positive
    // semidefinite, since the clump may move rigidly.
    if (potential.moving() && early)
    {
        potential.value(s, &gradient, &K, false);
    }

    scalar largest = 0;
    for (label i = 0; i < K.size(); ++i)
    {
        largest = max(largest, K.diagonal(i)(0, 0));
    }

    scalar added = shift;
    while (!K.factorise(added, added*r2))
    {
        ++nFactorisations;
        added = max(4*added, 1e-6*largest + VSMALL);
    }
    return nFactorisations;
}


bool Foam::newtonMinimiser::minimise
(
    const incrementalPotential& potential,
    clumpState& s,
    const scalar shift
)
{
    const label n = 6*s.x.size();
    Eigen::VectorXd gradient(n), step(n);
    clumpTangent K(potential.bonds().pattern());
    clumpState before(s);

    scalar W = potential.value(s, &gradient);
    bool fresh = false;
    bool stale = true;
    lastStep_ = GREAT;
    nFactorisations_ = 0;

    for (nIterations_ = 0; nIterations_ < maxIterations_; ++nIterations_)
    {
        if (stale)
        {
            nFactorisations_ += factorise
            (
                potential, s, shift, nIterations_ < 10, gradient, K
            );
            fresh = true;
        }

        step = -gradient;
        K.solve(step);

        const scalar force = size(potential.type(), gradient);
        before.x = s.x;
        before.q = s.q;
        const scalar before0 = W;
        scalar fraction = 1;
        scalar moved = GREAT;

        while (true)
        {
            moved = moveBy(potential.type(), before, step, fraction, s);
            W = potential.value(s, &gradient);

            // Close to the minimum the potential no longer changes within rounding
            // while its gradient still does
            if
            (
                W <= before0
             || moved <= tolerance_
             || (moved < 1e-3 && size(potential.type(), gradient) < force)
            )
            {
                break;
            }
            fraction *= 0.5;
        }

        if (moved <= tolerance_)
        {
            lastStep_ = moved;
            return true;
        }

        stale = fraction < 1 || moved > 0.1*lastStep_ || (fresh && moved > 0.1);
        fresh = false;
        lastStep_ = moved;
    }

    return false;
}
