/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "couplingIteration.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

scalarField pressureScale(const volScalarField& nu)
{
    return Foam::sqrt(nu.mesh().V().field()/nu.primitiveField());
}

//- Of all clumps, whichever processor has them
scalar velocityScale(const volScalarField& nu)
{
    using constant::mathematical::pi;
    return Foam::sqrt(6*pi*gMax(nu.primitiveField()));
}

}


Foam::couplingIteration::couplingIteration
(
    deformableCloud& cloud,
    incompressibleFlow& flow,
    const bool clumpsFollow
)
:
    cloud_(cloud),
    flow_(flow),
    clumpsFollow_(clumpsFollow && flow.solved() && cloud.coupled()),
    tolerance_(0),
    nCorrectors_(0)
{
    if (!clumpsFollow_)
    {
        return;
    }
    const dictionary dict(flow.control().dict());
    tolerance_ = dict.get<scalar>("couplingTolerance");
    acceleration_.reset
    (
        new andersonAcceleration(dict.get<label>("andersonDepth"))
    );
}


Foam::scalarField Foam::couplingIteration::unknowns
(
    const scalarField& p,
    const bool imposed
) const
{
    const scalarField& V = flow_.p().mesh().V();
    const scalar level =
        flow_.p().needReference() ? gSumProd(p, V)/gSum(V) : 0;

    const scalar ofVelocity = velocityScale(flow_.nu());
    DynamicList<scalar> x(pressureScale(flow_.nu())*(p - level));
    for (const clumpParcel& parcel : cloud_)
    {
        const clumpStep& step = parcel.step();
        const vectorField& u = imposed ? step.imposedU : step.end.u;
        const vectorField& w = imposed ? step.imposedW : step.end.w;
        const scalarField& r = cloud_.type(parcel).dragRadii();
        const scalarField scale(ofVelocity*Foam::sqrt(r));
        forAll(u, i)
        {
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                x.append(scale[i]*u[i][d]);
                x.append(scale[i]*r[i]*w[i][d]);
            }
        }
    }
    return scalarField(x);
}


Foam::scalar Foam::couplingIteration::power(const scalarField& x) const
{
    // The level of p is no part of it, even where a patch fixes it
    const scalarField scale(pressureScale(flow_.nu()));
    const SubField<scalar> p(x, p0_.size());
    const scalar level = gSumProd(p, scale)/gSumSqr(scale);

    return gSumSqr(x) - sqr(level)*gSumSqr(scale);
}


Foam::scalar Foam::couplingIteration::residual
(
    const scalarField& x,
    const scalarField& r
) const
{
    // From rest the change is all there is
    return Foam::sqrt(gSumSqr(r)/max(max(power(x), power(x + r)), VSMALL));
}


void Foam::couplingIteration::add(const scalarField& change)
{
    volScalarField& p = flow_.p();
    const label nCells = p.size();
    p.primitiveFieldRef() +=
        SubField<scalar>(change, nCells)/pressureScale(flow_.nu());
    p.correctBoundaryConditions();

    const scalar ofVelocity = velocityScale(flow_.nu());
    label k = nCells;
    for (clumpParcel& parcel : cloud_)
    {
        clumpState& end = parcel.step().end;
        const scalarField& r = cloud_.type(parcel).dragRadii();
        const scalarField scale(ofVelocity*Foam::sqrt(r));
        forAll(r, i)
        {
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                end.u[i][d] += change[k++]/scale[i];
                end.w[i][d] += change[k++]/(scale[i]*r[i]);
            }
        }
    }
}


bool Foam::couplingIteration::converged()
{
    cloud_.predict(flow_.U(), flow_.p(), flow_.nu());

    const scalarField x(unknowns(p0_, true));
    const scalarField r(unknowns(flow_.p(), false) - x);
    if (residual(x, r) < tolerance_)
    {
        return true;
    }
    add(acceleration_->correction(x, r));
    cloud_.imposeEnd();
    return false;
}


bool Foam::couplingIteration::loop()
{
    outerCorrectors& control = flow_.control();
    const bool last = nCorrectors_ == control.nCorrPIMPLE();

    if (clumpsFollow_ && nCorrectors_ > 0 && !last && converged())
    {
        control.end();
        return false;
    }
    if (!control.loop())
    {
        return false;
    }
    if (clumpsFollow_)
    {
        p0_ = flow_.p().primitiveField();
    }
    ++nCorrectors_;
    return true;
}


void Foam::couplingIteration::beginStep()
{
    // There is no pattern to be carried before the first step
    const bool started = flow_.p().time().timeIndex() > 1;
    if (clumpsFollow_ && flow_.carriesPressure() && started)
    {
        const timeBreakdown::timer t(cloud_.timing(), "flow");
        flow_.carryPressure(cloud_.displacement());
    }
}


void Foam::couplingIteration::endStep()
{
    if (clumpsFollow_)
    {
        const scalarField x(unknowns(p0_, true));
        const scalarField r(unknowns(flow_.p(), false) - x);
        Info<< "Outer correctors: " << nCorrectors_ << ", residual "
            << residual(x, r) << endl;
        acceleration_->clear();
    }
    nCorrectors_ = 0;
}
