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
    potentials_(group.coupledClumps().size()),
    tangents_(2*potentials_.size()),
    used_(potentials_.size(), Zero),
    here_(scalar(0)),
    sums_(scalar(0)),
    values_(potentials_.size(), Zero),
    hasMoved_(potentials_.size(), true),
    nRenewed_(potentials_.size(), -1),
    isOld_(potentials_.size(), true),
    ownSizes_(potentials_.size(), Zero),
    contacts_(tangents_.size()),
    sinceThen_(potentials_.size()),
    moved_(potentials_.size(), GREAT),
    nSolves_(0),
    lastStep_(0)
{
    forAll(potentials_, m)
    {
        const clumpInteraction::coupledClump& clump = group_.coupledClumps()[m];
        potentials_.set
        (
            m,
            new incrementalPotential
            (
                *clump.bonds, *clump.ext, dt, *clump.start
            )
        );
        potentials_[m].interactWith(group_, m);
        for (const label k : {0, 1})
        {
            tangents_.set(2*m + k, new clumpTangent(clump.bonds->pattern()));
        }

        const Eigen::VectorXd none
        (
            Eigen::VectorXd::Zero(6*clump.start->x.size())
        );
        for (motions* list : {&g_, &own_, &d_, &r_, &z_, &p_, &Kp_, &Ap_})
        {
            list->push_back(none);
        }
    }
}


void Foam::jointMinimiser::evaluate()
{
    group_.evaluate();
    here_[lacking] = group_.incomplete();

    for (const label i : {potentialSum, magnitudeSum, gradientSum, slope})
    {
        here_[i] = 0;
    }
    forAll(potentials_, m)
    {
        if (hasMoved_[m] || nRenewed_[m] != group_.nRenewed(m))
        {
            values_[m] = potentials_[m].value(state(m), &g_[m]);
            hasMoved_[m] = false;
            nRenewed_[m] = group_.nRenewed(m);
            isOld_[m] = true;
        }
        here_[potentialSum] += values_[m];
        here_[magnitudeSum] += mag(values_[m]);
        here_[gradientSum] += sqr(newtonMinimiser::size(type(m), g_[m]));
        here_[slope] += g_[m].dot(d_[m]);
    }
}


void Foam::jointMinimiser::updateTangent(const label m)
{
    const symmTensorField contacts(group_.stiffness(m));
    // What friction adds for rotations is in the tangent alone
    bool stale = group_.turns() || moved_[m] > sameTangent;
    if (!stale)
    {
        scalar largest = 0, change = 0;
        forAll(contacts, i)
        {
            largest = max(largest, mag(contacts[i]));
            change = max(change, mag(contacts[i] - contacts_[2*m + used_[m]][i]));
        }
        stale = change > 0.01*largest;
    }
    if (stale)
    {
        used_[m] = 1 - used_[m];
        newtonMinimiser::factorise
        (
            potentials_[m], state(m), 0, true, g_[m], tangent(m)
        );
        contacts_[2*m + used_[m]] = contacts;
        moved_[m] = 0;
    }
    sinceThen_[m] = contacts - contacts_[2*m + used_[m]];
}


void Foam::jointMinimiser::prepare()
{
    here_[ownPart] = 0;
    here_[atStart] = 0;
    forAll(potentials_, m)
    {
        r_[m] = -g_[m];
        if (isOld_[m])
        {
            updateTangent(m);
            own_[m] = r_[m];
            tangent(m).solve(own_[m]);
            ownSizes_[m] = newtonMinimiser::largest(type(m), own_[m]);
            isOld_[m] = false;
        }
        z_[m] = own_[m];
        here_[ownPart] = max(here_[ownPart], ownSizes_[m]);
        if (!rests(ownSizes_[m]))
        {
            here_[atStart] += r_[m].dot(z_[m]);
        }
    }
}


void Foam::jointMinimiser::exchange()
{
    sums_ = here_;
    reduceWhole(sums_, sumsAndMaxima());
    lastStep_ = sums_[displaced];
}


void Foam::jointMinimiser::begin()
{
    evaluate();
    prepare();
    exchange();
}


