/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStep.H"
#include "bondFrame.H"

namespace
{

using namespace Foam;

vector of(const Eigen::VectorXd& v, const label i)
{
    return vector(v[i], v[i + 1], v[i + 2]);
}


//- Of sphere i of a clump, which does not move where there are none
vector of(const vectorField& moves, const label i)
{
    return moves.empty() ? vector(Zero) : moves[i];
}

}


void Foam::contactStep::begin(const scalar dt)
{
    dt_ = dt;
    inPart_ = false;
    move(true);
    if (rubs_)
    {
        // What was solved in an earlier outer corrector is near the minimum
        smoothing_ = 1;
        for (const coupledClump& m : coupled_)
        {
            smoothing_ = m.hasGuess ? smoothing_ : 1000;
        }
        reduce(smoothing_, maxOp<scalar>());
        renew_ = true;
        evaluate();
        setPressed();
    }
    renew_ = true;
}


void Foam::contactStep::setStarts()
{
    move(true);
    before_ = moved_;
    for (sphereContact& t : sphereContacts_)
    {
        if (isCoupled_[t.a])
        {
            evaluate(t);
        }
    }
}


void Foam::contactStep::beginPart()
{
    // What has been left may be met again
    sphereContacts_ = search_.contacts;
    begins_ = search_.begins;
    inPart_ = true;
    setStarts();
    distribute(false);
}


void Foam::contactStep::beginStage(const scalar dt)
{
    dt_ = dt;
    leastEigenvalue = 0;
    setStarts();
    for (sphereContact& t : sphereContacts_)
    {
        t.first = isCoupled_[t.a] ? t.d : t.first;
    }
    if (rubs_)
    {
        smoothing_ = 1000;
        renew_ = true;
        evaluate();
        setPressed();
    }
    renew_ = true;
}


void Foam::contactStep::beginMoving(const scalar dt)
{
    begin(dt);

    List<vectorField> u(moved_.size());
    for (label a = 0; a < clumps_.size(); ++a)
    {
        u[a] = clumps_[a].step().end.u;
    }
    remote_.exchange(u);
    for (sphereContact& t : sphereContacts_)
    {
        if (isCoupled_[t.a])
        {
            evaluate(t);
            const vector v
            (
                t.b < 0
              ? vector(u[t.a][t.i] - t.moved/dt)
              : vector(u[t.a][t.i] - ofImage(t, u[t.otherIndex][t.j]))
            );
            t.first = t.d + dt*(v & t.n);
        }
    }
}


void Foam::contactStep::move(const bool all)
{
    const List<vectorField> moved(moved_);
    const List<vectorField> turned(turns_ ? turned_ : List<vectorField>());
    const auto turn = [&](const label a, const clumpState& start)
    {
        const clumpState& end = clumps_[a].step().end;
        forAll(turned_[a], i)
        {
            turned_[a][i] = rotationVector(end.q[i]*conjugate(start.q[i]));
        }
    };
    for (label a = 0; a < clumps_.size(); ++a)
    {
        const clumpParcel& p = clumps_[a];
        if (all || isCoupled_[a])
        {
            moved_[a] = p.step().end.x - p.state().x;
            if (turns_ && !isCoupled_[a])
            {
                turn(a, p.state());
            }
        }
    }
    for (label m = 0; turns_ && m < coupled_.size(); ++m)
    {
        turn(clumpOf_[m], *coupled_[m].start);
    }
    remote_.exchange(moved_);
    if (turns_)
    {
        remote_.exchange(turned_);
        exchangeOrientations();
    }
    forAll(moved_, c)
    {
        hasMoved_[c] =
            hasMoved_[c]
         || moved_[c] != moved[c]
         || (turns_ && turned_[c] != turned[c]);
    }
}


Foam::vector Foam::contactStep::before(const sphereContact& t) const
{
    return
        t.b < 0
      ? vector::zero
      : ghosts_.images()[t.a].x[t.i] - ghosts_.images()[t.b].x[t.j];
}


Foam::vector Foam::contactStep::displacement(const sphereContact& t) const
{
    const vector& dx = moved_[t.a][t.i];
    return t.b < 0 ? dx : vector(dx - ofImage(t, moved_[t.otherIndex][t.j]));
}


Foam::scalar Foam::contactStep::fromWall(const sphereContact& t, const vector& dx)
{
    return (t.wallNormal + 0.5*(t.bend & dx)) & dx;
}


Foam::scalar Foam::contactStep::overlap
(
    const sphereContact& t,
    vector& n
) const
{
    const vector dx(displacement(t));
    if (t.b < 0)
    {
        n = t.wallNormal + (t.bend & dx);
        return t.radii - fromWall(t, dx);
    }
    // Coincident centres have no direction to part in
    const vector x(before(t) + dx);
    const scalar distance = mag(x);
    n = distance > SMALL*t.R ? vector(x/distance) : vector::zero;
    return t.radii - distance;
}


void Foam::contactStep::evaluate(sphereContact& t) const
{
    t.d = overlap(t, t.n);
    t.w = {0, 0, 0};
    if (t.hasLaw && t.d > 0)
    {
        t.w = t.law->step
        (
            t.ratio*t.d, t.ratio*t.first, t.ratio*dt_, t.R, t.m
        );
        t.w.energy *= t.weight/t.ratio;
        t.w.force *= t.weight;
        t.w.stiffness *= t.weight*t.ratio;
    }
    t.pressing = t.w.force;
    if (t.reaches && max(t.d, t.first) > -t.range)
    {
        // Where bodies bounce, a gap that has closed squeezes nothing out any more: the
        // overlap is a deformation of the bodies
        const scalar least = inPart_ ? 0 : -GREAT;
        const scalar gap = max(-t.d, least);
        contactModel::increment w = gaps_.step
        (
            gap, max(-t.first, least), dt_, t.gapR, placeOf(t)
        );
        if (gap > -t.d)
        {
            w.energy += w.force*(gap + t.d);
            w.stiffness = 0;
        }
        t.w.energy += t.gapWeight*w.energy;
        t.w.force += t.gapWeight*w.force;
        t.w.stiffness += t.gapWeight*w.stiffness;
    }
    evaluateFriction(t);
}


