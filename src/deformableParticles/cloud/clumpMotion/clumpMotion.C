/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpMotion.H"
#include "clumpTotals.H"
#include "fluidCoupling.H"
#include "HashSet.H"
#include "mathematicalConstants.H"
#include "vector2D.H"

Foam::clumpMotion::clumpMotion
(
    clumpSuspension& clumps
)
:
    clumps_(clumps),
    coupling_(clumps.hasFluid() ? &clumps.coupling() : nullptr),
    integrator_(selectModel<integrator>(getDict(clumps.properties(), "integrator"))),
    loads_(clumps.mesh(), clumps.types()),
    contacts_(clumps.types(), clumps.properties()),
    walls_(clumps.mesh(), clumps.types(), clumps.properties()),
    gaps_(clumps.properties(), clumps.types(), clumps.mesh().boundaryMesh()),
    contacting_
    (
        clumps.mesh(), clumps.types(), clumps.bonds(), contacts_, walls_, gaps_
    ),
    decisions_(clumps, contacts_, walls_, gaps_),
    approximate_(false),
    nSolves_(0)
{
    const dictionary& dict = clumps.properties();
    loads_.read
    (
        clumps.effects().active("loads") ? &getDict(dict, "loads") : nullptr,
        clumps.typeIds()
    );
    if (loads_.move() && !integrator_->implicit())
    {
        FatalIOErrorInFunction(getDict(dict, "integrator"))
            << "Entry 'type' is " << integrator_->type() << ", which cannot move clumps by"
            << " the load move. Valid: implicitEuler" << exit(FatalIOError);
    }
    decisions_.refuseIdle(integrator_->implicit());
    for (clumpKind& kind : clumps.kinds())
    {
        kind.check
        (
            {
                clumps.coupled(),
                coupling_ && coupling_->damps(),
                integrator_->implicit(),
                decisions_.clumpsMayTouch()
            }
        );
        kind.immerseIn(clumps.fluidDensity());
    }
}


namespace
{

using namespace Foam;

//- Fatal where an own clump crosses a plane of symmetry, by more than the contact of
//  packed clumps: a sphere reaches into it, or nodes are on both sides
void refuseCrossing
(
    const ghostExchange& ghosts,
    const PtrList<clumpType>& types,
    const dictionary& placement
)
{
    const scalar allowed =
        max(0.1, placement.getOrDefault<scalar>("maxOverlap", 0));
    for (const imageTransform& mirror : ghosts.transforms())
    {
        const auto height = [&](const point& x)
        {
            return vector(0.5*(x - mirror.position(x)));
        };
        const vector inwards(height(ghosts.localBox().midpoint()));
        if
        (
            mirror.nMirrors != 1
         || mag(mirror.polar(inwards) + inwards) > 1e-6*mag(inwards)
        )
        {
            // Not behind this plane alone
            continue;
        }
        for (label a = 0; a < ghosts.nOwn(); ++a)
        {
            const clumpImage& clump = ghosts.images()[a];
            const clumpType& type = types[clump.typeId];
            forAll(clump.x, i)
            {
                const vector h(height(clump.x[i]));
                const scalar least =
                    type.ofSpheres() ? (1 - allowed)*type.radii()[i] : 0;
                if ((h & inwards) < 0 || mag(h) < least)
                {
                    FatalIOErrorInFunction(placement)
                        << "Entry 'position': clump " << clump.id.second() << " of type "
                        << type.name() << " crosses a plane of symmetry: "
                        << (type.ofSpheres() ? "sphere " : "node ") << i << " at "
                        << clump.x[i] << " is " << mag(h)
                        << ((h & inwards) < 0 ? " m behind it" : " m from it")
                        << ". Half a clump and its mirror image are not modelled: move"
                        << " it off the plane, or mesh both sides." << exit(FatalIOError);
                }
            }
        }
    }
}

}