bool Foam::jointMinimiser::takeStep()
{
    List<clumpState> before(potentials_.size());
    forAll(before, m)
    {
        before[m].x = state(m).x;
        before[m].q = state(m).q;
    }
    const scalarList movedBefore(moved_);
    const labelList usedBefore(used_);
    const together sums0(sums_);

    const auto tryPart = [&](const scalar part)
    {
        used_ = usedBefore;
        here_[displaced] = 0;
        forAll(before, m)
        {
            if (!d_[m].isZero(0))
            {
                const scalar moved = newtonMinimiser::moveBy
                (
                    type(m), before[m], d_[m], part, state(m)
                );
                moved_[m] = movedBefore[m] + moved;
                here_[displaced] = max(here_[displaced], moved);
                hasMoved_[m] = true;
            }
        }
        begin();
    };
    const auto tryAll = [&]()
    {
        tryPart(here_[untried] > 0 ? 0 : 1);
    };

    const bool checked = findStep(true);
    tryAll();
    if (checked && sums_[atEnd] > enough*sums0[atStart])
    {
        forAll(before, m)
        {
            state(m).x = before[m].x;
            state(m).q = before[m].q;
        }
        used_ = usedBefore;
        moved_ = movedBefore;
        hasMoved_ = true;
        evaluate();
        prepare();
        findStep(false);
        tryAll();
    }

    for (const Eigen::VectorXd& d : d_)
    {
        nSolves_ += !d.isZero(0);
    }

    // A contact that begins is not in the tangent: where the step goes too far, the
    // minimum along it lies in the contact
    scalar low = 0, high = -sums_[passable];
    scalar slopeLow = sums_[slopeBefore], slopeHigh = 0;
    scalar part = high;
    bool wasFar = false;
    if (sums_[untried] > 0)
    {
        tryPart(high);
    }
    for (label attempt = 0; !lowers(sums0, attempt); ++attempt)
    {
        const bool far =
            sums_[slope] > 0 || sums_[potentialSum] > sums0[potentialSum];
        if (!far && part == high)
        {
            break;  // downhill as far as the step may go
        }
        (far ? high : low) = part;
        (far ? slopeHigh : slopeLow) = sums_[slope];
        if (attempt > 0 && far == wasFar)
        {
            (far ? slopeLow : slopeHigh) *= 0.5;
        }
        wasFar = far;

        // Where the slope would vanish if it were linear, if that is not near an end
        scalar middle = 0.5;
        if (slopeLow < 0 && slopeHigh > 0)
        {
            const scalar root = slopeLow/(slopeLow - slopeHigh);
            middle = root < 0.1 || root > 0.9 ? 0.5 : root;
        }
        part = low + middle*(high - low);
        tryPart(part);
    }
    return part == 1;
}


bool Foam::jointMinimiser::lowers
(
    const together& sums0,
    const label attempt
) const
{
    // Close to the minimum the sum changes by rounding and by what its gradient leaves
    // out, while the gradient still falls
    const scalar change = sums_[potentialSum] - sums0[potentialSum];
    const bool lower = change <= 0;
    const bool rounded = change <= 1e-10*sums0[magnitudeSum];
    const bool flatter = mag(sums_[slope]) < 0.5*mag(sums_[slopeBefore]);
    return
        attempt >= 59
     || lastStep_ <= tolerance_
     || (lower && (flatter || attempt > 30))
     || (
            (rounded || lastStep_ < close)
         && sums_[gradientSum] < 0.25*sums0[gradientSum]
        );
}


void Foam::jointMinimiser::predict(const motions& steps)
{
    const auto start = [&](const scalar fraction)
    {
        forAll(potentials_, m)
        {
            const clumpInteraction::coupledClump& clump = group_.coupledClumps()[m];
            if (!clump.hasGuess)
            {
                // A prescribed motion has no parts
                const bool whole =
                    clump.ext->turned || clump.ext->moved != vector::zero;
                newtonMinimiser::moveBy
                (
                    type(m), *clump.start, steps[m], whole ? 1 : fraction, *clump.end
                );
                moved_[m] = GREAT;
                hasMoved_[m] = true;
            }
        }
        begin();
    };

    evaluate();
    here_[unmoved] = here_[potentialSum];
    here_[passable] = -group_.passable(steps);
    here_[untried] = here_[passable] > -1;
    start(here_[untried] > 0 ? 0 : 1);
    if (sums_[untried] > 0)
    {
        start(-sums_[passable]);
    }
    if (sums_[potentialSum] > sums_[unmoved])
    {
        start(0);
    }
    ready_ = true;
}


bool Foam::jointMinimiser::resume(const bool changed)
{
    here_[redistributed] = changed;
    begin();
    here_[redistributed] = 0;
    ready_ = true;
    return sums_[redistributed] > 0;
}


bool Foam::jointMinimiser::minimise(const scalar reduction)
{
    if (!ready_)
    {
        begin();
    }
    ready_ = false;
    const scalar small = max(tolerance_, reduction*sums_[ownPart]);

    for (label n = 0; n < maxIterations_; ++n)
    {
        // After a longer step there is always another one
        const bool near = n == 0 || lastStep_ < 1000*small;
        if (near && sums_[ownPart] <= small)
        {
            return true;
        }
        const bool whole = takeStep();
        if (lastStep_ <= (whole ? small : tolerance_))
        {
            return true;
        }
    }
    return false;
}
