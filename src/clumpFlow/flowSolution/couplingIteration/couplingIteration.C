/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "couplingIteration.H"
#include "clumpDisplacement.H"
#include "clumpMotion.H"
#include "clumpTotals.H"
#include "mathematicalConstants.H"
#include "StringStream.H"

namespace
{

using namespace Foam;

scalarField pressureScale(const volScalarField& nu)
{
    return Foam::sqrt(nu.mesh().V().field()/nu.primitiveField());
}

//- Of the spheres of a clump, with the largest viscosity or that around it [m2/s]
scalarField velocityScale
(
    const scalarField& radii,
    const scalar largest,
    const scalar around
)
{
    using constant::mathematical::pi;
    return Foam::sqrt(6*pi*(around > 0 ? around : largest))*Foam::sqrt(radii);
}

void append(DynamicList<scalar>& list, const vector& v)
{
    for (const scalar component : v)
    {
        list.append(component);
    }
}

}


Foam::couplingIteration::couplingIteration
(
    deformableCloud& cloud,
    incompressibleFlow& flow,
    const heldMeanVelocity& held
)
:
    cloud_(cloud),
    flow_(flow),
    clumpsFollow_(flow.solved() && cloud.coupled()),
    residual_(cloud, flow, held),
    tolerance_(0),
    nCorrectors_(0),
    agreed_(false),
    withoutClumps_(false),
    nextWithout_(false),
    last_(0),
    nSteps_(0),
    nMissed_(0),
    worst_(0)
{
    if (!clumpsFollow_)
    {
        return;
    }
    refuseLaggingContact();
    acceleration_.reset
    (
        new andersonAcceleration
        (
            flow.control().dict().get<label>("andersonDepth")
        )
    );
}


void Foam::couplingIteration::refuseLaggingContact() const
{
    const bool interacting = cloud_.nClumps() > 1 || cloud_.injects();
    if
    (
        flow_.control().nCorrPIMPLE() == 1 && interacting
     && cloud_.kinds().size()
     && cloud_.motion().decisions().clumpsMayTouch()
    )
    {
        const fvMesh& mesh = flow_.p().mesh();
        FatalIOErrorInFunction
        (
            mesh.solutionDict().subDict(outerCorrectors::dictionaryName(mesh))
        )   << "Entry 'nOuterCorrectors' is 1 with couplingTolerance 0. Where membranes"
            << " touch other clumps, each is advanced with the others where they were"
            << " in the last outer corrector; with a single one this is unstable."
            << " Remove both entries, or give nOuterCorrectors 2 or more."
            << exit(FatalIOError);
    }
}


Foam::scalarField Foam::couplingIteration::scales() const
{
    const scalar largest = gMax(flow_.nu().primitiveField());
    DynamicList<scalar> result(pressureScale(flow_.nu()));
    for (const clumpParcel& parcel : cloud_)
    {
        const scalarField& r = cloud_.type(parcel).dragRadii();
        const scalarField scale(velocityScale(r, largest, parcel.step().nu));
        forAll(r, i)
        {
            append(result, vector::uniform(scale[i]));
            append(result, vector::uniform(scale[i]*r[i]));
        }
    }
    return scalarField(result);
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

    DynamicList<scalar> x(p - level);
    for (const clumpParcel& parcel : cloud_)
    {
        const clumpStep& step = parcel.step();
        const vectorField& u = imposed ? step.imposedU : step.end.u;
        const vectorField& w = imposed ? step.imposedW : step.end.w;
        forAll(u, i)
        {
            append(x, u[i]);
            append(x, w[i]);
        }
    }
    return scalarField(x);
}


void Foam::couplingIteration::add(const scalarField& change)
{
    volScalarField& p = flow_.p();
    const label nCells = p.size();
    p.primitiveFieldRef() += SubField<scalar>(change, nCells);
    p.correctBoundaryConditions();

    label k = nCells;
    for (clumpParcel& parcel : cloud_)
    {
        clumpState& end = parcel.step().end;
        forAll(end.u, i)
        {
            for (vector* v : {&end.u[i], &end.w[i]})
            {
                for (direction d = 0; d < vector::nComponents; ++d)
                {
                    (*v)[d] += change[k++];
                }
            }
        }
    }
}


bool Foam::couplingIteration::viscosityChanged() const
{
    scalar change = 0;
    for (const clumpParcel& parcel : cloud_)
    {
        const clumpStep& step = parcel.step();
        if (step.nu > 0)
        {
            change = max(change, mag(step.nu/step.lastNu - 1));
        }
    }
    return returnReduce(change, maxOp<scalar>()) > 0.1;
}