void Foam::clumpMotion::refuseOverlaps(const dictionary& placement) const
{
    const ghostExchange& ghosts = clumps_.ghosts();
    refuseCrossing(ghosts, clumps_.types(), placement);
    if (contacts_.active() && clumps_.effects().active("contact"))
    {
        contacts_.refuseOverlaps(ghosts.images(), ghosts.nOwn(), placement);
    }
    for (const clumpKind& kind : clumps_.kinds())
    {
        if (decisions_.clumpsMayTouch())
        {
            kind.refuseOverlaps(ghosts, placement);
        }
    }
}


const Foam::wallContacts* Foam::clumpMotion::touchedWalls()
{
    if (!decisions_.wallsMayTouch())
    {
        return nullptr;
    }
    walls_.update(clumps_.ghosts());
    if (gaps_.bonds())
    {
        walls_.updateMotions(clumps_.ghosts(), gaps_);
    }
    return &walls_;
}


void Foam::clumpMotion::setNodeForces()
{
    loads_.sample(clumps_.ghosts());
    label index = -1;
    for (clumpParcel& p : clumps_)
    {
        ++index;
        if (clumps_.kind(p))
        {
            setSteadyForces(p, 0);
            loads_.add(p, index, p.step().forces);
        }
    }
}


void Foam::clumpMotion::solve(const bool endsStep)
{
    contacting_.endsStep = endsStep;
    approximate_ = false;
    const scalar dt = clumps_.mesh().time().deltaTValue();
    for (clumpParcel& p : clumps_)
    {
        p.step().overshootsBefore = p.overshoots();
        if (clumps_.coupled())
        {
            coupling_->anticipate(p, dt);
        }
    }
    {
        const timeBreakdown::timer t(clumps_.timing(), "loads");
        loads_.sample(clumps_.ghosts());
    }

    // Those that overshoot need a higher coupling coefficient; a few times suffice
    constexpr label most = 3;
    for (label n = 0; n < most; ++n)
    {
        solveOnce(dt);
        if (!clumps_.coupled() || !adaptCoupling(dt, n > 0))
        {
            break;
        }
    }
    for (clumpParcel& p : clumps_)
    {
        p.step().change = p.step().end.u - p.step().imposedU;
    }
}


bool Foam::clumpMotion::adaptCoupling
(
    const scalar dt,
    const bool repeated
)
{
    bool again = false;
    for (clumpParcel& p : clumps_)
    {
        again = coupling_->adapt(p, dt, repeated) || again;
    }
    return returnReduce(again, orOp<bool>());
}


void Foam::clumpMotion::solveOnce(const scalar dt)
{
    momentum_ = clumpMomentum();
    passing_.clear();
    contactSummary_ = contactSummary();
    for (clumpParcel& p : clumps_)
    {
        if (!clumps_.coupled())
        {
            p.step().begin(p.state());
        }
        else
        {
            momentum_.addFluid
            (
                p, coupling_->interiorForces(p, dt), coupling_->displacedInertia(p, dt)
            );
        }
    }
    advanceAll(dt);
    for (clumpParcel& p : clumps_)
    {
        clumpStep& step = p.step();
        if (!type(p).fixed() && type(p).ofSpheres())
        {
            loads_.addConstraint(p, dt);
            momentum_.addStep(type(p), p.state(), step);
        }
        step.hasGuess = true;
    }
    endCorrector(dt);
}


void Foam::clumpMotion::advanceAll(const scalar dt)
{
    for (clumpParcel& p : clumps_)
    {
        clumpStep& step = p.step();
        if (step.hasGuess)
        {
            // Bonds that broke in a solution that was not accepted
            step.end.broken = p.state().broken;
        }
        setSteadyForces(p, dt);
        loads_.prescribe
        (
            p.typeId(), clumps_.mesh().time().value() - dt, dt, step.forces
        );
    }
    if (!loads_.empty())
    {
        const timeBreakdown::timer t(clumps_.timing(), "loads");
        label index = 0;
        for (clumpParcel& p : clumps_)
        {
            loads_.add(p, index++, p.step().forces);
        }
    }

    if (clumps_.effects().active("contact") || clumps_.effects().active("walls"))
    {
        advanceTogether(dt);
    }
    else
    {
        const timeBreakdown::timer t(clumps_.timing(), "clumps");
        for (clumpParcel& p : clumps_)
        {
            advance(p, dt);
        }
    }
}


