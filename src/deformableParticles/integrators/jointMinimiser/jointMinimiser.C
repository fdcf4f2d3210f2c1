/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "jointMinimiser.H"
#include "foamCompat.H"
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
    sums_(scalar(0)),
    found_(scalar(0)),
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
        for (motions* list : {&g_, &d_, &r_, &z_, &p_, &Kp_, &Ap_})
        {
            list->push_back(none);
        }
    }
}


void Foam::jointMinimiser::evaluate()
{
    group_.evaluate();

    sums_ = scalar(0);
    forAll(potentials_, m)
    {
        const scalar W = potentials_[m].value(state(m), &g_[m]);
        sums_[ofPotentials] += W;
        sums_[ofMagnitudes] += mag(W);
        sums_[ofGradients] += sqr(newtonMinimiser::size(type(m), g_[m]));
        sums_[slope] += g_[m].dot(d_[m]);
    }
    sums_[largest] = lastStep_;
    reduceWhole(sums_, sumsAndLargest());
    lastStep_ = sums_[largest];
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


bool Foam::jointMinimiser::converged() const
{
    scalar own = 0;
    forAll(z_, m)
    {
        own = max(own, newtonMinimiser::largest(type(m), z_[m]));
    }
    return returnReduce(-own, minOp<scalar>()) >= -tolerance_;
}


void Foam::jointMinimiser::takeStep()
{
    List<clumpState> before(potentials_.size());
    forAll(before, m)
    {
        before[m].x = state(m).x;
        before[m].q = state(m).q;
    }
    const together sums0(sums_);
    const scalar rounding = 1e-10*sums0[ofMagnitudes];
    const scalar slope0 = mag(found_[slope]);

    // A contact that begins is not in the tangent: where the step goes too far, the
    // minimum along it lies in the contact
    scalar low = 0;
    scalar high = -found_[largest];
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
        evaluate();

        // Close to the minimum the sum changes by rounding and by what its gradient leaves
        // out, while the gradient still falls
        const scalar change = sums_[ofPotentials] - sums0[ofPotentials];
        if
        (
            (
                change <= 0
             && (attempt > 30 || mag(sums_[slope]) < 0.5*slope0)
            )
         || lastStep_ <= tolerance_
         || (
                (change <= rounding || lastStep_ < close)
             && sums_[ofGradients] < 0.25*sums0[ofGradients]
            )
        )
        {
            return;
        }
        const bool far = sums_[slope] > 0 || change > 0;
        (far ? high : low) = part;
        part = 0.5*(low + high);
    }
}


void Foam::jointMinimiser::predict(const motions& steps)
{
    evaluate();
    const scalar before = sums_[ofPotentials];
    const scalar part = returnReduce(group_.passable(steps), minOp<scalar>());

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
    if (sums_[ofPotentials] > before)
    {
        start(0);
    }
}


bool Foam::jointMinimiser::minimise()
{
    evaluate();
    for (label n = 0; n < maxIterations_; ++n)
    {
        forAll(tangents_, m)
        {
            updateTangent(m);
        }
        nSolves_ += tangents_.size();
        beginStep();

        // After a longer step there is always another one
        const bool near = n == 0 || lastStep_ < 1000*tolerance_;
        if (near && converged())
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
