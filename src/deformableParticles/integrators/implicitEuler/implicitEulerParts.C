/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "implicitEuler.H"
#include "bondForces.H"
#include "foamCompat.H"

namespace
{

using namespace Foam;

//- Part of the energy by which rounding may change it
constexpr scalar rounding = 1e-11;


//- What moves a member in the parts of a step
struct memberParts
{
    clumpInteraction::member given;

    //- Forces of the stages, constant in them, and without their stiffness
    externalForces ext;
    vectorField f;

    //- What the coupling adds to mass and inertia
    scalarField mass;
    scalarField inertia;

    //- State at the start of the part, of the stage, and at the end of the first one
    clumpState begin;
    clumpState start;
    clumpState first;
    clumpInteraction::member ofFirst;

    //- Of the contacts over the step so far, over its length: forces, torques, and the
    //  torque of the forces about the centre of mass
    vectorField received;
    vectorField receivedTorques;
    vector moment;

    memberParts(const clumpInteraction::member& m, const scalar dt)
    :
        given(m),
        ext(*m.ext),
        f(ext.f - ext.zeta*(m.start->u - ext.imposedU)),
        mass(dt*ext.zeta),
        inertia(dt*ext.zetaR),
        begin(*m.start),
        ofFirst(m),
        received(f.size(), Zero),
        receivedTorques(f.size(), Zero),
        moment(Zero)
    {
        ext.f = f;
        ext.t -= ext.zetaR*(m.start->w - ext.imposedW);
    }

    //- Begin a stage of h [s]
    void setForces(const scalar h)
    {
        const vectorField moved(start.x - given.start->x);
        ext.f = f - (ext.k & moved);
        ext.zeta = mass/h;
        ext.zetaR = inertia/h;
        ext.imposedU = start.u;
        ext.imposedW = start.w;
    }

    void receive(const clumpInteraction::member& m, const scalar fraction)
    {
        const point centre(m.end->centre(m.bonds->type()));
        forAll(received, i)
        {
            const vector F(fraction*m.received[i]);
            received[i] += F;
            moment += (m.end->x[i] - centre) ^ F;
            if (m.receivedTorques.size())
            {
                receivedTorques[i] += fraction*m.receivedTorques[i];
            }
        }
    }

    //- Begin the second stage, so much further beyond the first one as that went
    void goBeyond(const clumpInteraction::member& m, const scalar factor)
    {
        first = *m.end;
        ofFirst = m;
        ofFirst.end = &first;
        forAll(start.x, i)
        {
            start.x[i] = begin.x[i] + factor*(first.x[i] - begin.x[i]);
            start.u[i] = begin.u[i] + factor*(first.u[i] - begin.u[i]);
            start.w[i] = begin.w[i] + factor*(first.w[i] - begin.w[i]);
            start.q[i] =
                rotation
                (
                    factor*rotationVector(first.q[i]*conjugate(begin.q[i]))
                )
               *begin.q[i];
            normalise(start.q[i]);
        }
    }

    //- Of the contacts in both stages, over the length of the second [N]
    vectorField impulses
    (
        const clumpInteraction::member& second, const scalar g
    ) const
    {
        return second.received + (1 - g)/g*ofFirst.received;
    }

    //- Kinetic and elastic energy, less the work of the given forces since the start of
    //  the step [J]
    scalar energy(const clumpState& s) const
    {
        const clumpType& type = given.bonds->type();
        vectorField F(type.size()), T(type.size());
        const vectorField dx(s.x - given.start->x);
        scalar result =
            s.kineticEnergy(type)
          + 0.5*sum(mass*magSqr(s.u)) + 0.5*sum(inertia*magSqr(s.w))
          + bondForces(*given.bonds, s).stepForces(s, -1, F, T);
        forAll(dx, i)
        {
            result -= (f[i] - 0.5*(ext.k[i] & dx[i])) & dx[i];
            result -=
                ext.t[i]
              & rotationVector(s.q[i]*conjugate(given.start->q[i]));
        }
        return result;
    }
};

}