void Foam::clumpMotion::addWeight
(
    const clumpParcel& p,
    externalForces& ext
) const
{
    if (clumps_.effects().active("gravity"))
    {
        const timeBreakdown::timer t(clumps_.timing(), "gravity");
        const scalar rho = clumps_.fluidDensity();
        if (const clumpKind* kind = clumps_.kind(p))
        {
            ext.f += kind->weight(p, rho, clumps_.g());
        }
        else
        {
            ext.f += type(p).excessMasses(rho, p.state().x)*clumps_.g();
        }
    }
}


void Foam::clumpMotion::setSteadyForces
(
    clumpParcel& p,
    const scalar dt
)
{
    const clumpType& ct = type(p);
    externalForces& ext = p.step().forces;
    ext = externalForces(ct.size());

    addWeight(p, ext);
    if (!ct.ofSpheres())
    {
        return;
    }
    if (clumps_.hasFluid())
    {
        coupling_->addForces(p, dt, ext);
    }
    const externalForces& otherKindForces = p.step().otherKindForces;
    if (otherKindForces.f.size())
    {
        ext.f += otherKindForces.f;
        ext.k += otherKindForces.k;
    }
}


void Foam::clumpMotion::advance(clumpParcel& p, const scalar dt)
{
    if (const clumpKind* kind = clumps_.kind(p))
    {
        kind->advance(p, coupling_->viscosity(p));
        ++nSolves_;
        return;
    }
    clumpState& end = p.step().end;
    end = p.state();
    p.step().hasGuess = false;
    if (type(p).fixed())
    {
        return;
    }
    integrator_->advance(clumps_.bonds(p), p.step().forces, dt, end);
    ++nSolves_;
}


void Foam::clumpMotion::endCorrector(const scalar dt)
{
    momentum_.finish(dt);
    for (clumpParcel& p : clumps_)
    {
        clumpStep& step = p.step();
        const clumpKind* kind = clumps_.kind(p);
        step.end.a =
            kind
          ? kind->acceleration(p) : vectorField((step.end.u - step.imposedU)/dt);
        step.end.b = (step.end.w - step.imposedW)/dt;
    }
}


void Foam::clumpMotion::accept(const vector& flowChange)
{
    clumps_.breakage().note(clumps_);
    const scalar dt = clumps_.mesh().time().deltaTValue();
    constraints_.clear();
    pairs_.clear();
    if (keepsPairs_ && contacting_.searched())
    {
        pairs_ = contacting_.pairs();
    }
    if (gaps_.bonds())
    {
        renewBonds();
    }
    for (clumpParcel& p : clumps_)
    {
        if (tr(loads_.held(p.typeId())) > 0 || loads_.turn(p.typeId()))
        {
            const clumpType& ct = type(p);
            const clumpStep& step = p.step();
            const vector dx(step.end.centre(ct) - p.state().centre(ct));
            constraints_.append
            (
                {
                    p.origId(), p.typeId(),
                    step.constraintForce, step.constraintTorque,
                    p.unwrappedCentre(ct) + dx, step.end.velocity(ct),
                    step.end.angularVelocity(ct)
                }
            );
        }
        if (coupling_)
        {
            coupling_->setSurfaceForce(p, dt);
        }
        p.accept(type(p), dt*clumps_.meshVelocity(), flowChange);
    }
    contacting_.forget();
}


void Foam::clumpMotion::renewBonds()
{
    DynamicList<surfaceBond> bonds;
    if (contacting_.searched())
    {
        bonds = contacting_.renewedBonds();
    }
    else
    {
        labelHashSet own;
        for (const clumpParcel& p : clumps_)
        {
            if (type(p).ofSpheres())
            {
                own.insert(p.origId());
            }
        }
        for (const surfaceBond& b : gaps_.bonds()->bonds())
        {
            if (own.found(b.clump.first()))
            {
                bonds.append(b);
            }
        }
    }
    for (clumpKind& kind : clumps_.kinds())
    {
        kind.addBonds(clumps_, clumps_.ghosts(), gaps_, bonds);
    }
    gaps_.bonds()->replace(bonds);
}


