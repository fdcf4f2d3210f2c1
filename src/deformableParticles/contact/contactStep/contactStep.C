/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStep.H"
#include "vector2D.H"

Foam::contactStep::contactStep
(
    const polyMesh& mesh,
    const PtrList<clumpType>& types,
    const PtrList<clumpBonds>& bonds,
    const clumpContacts& contacts,
    const wallContacts& walls,
    const gapForces& gaps
)
:
    types_(types),
    gaps_(gaps),
    ghosts_(mesh),
    wholeDt_(0),
    dt_(0),
    mesh_(mesh),
    bonds_(bonds),
    contacts_(contacts),
    walls_(walls),
    range_(0),
    rubs_(contacts.laws().frictional() || walls.laws().frictional()),
    turns_(rubs_ || gaps.bonds())
{
    forget();
}


void Foam::contactStep::addCoupled(const label a)
{
    clumpParcel& p = clumps_[a];
    isCoupled_[a] = 1;
    clumpOf_.append(a);
    coupled_.append
    (
        {
            &bonds_[p.typeId()], &p.step().forces,
            &p.state(), &p.step().end, p.step().hasGuess, vectorField(),
            vectorField()
        }
    );
    forces_.append(vectorField(type(a).size(), Zero));
    torques_.append(vectorField(type(a).size(), Zero));
    energies_.append(0);
    nRenewed_.append(0);
}


Foam::scalar Foam::contactStep::clearance(const label a) const
{
    scalar result = GREAT;
    const label end = type(a).fixed() ? begins_[a] : begins_[a + 1];
    for (label k = begins_[a]; k < end && result >= 0; ++k)
    {
        const sphereContact& t = sphereContacts_[k];
        const vector dx(displacement(t));
        const scalar gap =
            t.b < 0
          ? min(min(t.wallNormal & dx, fromWall(t, dx)), scalar(0)) - t.radii
          : leastDistance(before(t), dx) - t.radii;
        result = min(result, gap - t.range);
    }
    return result;
}


void Foam::contactStep::addTouching(UList<bool>& together, const bool andNear)
{
    move(true);

    for (label a = 0; a < clumps_.size(); ++a)
    {
        if (!isCoupled_[a])
        {
            const scalar least = clearance(a);
            hasNewCoupled_ = hasNewCoupled_ || least < 0;
            together[a] = together[a] || least < (andNear ? margin(a) : 0);
            if (together[a])
            {
                addCoupled(a);
            }
        }
    }
}


bool Foam::contactStep::incomplete() const
{
    forAll(slacks_, a)
    {
        if (deviation(a) > slacks_[a] || (!isCoupled_[a] && clearance(a) < 0))
        {
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::contactStep::deviation(const label a) const
{
    scalar result = 0;
    if (!type(a).fixed() && type(a).ofSpheres())
    {
        const clumpState& start = clumps_[a].state();
        const clumpState& end = clumps_[a].step().end;
        // Those that wait for the others are still where the step began
        const bool solved = end.x != start.x;
        for (label i = 0; solved && i < start.x.size(); ++i)
        {
            result =
                max(result, mag(end.x[i] - start.x[i] - wholeDt_*start.u[i]));
        }
    }
    return result;
}


bool Foam::contactStep::mustSolve(const bool solved, bool& deviated)
{
    // Where some touched before in this step, they nearly always do so again
    deviated = false;
    if (solved || !touched_)
    {
        // One exchange for both
        vector2D any(hasNewCoupled_, 0);
        forAll(slacks_, a)
        {
            any.y() = any.y() > 0 || deviation(a) > slacks_[a];
        }
        reduce(any, maxOp<vector2D>());

        deviated = any.y() > 0;
        touched_ = any.x() > 0 || touched_;
        if (deviated || any.x() <= 0)
        {
            return false;
        }
    }
    hasNewCoupled_ = false;
    remote_.exchange(isCoupled_);
    return true;
}


void Foam::contactStep::widen()
{
    forAll(slacks_, a)
    {
        slacks_[a] = max(slacks_[a], 1.5*deviation(a));
    }
    search_.tooNarrow = true;
}


Foam::boolList Foam::contactStep::passing() const
{
    boolList result(clumps_.size(), false);
    for (const sphereContact& t : sphereContacts_)
    {
        if (t.b >= 0 && isCoupled_[t.a])
        {
            const vector x(before(t));
            const vector dx(displacement(t));
            result[t.a] =
                result[t.a]
             || (
                    ((x + dx) & x) < 0
                 && leastDistance(x, dx) < 0.5*t.radii
                );
        }
    }
    return result;
}


void Foam::contactStep::addReceived()
{
    forAll(coupled_, m)
    {
        // Those that only came near were not solved for where none touched
        externalForces& forces = clumps_[clumpOf_[m]].step().forces;
        if (coupled_[m].received.size())
        {
            forces.f += coupled_[m].received;
        }
        if (coupled_[m].receivedTorques.size())
        {
            forces.t += coupled_[m].receivedTorques;
        }
    }
}
