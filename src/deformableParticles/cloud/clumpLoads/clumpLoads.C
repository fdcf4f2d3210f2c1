/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpLoads.H"
#include "bondFrame.H"
#include "checkedEntries.H"
#include "integrator.H"
#include "modelSelection.H"

namespace
{
    //- In a step [rad]: beyond pi, a rotation is that in the other direction
    constexpr Foam::scalar largestTurn = 1;
}


Foam::clumpLoads::clumpLoads
(
    const fvMesh& mesh,
    const PtrList<clumpType>& types
)
:
    mesh_(mesh),
    types_(types)
{}


void Foam::clumpLoads::read
(
    const dictionary* dict,
    const HashTable<label>& typeIds
)
{
    held_.setSize(types_.size(), symmTensor(Zero));
    moves_.setSize(types_.size(), false);
    turns_.setSize(types_.size(), false);
    if (!dict)
    {
        return;
    }
    for (const word& name : dict->toc())
    {
        const dictionary& d = getDict(*dict, name);
        loads_.append(selectModel<load>(d));

        const load& added = loads_.last();
        bool some = false;
        forAll(types_, i)
        {
            if (added.actsOn(types_[i]))
            {
                added.check(d, types_[i].size());
                constrain(d, i);
                some = true;
            }
        }
        if (!some)
        {
            FatalIOErrorInLookup(d, "clumpType", added.loadedType(), typeIds)
                << exit(FatalIOError);
        }
        added.field(mesh_);
    }
}


void Foam::clumpLoads::constrain(const dictionary& dict, const label typei)
{
    const load& l = loads_.last();
    const symmTensor along(l.constraint());
    const clumpType& type = types_[typei];
    if (tr(along) <= 0 && !l.turns())
    {
        return;
    }
    if (!type.ofSpheres())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'clumpType': " << type.name() << " is no clump of spheres;"
            << " the load " << l.type() << " cannot " << l.type()
            << " it: its force would depend on the time step."
            << exit(FatalIOError);
    }
    if ((tr(held_[typei]) > 0 && tr(along) > 0) || (turns_[typei] && l.turns()))
    {
        FatalIOErrorInFunction(dict)
            << "Clump type " << type.name() << " has two loads of the types hold and"
            << " move for its centre, or two that turn it: give all directions to one of"
            << " them." << exit(FatalIOError);
    }
    if (type.fixed() && l.moves())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'clumpType': clump type " << type.name() << " has the entry 'motion"
            << " fixed'. The load " << l.type() << " needs 'motion free'."
            << exit(FatalIOError);
    }
    if (!type.fixed())
    {
        held_[typei] += along;
        moves_[typei] = moves_[typei] || (l.moves() && tr(along) > 0);
        turns_[typei] = turns_[typei] || l.turns();
    }
}


void Foam::clumpLoads::sample(ghostExchange& ghosts)
{
    for (load& l : loads_)
    {
        l.sample(mesh_, ghosts);
    }
}


void Foam::clumpLoads::add
(
    const load& l,
    const clumpParcel& p,
    const label index,
    externalForces& ext
) const
{
    const clumpType& type = types_[p.typeId()];
    if (l.actsOn(type))
    {
        l.add
        (
            load::site
            {
                mesh_, type, p.state(), p.unwrappedCentres(), l.values(index)
            },
            ext
        );
    }
}


void Foam::clumpLoads::add
(
    const clumpParcel& p,
    const label index,
    externalForces& ext
) const
{
    for (const load& l : loads_)
    {
        add(l, p, index, ext);
    }
}


Foam::vector Foam::clumpLoads::steadyForce
(
    const clumpParcel& p,
    const label index
) const
{
    vector result(Zero);
    for (const load& l : loads_)
    {
        externalForces ext(types_[p.typeId()].size());
        add(l, p, index, ext);
        if (max(mag(ext.k)) == 0)
        {
            result += sum(ext.f);
        }
    }
    return result;
}


Foam::symmTensor Foam::clumpLoads::held() const
{
    symmTensor result(Zero);
    for (const load& l : loads_)
    {
        result += l.holds() ? symmTensor(I) : l.constraint();
    }
    return result;
}