void Foam::clumpMotion::changeVelocities(const vector& dU)
{
    for (clumpParcel& p : clumps_)
    {
        p.state().u += dU;
    }
    momentum_.correction = dU;
}


bool Foam::clumpMotion::impose(clumpParcel& p) const
{
    if (!loads_.move(p.typeId()))
    {
        return false;
    }
    clumpStep& step = p.step();
    const vectorField before(step.imposedU);
    loads_.impose
    (
        p, clumps_.mesh().time().deltaTValue(), step.imposedU, step.imposedW
    );
    step.imposedChange += step.imposedU - before;
    return true;
}


void Foam::clumpMotion::meshChanged()
{
    contacting_.meshChanged();
    decisions_.renewWalls();
}


Foam::symmTensor Foam::clumpMotion::held() const
{
    symmTensor result(Zero);
    if (someFixed(clumps_))
    {
        result += symmTensor(I);
    }
    return result + loads_.held();
}


Foam::scalar Foam::clumpMotion::releaseStep(const scalar radii)
{
    const bool heavy = clumps_.effects().active("gravity");
    if (!heavy && loads_.empty())
    {
        return GREAT;
    }
    const scalar pi = constant::mathematical::pi;
    const scalar rho = clumps_.fluidDensity();
    const scalar nu =
        clumps_.hasFluid()
      ? gMin(clumps_.mesh().lookupObject<volScalarField>("nu").primitiveField()) : 0;

    if (!loads_.empty())
    {
        for (clumpParcel& p : clumps_)
        {
            p.step().extrapolation = Zero;
        }
        clumps_.updateGhosts();
        loads_.sample(clumps_.ghosts());
    }

    scalar result = GREAT;
    label index = -1;
    for (const clumpParcel& p : clumps_)
    {
        const clumpType& ct = type(p);
        ++index;
        if (ct.fixed())
        {
            continue;
        }
        if (loads_.move(p.typeId()))
        {
            // As fast as in a next step of the length of this one
            const Time& time = clumps_.mesh().time();
            const scalar dt = time.deltaTValue();
            externalForces ext;
            loads_.prescribe(p.typeId(), time.value(), dt, ext);
            const scalar way = mag(ext.moved) + ct.halfWidth()*mag(ext.turn);
            result = min(result, dt*radii*ct.halfWidth()/max(way, VSMALL));
            continue;
        }
        vector F(Zero);
        if (heavy)
        {
            F += ct.nominalRatio()*(ct.mass() - rho*ct.volume())*clumps_.g();
        }
        F += loads_.steadyForce(p, index);

        const scalar size = max(mag(F), VSMALL);
        const scalar way = radii*ct.halfWidth();
        scalar step = Foam::sqrt(way*ct.mass()/size);
        if (clumps_.hasFluid())
        {
            const scalar R = Foam::cbrt(0.75*ct.volume()/pi);
            const scalar slow = size/(6*pi*rho*nu*R);
            const scalar u =
                2*slow/(1 + Foam::sqrt(1 + 4*slow*R/(30*nu)));
            step = max(step, way/u);
        }
        result = min(result, step);
    }
    return returnReduce(result, minOp<scalar>());
}


Foam::Pair<Foam::scalar> Foam::clumpMotion::overlaps() const
{
    const vector2D deepest
    (
        returnReduce
        (
            vector2D(contactSummary_.deepest, contactSummary_.deepestOfWall),
            maxOp<vector2D>()
        )
    );
    return Pair<scalar>(deepest.x(), deepest.y());
}


bool Foam::clumpMotion::needsShorterStep() const
{
    bool needs = false;
    for (const clumpParcel& p : clumps_)
    {
        needs = needs || p.step().needsShorterStep;
    }
    return clumps_.coupled() && returnReduce(needs, orOp<bool>());
}