void Foam::contactStep::sumForces(const label m)
{
    const label a = clumpOf_[m];
    forces_[m] = Zero;
    torques_[m] = Zero;
    energies_[m] = 0;
    for (label k = begins_[a]; k < begins_[a + 1]; ++k)
    {
        const sphereContact& t = sphereContacts_[k];
        // Two coupled clumps have half of the energy each
        const bool both = t.b >= 0 && isCoupled_[t.otherIndex];
        energies_[m] +=
            (both ? 0.5 : 1)*(t.w.energy + t.sliding.energy + t.rolling.energy);
        forces_[m][t.i] += t.w.force*t.n + t.sliding.force;
        torques_[m][t.i] +=
            t.arm*(t.sliding.force ^ t.slipNormal) + t.rolling.force;
    }
    addBonds(m);
}


void Foam::contactStep::evaluate()
{
    move(false);
    renewForces();
}


void Foam::contactStep::renewForces()
{
    forAll(coupled_, m)
    {
        const label a = clumpOf_[m];
        if (renew_ || near(a, hasMoved_))
        {
            for (label k = begins_[a]; k < begins_[a + 1]; ++k)
            {
                evaluate(sphereContacts_[k]);
            }
            sumForces(m);
            ++nRenewed_[m];
        }
    }
    hasMoved_ = false;
    renew_ = false;
}


Foam::symmTensorField Foam::contactStep::stiffness(const label m) const
{
    const label a = clumpOf_[m];
    symmTensorField k(type(a).size(), Zero);
    for (label n = begins_[a]; n < begins_[a + 1]; ++n)
    {
        const sphereContact& t = sphereContacts_[n];
        k[t.i] += t.w.stiffness*sqr(t.n) + t.sliding.tangent;
    }
    for (label n = bondBegins_[a]; n < bondBegins_[a + 1]; ++n)
    {
        k[bondEnds_[n].i] += bondEnds_[n].spring.stiffness();
    }
    return k;
}


Foam::List<Foam::vectorField> Foam::contactStep::gatherVectors
(
    const motions& p,
    const label offset
)
{
    List<vectorField> moves(moved_.size());
    forAll(coupled_, m)
    {
        if (!p[m].isZero(0))
        {
            vectorField& move = moves[clumpOf_[m]];
            move.setSize(p[m].size()/6);
            forAll(move, i)
            {
                move[i] = of(p[m], 6*i + offset);
            }
        }
    }
    remote_.exchange(moves);
    return moves;
}


Foam::boolList Foam::contactStep::moving(const UList<vectorField>& moves)
{
    boolList result(moves.size());
    forAll(result, c)
    {
        result[c] = !moves[c].empty();
    }
    return result;
}


bool Foam::contactStep::near(const label a, const UList<bool>& marked) const
{
    bool result = marked[a];
    for (const label c : partners_[a])
    {
        result = result || marked[c];
    }
    return result;
}


void Foam::contactStep::couple(const motions& p, motions& Ap)
{
    const List<vectorField> moves(gatherVectors(p));
    const boolList some(moving(moves));

    forAll(coupled_, m)
    {
        const label a = clumpOf_[m];
        const label end = near(a, some) ? begins_[a + 1] : begins_[a];
        for (label k = begins_[a]; k < end; ++k)
        {
            const sphereContact& t = sphereContacts_[k];
            if (t.b < 0 || (t.w.force == 0 && t.w.stiffness == 0))
            {
                continue;
            }
            const vector other(ofImage(t, of(moves[t.otherIndex], t.j)));
            const vector relative(of(moves[a], t.i) - other);
            const scalar turning = t.w.force/max(t.radii - t.d, SMALL*t.R);
            const vector Cp
            (
                t.w.stiffness*(t.n & other)*t.n
              + turning*(relative - (t.n & relative)*t.n)
            );
            Ap[m].segment<3>(6*t.i) -= Eigen::Vector3d(Cp.x(), Cp.y(), Cp.z());
        }
    }
    if (rubs_)
    {
        coupleFriction(p, Ap);
    }
    if (gaps_.bonds())
    {
        coupleBonds(p, Ap);
    }
}


Foam::scalar Foam::contactStep::passable(const motions& step)
{
    const List<vectorField> moves(gatherVectors(step));
    const boolList some(moving(moves));

    // Up to half of a gap and a quarter of a radius nearer
    scalar part = 1;
    forAll(coupled_, m)
    {
        const label a = clumpOf_[m];
        const label end = near(a, some) ? begins_[a + 1] : begins_[a];
        for (label k = begins_[a]; k < end; ++k)
        {
            const sphereContact& t = sphereContacts_[k];
            vector dx(of(moves[a], t.i));
            if (t.b >= 0)
            {
                dx -= ofImage(t, of(moves[t.otherIndex], t.j));
            }
            const scalar distance = t.radii - t.d;
            const scalar nearer =
                t.b < 0
              ? -(t.n & dx)
              : distance - leastDistance(distance*t.n, dx);
            const scalar allowed = 0.5*max(-t.d, scalar(0)) + 0.25*t.R;
            if (nearer > allowed)
            {
                part = min(part, allowed/mag(dx));
            }
        }
    }
    return part;
}
