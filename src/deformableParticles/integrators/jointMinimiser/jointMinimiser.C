/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "jointMinimiser.H"
#include "newtonMinimiser.H"
#include "PstreamReduceOps.H"

namespace
{
    //- Largest displacement, in sphere radii, after which a tangent is still used
    constexpr Foam::scalar sameTangent = 1e-3;

    //- The same, below which the gradient alone decides
    constexpr Foam::scalar close = 1e-6;
}


Foam::jointMinimiser::jointMinimiser
(
    clumpInteraction& group,
    const scalar dt,
    const scalar tolerance,
    const label maxIterations
)
:
    group_(group),
    tolerance_(tolerance),
    maxIterations_(maxIterations),
    potentials_(group.members().size()),
    tangents_(potentials_.size()),
    sums_(Zero),
    contacts_(potentials_.size()),
    sinceThen_(potentials_.size()),
    moved_(potentials_.size(), GREAT),
    nSolves_(0),
    lastStep_(0)
{
    forAll(potentials_, m)
    {
        const clumpInteraction::member& member = group_.members()[m];
        potentials_.set
        (
            m,
            new incrementalPotential
            (
                *member.bonds, *member.ext, dt, *member.start
            )
        );
        potentials_[m].interactWith(group_, m);
        tangents_.set(m, new clumpTangent(member.bonds->pattern()));

        const Eigen::VectorXd none
        (
            Eigen::VectorXd::Zero(6*member.start->x.size())
        );
        for (motions* list : {&g_, &d_, &r_, &z_, &p_, &Kp_})
        {
            list->push_back(none);
        }
    }
}


Foam::scalar Foam::jointMinimiser::dot
(
    const motions& a,
    const motions& b
) const
{
    scalar sum = 0;
    forAll(potentials_, m)
    {
        sum += a[m].dot(b[m]);
    }
    return returnReduce(sum, sumOp<scalar>());
}


void Foam::jointMinimiser::evaluate()
{
    group_.evaluate();

    sums_ = Zero;
    forAll(potentials_, m)
    {
        const scalar W = potentials_[m].value(state(m), &g_[m]);
        sums_ += vector(W, sqr(newtonMinimiser::size(type(m), g_[m])), mag(W));
    }
    reduce(sums_, sumOp<vector>());
}


void Foam::jointMinimiser::updateTangent(const label m)
{
    const symmTensorField contacts(group_.stiffness(m));
    bool stale = moved_[m] > sameTangent;
    if (!stale)
    {
        scalar largest = 0, change = 0;
        forAll(contacts, i)
        {
            largest = max(largest, mag(contacts[i]));
            change = max(change, mag(contacts[i] - contacts_[m][i]));
        }
        // What friction adds for rotations is in the tangent alone
        stale = change > (group_.turns() ? 1e-6 : 0.01)*largest;
    }
    if (stale)
    {
        newtonMinimiser::factorise
        (
            potentials_[m], state(m), 0, true, g_[m], tangents_[m]
        );
        contacts_[m] = contacts;
        moved_[m] = 0;
    }
    sinceThen_[m] = contacts - contacts_[m];
}


bool Foam::jointMinimiser::factorise()
{
    bool any = false;
    forAll(tangents_, m)
    {
        updateTangent(m);
        r_[m] = -g_[m];
        z_[m] = r_[m];
        tangents_[m].solve(z_[m]);

        any = any || newtonMinimiser::largest(type(m), z_[m]) > tolerance_;
        d_[m].setZero();
        p_[m] = z_[m];
        Kp_[m] = r_[m];
    }
    nSolves_ += tangents_.size();
    return returnReduce(any, orOp<bool>());
}


void Foam::jointMinimiser::addSinceThen(const motions& p, motions& Ap) const
{
    forAll(sinceThen_, m)
    {
        forAll(sinceThen_[m], i)
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


void Foam::jointMinimiser::findStep()
{
    // Energy of the step that remains, relative to that of the first: a hundredth of the
    // step, as with a tangent that is kept
    const scalar remains = 1e-4;
    const label maxDirections = 200;

    const scalar first = dot(r_, z_);
    scalar rz = first;
    motions Ap(Kp_);

    for (label n = 0; n < maxDirections; ++n)
    {
        Ap = Kp_;
        group_.couple(p_, Ap);
        addSinceThen(p_, Ap);
        const scalar curvature = dot(p_, Ap);

        if (curvature <= SMALL*rz)
        {
            if (n == 0)
            {
                d_ = p_;
            }
            return;
        }
        const scalar a = rz/curvature;
        forAll(tangents_, m)
        {
            d_[m] += a*p_[m];
            r_[m] -= a*Ap[m];
            z_[m] = r_[m];
            tangents_[m].solve(z_[m]);
        }
        const scalar next = dot(r_, z_);
        if (next <= remains*first)
        {
            return;
        }
        const scalar b = next/rz;
        rz = next;
        forAll(tangents_, m)
        {
            p_[m] = z_[m] + b*p_[m];
            Kp_[m] = r_[m] + b*Kp_[m];
        }
    }
}


void Foam::jointMinimiser::takeStep()
{
    List<clumpState> before(potentials_.size());
    forAll(before, m)
    {
        before[m].x = state(m).x;
        before[m].q = state(m).q;
    }
    const vector sums0(sums_);
    const scalar rounding = 1e-10*sums0.z();
    const scalar slope0 = mag(dot(g_, d_));

    // A contact that begins is not in the tangent: where the step goes too far, the
    // minimum along it lies in the contact
    scalar low = 0;
    scalar high = group_.passable(d_);
    scalar part = high;

    const scalarList movedBefore(moved_);
    for (label attempt = 0; attempt < 60; ++attempt)
    {
        lastStep_ = 0;
        forAll(before, m)
        {
            const scalar moved = newtonMinimiser::moveBy
            (
                type(m), before[m], d_[m], part, state(m)
            );
            moved_[m] = movedBefore[m] + moved;
            lastStep_ = max(lastStep_, moved);
        }
        reduce(lastStep_, maxOp<scalar>());
        evaluate();

        // Close to the minimum the sum changes by rounding and by what its gradient leaves
        // out, while the gradient still falls
        const scalar slope = dot(g_, d_);
        if
        (
            (
                sums_.x() <= sums0.x()
             && (attempt > 30 || mag(slope) < 0.5*slope0)
            )
         || lastStep_ <= tolerance_
         || (
                (sums_.x() <= sums0.x() + rounding || lastStep_ < close)
             && sums_.y() < 0.25*sums0.y()
            )
        )
        {
            return;
        }
        const bool far = slope > 0 || sums_.x() > sums0.x();
        (far ? high : low) = part;
        part = 0.5*(low + high);
    }
}


void Foam::jointMinimiser::predict(const motions& steps)
{
    evaluate();
    const scalar before = sums_.x();
    const scalar part = group_.passable(steps);

    const auto start = [&](const scalar fraction)
    {
        forAll(potentials_, m)
        {
            const clumpInteraction::member& member = group_.members()[m];
            if (!member.guessed)
            {
                newtonMinimiser::moveBy
                (
                    type(m), *member.start, steps[m], fraction, *member.end
                );
            }
        }
    };
    start(part);
    evaluate();
    if (sums_.x() > before)
    {
        start(0);
    }
}


bool Foam::jointMinimiser::minimise()
{
    evaluate();
    for (label n = 0; n < maxIterations_; ++n)
    {
        if (!factorise())
        {
            return true;
        }
        findStep();
        takeStep();
        if (lastStep_ <= tolerance_)
        {
            return true;
        }
    }
    return false;
}
