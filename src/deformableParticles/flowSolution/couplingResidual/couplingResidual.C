/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "couplingResidual.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

//- Velocity of a clump, weighted with the radii r [m/s]
vector meanOf(const scalarField& r, const vectorField& u)
{
    return sum(r*u)/sum(r);
}

}


void Foam::couplingResidual::beginStep()
{
    start_.clear();
    for (const clumpParcel& p : cloud_)
    {
        start_.append(meanOf(cloud_.type(p).dragRadii(), p.state().u));
    }
}


Foam::scalar Foam::couplingResidual::flowScale() const
{
    const scalarField& V = flow_.U().mesh().V();
    const vectorField& U = flow_.U().primitiveField();
    const scalar volume = gSum(V);
    const vector mean(gSum(V*U)/volume);
    return Foam::sqrt(gSum(V*magSqr(U - mean))/volume);
}


Foam::scalar Foam::couplingResidual::power(const scalarField& p) const
{
    const scalarField& V = flow_.p().mesh().V();
    const scalar level = gSum(V*p)/gSum(V);
    return gSum(V*sqr(p - level)/flow_.nu().primitiveField());
}


Foam::scalar Foam::couplingResidual::power
(
    const clumpParcel& p,
    const vector& start,
    const vectorField& u,
    const vectorField& w
) const
{
    const scalarField& r = cloud_.type(p).dragRadii();
    const vector mean(meanOf(r, u));
    const scalar slip =
        mag(sum(p.fluidForces()))/(drag_*cloud_.fluidDensity()*sum(r));

    return
        drag_*sum(r*(magSqr(u - mean) + sqr(r)*magSqr(w)))
      + drag_*sum(r)*(magSqr(mean - start) + sqr(slip));
}


Foam::scalar Foam::couplingResidual::value(const scalarField& p0)
{
    using constant::mathematical::pi;
    drag_ = 6*pi*gMax(flow_.nu().primitiveField());

    // Motions that need not be resolved
    const scalar least = 1e-6/flow_.p().time().deltaTValue();
    const scalar ofFlow = 0.1*flowScale();

    scalar change = 0, before = 0, after = 0, worst = 0;
    label index = 0;
    for (const clumpParcel& p : cloud_)
    {
        const vector& start = start_[index++];
        const scalarField& r = cloud_.type(p).dragRadii();
        const clumpStep& step = p.step();
        const vectorField du(step.end.u - step.imposedU);
        const vectorField dw(step.end.w - step.imposedW);
        const scalar changed = drag_*sum(r*(magSqr(du) + sqr(r)*magSqr(dw)));
        const scalar imposed =
            power(p, start, step.imposedU, step.imposedW);
        const scalar ended = power(p, start, step.end.u, step.end.w);
        const scalar floor = drag_*sum(r)*sqr(max(ofFlow, least*min(r)));

        change += changed;
        before += imposed;
        after += ended;
        worst = max(worst, changed/max(max(imposed, ended), floor));
        if (!step.nodes.solved)
        {
            worst = sqr(GREAT);
        }
    }
    reduce(change, sumOp<scalar>());
    reduce(before, sumOp<scalar>());
    reduce(after, sumOp<scalar>());
    reduce(worst, maxOp<scalar>());
    solved_ = worst < sqr(GREAT);

    const scalarField& p = flow_.p().primitiveField();
    change += power(p - p0);
    before += power(p0);
    after += power(p);
    const scalarField& V = flow_.p().mesh().V();
    const scalar floor = sqr(least)*gSum(V*flow_.nu().primitiveField());

    return Foam::sqrt(max(worst, change/max(max(before, after), floor)));
}