Foam::label Foam::integrators::implicitEuler::advanceInParts
(
    clumpInteraction& group,
    const scalar dt
) const
{
    const scalar g = 1 - Foam::sqrt(0.5);
    UList<clumpInteraction::member>& members = group.members();

    PtrList<memberParts> parts(members.size());
    forAll(members, m)
    {
        parts.set(m, new memberParts(members[m], dt));
        members[m].start = &parts[m].start;
        members[m].ext = &parts[m].ext;
        *members[m].end = parts[m].begin;
    }

    label nSolves = 0;
    bool complete = true;
    const auto solveStage = [&](const scalar h)
    {
        forAll(members, m)
        {
            *members[m].end = parts[m].start;
            members[m].guessed = false;
            parts[m].setForces(h);
        }
        group.beginStage(h);
        nSolves += solve(group, h, true);
        complete = complete && group.complete;
    };
    const auto energy = [&]()
    {
        scalar result = group.elasticEnergy();
        forAll(members, m)
        {
            result += parts[m].energy(*members[m].end);
        }
        return returnReduce(result, sumOp<scalar>());
    };

    // Change the impulses of the contacts by less than a tenth where a part would gain
    // energy
    const auto keepEnergy = [&](const scalar before, const scalar h)
    {
        for (label n = 0; n < 6; ++n)
        {
            const scalar after = energy();
            const scalar gain = after - before;
            if (gain <= rounding*(mag(before) + mag(after)))
            {
                return true;
            }
            scalar power = 0;
            forAll(members, m)
            {
                power += sum(parts[m].impulses(members[m], g) & members[m].end->u);
            }
            reduce(power, sumOp<scalar>());
            if (gain >= 0.1*g*h*mag(power))
            {
                return false;
            }
            const scalar part = gain/(g*h*power);
            forAll(members, m)
            {
                clumpInteraction::member& member = members[m];
                member.received -= part*parts[m].impulses(member, g);
                externalForces ext(parts[m].ext);
                ext.f += member.received;
                balanceMomentum
                (
                    member.bonds->type(), ext, g*h, parts[m].start, *member.end
                );
            }
        }
        return false;
    };

    // A part of two stages; false where it gains energy
    const auto inStages = [&](const scalar h)
    {
        const scalar before = energy();
        solveStage(g*h);
        group.endStage((1 - g)*h/dt);
        forAll(members, m)
        {
            parts[m].goBeyond(members[m], (1 - g)/g);
        }
        solveStage(g*h);
        group.endStage(g*h/dt);
        if (!group.turns() && !keepEnergy(before, h))
        {
            return false;
        }
        forAll(members, m)
        {
            parts[m].receive(parts[m].ofFirst, (1 - g)*h/dt);
            parts[m].receive(members[m], g*h/dt);
        }
        return true;
    };

    for (scalar left = dt; left > 0; )
    {
        forAll(members, m)
        {
            parts[m].begin = *members[m].end;
            parts[m].start = parts[m].begin;
        }
        bool resolves = false;
        const scalar h = group.part(left, resolves);
        if (!resolves || !inStages(h))
        {
            forAll(members, m)
            {
                parts[m].start = parts[m].begin;
            }
            solveStage(h);
            group.endStage(resolves ? 0 : h/dt);
            forAll(members, m)
            {
                parts[m].receive(members[m], h/dt);
            }
        }
        breakBonds(group);
        left = h < left ? left - h : 0;
    }
    group.complete = complete;

    forAll(members, m)
    {
        clumpInteraction::member& member = members[m];
        memberParts& p = parts[m];
        const clumpType& type = member.bonds->type();
        member.start = p.given.start;
        member.ext = p.given.ext;
        member.guessed = true;
        member.received = p.received;
        member.receivedTorques = p.receivedTorques;

        // The forces act at the end, for the balance over the step
        const point centre(member.end->centre(type));
        const vectorField arms(member.end->x - centre);
        const vector there(sum(arms ^ p.received));
        member.receivedTorques +=
            type.inertias()/sum(type.inertias())*(p.moment - there);

        externalForces ext(*member.ext);
        ext.f += member.received;
        ext.t += member.receivedTorques;
        balanceMomentum(type, ext, dt, *member.start, *member.end);
    }
    return nSolves;
}