bool Foam::couplingIteration::flowChanged() const
{
    const volVectorField& U = flow_.U();
    const scalarField change(mag(U.primitiveField() - U.oldTime().primitiveField()));
    return gMax(change) > 1e-6*gMax(mag(U.primitiveField())());
}


bool Foam::couplingIteration::converged()
{
    if (withoutClumps_)
    {
        if (flowChanged())
        {
            cloud_.imposeFlow(flow_.U());
        }
        else
        {
            --nCorrectors_;
        }
        return false;
    }
    cloud_.predict(flow_.U(), flow_.p(), flow_.nu());

    const scalar allowed = (nCorrectors_ == 1 ? 0.1 : 1)*tolerance_;
    const bool enough = nCorrectors_ >= flow_.control().least();
    scalar residual = residual_.value(p0_);
    if (residual < allowed && enough && cloud_.motion().approximate())
    {
        cloud_.motion().solve(true);
        residual = residual_.value(p0_);
    }
    if ((residual < allowed && enough) || !residual_.solved())
    {
        return true;
    }
    if (!flow_.Newtonian() && viscosityChanged())
    {
        acceleration_->clear();
    }
    if (acceleration_->empty())
    {
        scales_ = scales();
    }
    const scalarField x(scales_*unknowns(p0_, true));
    const scalarField r(scales_*unknowns(flow_.p(), false) - x);
    add(acceleration_->correction(x, r)/scales_);
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
        agreed_ = true;
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
    withoutClumps_ = nextWithout_;
    nextWithout_ = false;
    return true;
}


void Foam::couplingIteration::beginStep()
{
    residual_.beginStep();
    nCorrectors_ = 0;
    agreed_ = false;
    withoutClumps_ = false;
    if (clumpsFollow_)
    {
        acceleration_->clear();
        tolerance_ = flow_.control().dict().get<scalar>("couplingTolerance");
    }
    nextWithout_ = clumpsFollow_ && cloud_.followedFlow() && tolerance_ > 0;

    // There is no pattern to be carried before the first step
    const bool started = flow_.p().time().timeIndex() > 1;
    if (!clumpsFollow_ || !started)
    {
        return;
    }
    const timeBreakdown::timer t(cloud_.timing(), "flow");
    const volVectorField d(clumpDisplacement(cloud_));
    if (flow_.carriesPressure())
    {
        flow_.carryPressure(d);
    }
    flow_.carryVelocity(d, largestDiameter(cloud_));
}


Foam::string Foam::couplingIteration::disagreement(scalar& before)
{
    if (!clumpsFollow_)
    {
        return string();
    }
    last_ = residual_.value(p0_);
    const bool far =
        tolerance_ > 0 && last_ > max(5*tolerance_, scalar(0.1));
    const bool refused = far && (last_ < 0.9*before || last_ > 0.5);
    before = far ? last_ : GREAT;
    if (!refused)
    {
        return string();
    }
    OStringStream os;
    os  << "    flow and clumps do not agree: after " << nCorrectors_
        << " outer correctors the residual is " << last_ << ", that of "
        << residual_.where().c_str() << nl;
    return os.str();
}


void Foam::couplingIteration::endStep()
{
    if (clumpsFollow_)
    {
        Info<< "Outer correctors: " << nCorrectors_ << ", residual " << last_
            << endl;
        ++nSteps_;
        if (!agreed_ && missed())
        {
            ++nMissed_;
            worst_ = max(worst_, last_);
            warnOfMiss();
        }
    }
}


void Foam::couplingIteration::warnOfMiss() const
{
    if (nMissed_ == 1)
    {
        const string where(residual_.where());
        WarningInFunction
            << "Flow and clumps do not agree to couplingTolerance " << tolerance_
            << " in the step to time " << flow_.p().time().timeName() << ": after "
            << nCorrectors_ << " outer correctors the residual is " << last_
            << ", that of " << where.c_str() << ". Reduce the time step, or allow more"
            << " nOuterCorrectors in system/fvSolution. Further steps of this kind are"
            << " counted." << endl;
    }
}


void Foam::couplingIteration::end() const
{
    if (nMissed_)
    {
        WarningInFunction
            << nMissed_ << " of " << nSteps_ << " steps did not reach"
            << " couplingTolerance " << tolerance_ << ", the largest residual was "
            << worst_ << "." << endl;
    }
}