void Foam::clumpLoads::prescribe
(
    const label typei,
    const scalar from,
    const scalar dt,
    externalForces& ext
) const
{
    ext.held = held(typei);
    if (!move(typei))
    {
        return;
    }
    const clumpType& whole = types_[types_[typei].whole(typei)];
    for (const load& l : loads_)
    {
        if (l.moves() && l.actsOn(whole))
        {
            l.prescribe(from, from + dt, ext);
        }
    }
}


void Foam::clumpLoads::impose
(
    const clumpParcel& p,
    const scalar dt,
    vectorField& u,
    vectorField& w
) const
{
    const clumpType& type = types_[p.typeId()];
    const clumpState& start = p.state();
    externalForces ext;
    prescribe(p.typeId(), mesh_.time().value() - dt, dt, ext);

    clumpState imposed(start);
    imposed.u = u;
    const vector velocity(imposed.velocity(type));
    const vector change(ext.moved/dt - (ext.held & velocity));
    if (!ext.turned)
    {
        u += change;
        return;
    }
    const point centre(start.centre(type));
    const tensor turned(rotation(ext.turn).R() - tensor::I);
    forAll(u, i)
    {
        u[i] = velocity + change + (turned & (start.x[i] - centre))/dt;
    }
    w = ext.turn/dt;
}


void Foam::clumpLoads::addConstraint(clumpParcel& p, const scalar dt) const
{
    clumpStep& step = p.step();
    externalForces& ext = step.forces;
    step.constraintForce = Zero;
    step.constraintTorque = Zero;
    const symmTensor& along = ext.held;
    if (tr(along) <= 0 && !ext.turned)
    {
        return;
    }
    const clumpType& ct = types_[p.typeId()];
    const clumpState& start = p.state();
    clumpState& end = step.end;

    if (mag(ext.turn) > largestTurn)
    {
        FatalErrorInFunction
            << "A load turns clumps of type " << ct.name() << " by " << mag(ext.turn)
            << " rad in a step of " << dt << " s. Choose a step of at most "
            << dt*largestTurn/mag(ext.turn) << " s." << exit(FatalError);
    }

    // The balance of angular momentum and rounding have left something of the motion
    const point centre0(start.centre(ct));
    const vector du(ext.moved/dt - (along & end.velocity(ct)));
    const vector dx(ext.moved - (along & (end.centre(ct) - centre0)));
    if (ext.turned)
    {
        const vector velocity(end.velocity(ct) + du);
        externalForces motion;
        motion.turned = true;
        motion.turn = ext.turn;
        motion.moved = end.centre(ct) - centre0 + dx;
        clumpState exact(start);
        integrator::prescribe(ct, motion, exact);
        end.x = exact.x;
        end.q = exact.q;
        end.u = velocity + (end.x - start.x - motion.moved)/dt;
        end.w = ext.turn/dt;
    }
    else
    {
        end.u += du;
        end.x += dx;
    }

    const scalarField& m = ct.masses();
    const vectorField outside
    (
        (ext.k & (end.x - start.x)) + ext.zeta*(end.u - ext.imposedU) - ext.f
    );
    const vector H(along & sum(m/dt*(end.u - start.u) + outside));
    ext.f += m/ct.mass()*H;
    step.constraintForce = H;
    if (!ext.turned)
    {
        return;
    }

    const scalarField& J = ct.inertias();
    const vectorField r0(start.x - centre0);
    const vectorField r(end.x - end.centre(ct));
    vector Q(Zero);
    forAll(r, i)
    {
        Q +=
            (r[i] ^ outside[i])
          + m[i]/dt*((r[i] ^ end.u[i]) - (r0[i] ^ start.u[i]))
          + J[i]/dt*(end.w[i] - start.w[i])
          + ext.zetaR[i]*(end.w[i] - ext.imposedW[i]) - ext.t[i];
    }
    ext.t += J/sum(J)*Q;
    step.constraintTorque = Q;
}
