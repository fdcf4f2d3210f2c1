/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "couplingResidual.H"
#include "foamCompat.H"
#include "mathematicalConstants.H"
#include "StringStream.H"

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


Foam::couplingResidual::flowPower Foam::couplingResidual::pressurePower
(
    const scalarField& p0
) const
{
    const scalarField& V = flow_.U().mesh().V();
    const vectorField& U = flow_.U().primitiveField();
    const scalarField& p = flow_.p().primitiveField();
    const scalarField& nu = flow_.nu().primitiveField();

    List<vector> sums(2);
    sums[0] = sum(V*U);
    sums[1] = vector(sum(V), sumProd(V, p), sumProd(V, p0));
    reduceList(sums, plusEqOp<vector>());
    const scalar volume = sums[1].x();
    const vector mean(sums[0]/volume);
    const scalarField dp(p - sums[1].y()/volume);
    const scalarField dp0(p0 - sums[1].z()/volume);

    List<scalar> powers(5);
    powers[0] = sum(V*magSqr(U - mean));
    powers[1] = sum(V*sqr(dp - dp0)/nu);
    powers[2] = sum(V*sqr(dp0)/nu);
    powers[3] = sum(V*sqr(dp)/nu);
    powers[4] = sumProd(V, nu);
    reduceList(powers, plusEqOp<scalar>());
    return
    {
        Foam::sqrt(powers[0]/volume), powers[1], powers[2], powers[3], powers[4]
    };
}


Foam::scalar Foam::couplingResidual::slip(const clumpParcel& p) const
{
    const clumpType& type = cloud_.type(p);
    const scalarField& r = type.dragRadii();
    const scalar rho = cloud_.fluidDensity();
    const scalar dt = flow_.p().time().deltaTValue();
    const scalar layer = Foam::sqrt(drag_*dt/(6*constant::mathematical::pi));
    return
        mag(sum(p.fluidForces()))
       /(
            drag_*rho*sum(r*(1 + r/layer))
          + (type.mass() + rho*type.volume())/dt
        );
}


Foam::scalar Foam::couplingResidual::power
(
    const clumpParcel& p,
    const vector& start,
    const vectorField& u,
    const vectorField& w
) const
{
    const clumpType& type = cloud_.type(p);
    const scalarField& r = type.dragRadii();
    const vector mean(meanOf(r, u));

    return
        drag_*sum(r*(magSqr(u - mean) + sqr(r)*magSqr(w)))
      + drag_*sum(r)*(magSqr(mean - start) + sqr(slip(p)));
}


Foam::scalar Foam::couplingResidual::imbalance
(
    const clumpParcel& p,
    const vectorField& du,
    const vectorField& dw,
    const scalar least
) const
{
    const clumpType& type = cloud_.type(p);
    if (!type.ofSpheres())
    {
        return 0;
    }
    const externalForces& ext = p.step().forces;
    const vectorField& f = p.fluidForces();
    const vectorField& t = p.fluidTorques();
    const scalarField& r = type.dragRadii();
    const scalar lost =
        sum(ext.zeta*mag(du)) + sum(ext.zetaR*mag(dw)/r);
    const scalar size =
        sum(mag(f) + mag(ext.f - f)) + sum((mag(t) + mag(ext.t - t))/r)
      + drag_*cloud_.fluidDensity()*least*sum(r);
    return lost/max(size, VSMALL);
}


Foam::scalar Foam::couplingResidual::value(const scalarField& p0)
{
    using constant::mathematical::pi;
    const scalar largest = gMax(flow_.nu().primitiveField());

    // Motions that need not be resolved
    const scalar least = 1e-8/flow_.p().time().deltaTValue();
    const flowPower flow(pressurePower(p0));

    // Of the clumps: of the change, before and after
    List<scalar> powers(3, scalar(0));
    scalar worst = 0;
    worst_ = nullptr;
    label index = 0;
    for (const clumpParcel& p : cloud_)
    {
        const scalar before = worst;
        const vector& start = start_[index++];
        const scalarField& r = cloud_.type(p).dragRadii();
        const clumpStep& step = p.step();
        drag_ = 6*pi*(step.nu > 0 ? step.nu : largest);
        const vectorField du(step.end.u - step.imposedU);
        const vectorField dw(step.end.w - step.imposedW);
        const scalar thinned =
            step.nu > 0 ? slip(p)*(step.nu/step.lastNu - 1) : 0;
        const scalar changed =
            drag_*sum(r*(magSqr(du) + sqr(thinned) + sqr(r)*magSqr(dw)));
        const scalar imposed =
            power(p, start, step.imposedU, step.imposedW);
        const scalar ended = power(p, start, step.end.u, step.end.w);
        const scalar slowest = max(0.1*flow.scale, least*min(r));
        const scalar floor = drag_*sum(r)*sqr(slowest);

        powers[0] += changed;
        powers[1] += imposed;
        powers[2] += ended;
        worst = max(worst, changed/max(max(imposed, ended), floor));
        worst = max(worst, sqr(imbalance(p, du, dw, slowest)/3));
        if (!step.solved)
        {
            worst = sqr(GREAT);
        }
        if (worst > before)
        {
            worst_ = &p;
        }
    }
    ofWorst_ = worst;
    reduceList(powers, plusEqOp<scalar>());
    reduce(worst, maxOp<scalar>());
    ofClumps_ = worst;
    solved_ = worst < sqr(GREAT);

    const scalar change = powers[0] + flow.change;
    const scalar size = max(powers[1] + flow.before, powers[2] + flow.after);
    const scalar floor = sqr(least)*flow.viscosity;
    worst = max(worst, change/max(size, floor));

    const heldMeanVelocity::power gradients(held_.gradientPower());
    const scalar pressure = gradients.size + max(flow.before, flow.after);
    ofAll_ = max(worst, gradients.change/max(pressure, floor));
    return Foam::sqrt(ofAll_);
}


Foam::string Foam::couplingResidual::where() const
{
    List<string> all(Pstream::nProcs());
    if (worst_ && ofWorst_ >= ofClumps_)
    {
        OStringStream os;
        os  << "clump " << worst_->origId() << " (" << cloud_.type(*worst_).name()
            << ") at " << worst_->position();
        all[Pstream::myProcNo()] = os.str();
    }
    gatherToAll(all);
    for (const string& said : all)
    {
        if (!said.empty() && ofAll_ <= ofClumps_)
        {
            return said;
        }
    }
    return "the flow as a whole";
}
