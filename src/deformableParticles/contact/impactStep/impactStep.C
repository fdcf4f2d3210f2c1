/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "impactStep.H"
#include "bondForces.H"
#include "foamCompat.H"

namespace
{

using namespace Foam;

//- Part of the energy by which rounding may change it
constexpr scalar rounding = 1e-11;


//- What moves a coupled clump in the parts of a step
struct coupledParts
{
    clumpInteraction::coupledClump given;
    const scalar dt;

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
    clumpInteraction::coupledClump firstStage;

    //- Of the contacts over the step so far, over its length: forces, torques, and the
    //  torque of the forces about the centre of mass
    vectorField received;
    vectorField receivedTorques;
    vector moment;

    coupledParts(const clumpInteraction::coupledClump& m, const scalar step)
    :
        given(m),
        dt(step),
        ext(*m.ext),
        f(ext.f - ext.zeta*(m.start->u - ext.imposedU)),
        mass(dt*ext.zeta),
        inertia(dt*ext.zetaR),
        begin(*m.start),
        firstStage(m),
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
        ext.moved = h/dt*given.ext->moved;
        ext.turn = h/dt*given.ext->turn;
    }

    void receive(const clumpInteraction::coupledClump& m, const scalar fraction)
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
    void goBeyond(const clumpInteraction::coupledClump& m, const scalar factor)
    {
        first = *m.end;
        firstStage = m;
        firstStage.end = &first;
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
        const clumpInteraction::coupledClump& second, const scalar g
    ) const
    {
        return second.received + (1 - g)/g*firstStage.received;
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


Foam::label Foam::impactStep::advance(const integrator& method, const scalar dt)
{
    return
        bounces_ && method.implicit()
      ? advanceInParts(method, dt)
      : method.advance(*this, dt);
}


Foam::contactSummary Foam::impactStep::summary() const
{
    contactSummary result(contactStep::summary());
    if (inPart_)
    {
        result.virial = virial_;
    }
    return result;
}


Foam::label Foam::impactStep::advanceInParts
(
    const integrator& method,
    const scalar dt
)
{
    const scalar g = 1 - Foam::sqrt(0.5);
    begin(dt);
    virial_ = Zero;
    UList<coupledClump>& clumps = coupledClumps();

    // The force that moves a clump does work
    bool worked = false;

    PtrList<coupledParts> parts(clumps.size());
    forAll(clumps, m)
    {
        const externalForces& ext = *clumps[m].ext;
        worked = worked || ext.turned || ext.moved != vector::zero;
        parts.set(m, new coupledParts(clumps[m], dt));
        clumps[m].start = &parts[m].start;
        clumps[m].ext = &parts[m].ext;
        *clumps[m].end = parts[m].begin;
    }

    reduce(worked, orOp<bool>());

    label nSolves = 0;
    bool allComplete = true;
    const auto solveStage = [&](const scalar h)
    {
        forAll(clumps, m)
        {
            *clumps[m].end = parts[m].start;
            clumps[m].hasGuess = false;
            parts[m].setForces(h);
        }
        beginStage(h);
        nSolves += method.advanceStage(*this, h);
        allComplete = allComplete && complete;
    };
    const auto energy = [&]()
    {
        scalar result = elasticEnergy();
        forAll(clumps, m)
        {
            result += parts[m].energy(*clumps[m].end);
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
            forAll(clumps, m)
            {
                power += sum(parts[m].impulses(clumps[m], g) & clumps[m].end->u);
            }
            reduce(power, sumOp<scalar>());
            if (gain >= 0.1*g*h*mag(power))
            {
                return false;
            }
            const scalar part = gain/(g*h*power);
            forAll(clumps, m)
            {
                coupledClump& clump = clumps[m];
                clump.received -= part*parts[m].impulses(clump, g);
                externalForces ext(parts[m].ext);
                ext.f += clump.received;
                integrator::balanceMomentum
                (
                    clump.bonds->type(), ext, g*h, parts[m].start, *clump.end
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
        endStage((1 - g)*h/dt);
        forAll(clumps, m)
        {
            parts[m].goBeyond(clumps[m], (1 - g)/g);
        }
        solveStage(g*h);
        endStage(g*h/dt);
        if (!turns() && !worked && !keepEnergy(before, h))
        {
            return false;
        }
        forAll(clumps, m)
        {
            parts[m].receive(parts[m].firstStage, (1 - g)*h/dt);
            parts[m].receive(clumps[m], g*h/dt);
        }
        return true;
    };

    for (scalar left = dt; left > 0; )
    {
        forAll(clumps, m)
        {
            parts[m].begin = *clumps[m].end;
            parts[m].start = parts[m].begin;
        }
        bool resolves = false;
        const scalar h = part(left, resolves);
        if (!resolves || !inStages(h))
        {
            forAll(clumps, m)
            {
                parts[m].start = parts[m].begin;
            }
            solveStage(h);
            endStage(resolves ? 0 : h/dt);
            forAll(clumps, m)
            {
                parts[m].receive(clumps[m], h/dt);
            }
        }
        integrator::breakBonds(*this);
        left = h < left ? left - h : 0;
    }
    complete = allComplete;

    forAll(clumps, m)
    {
        coupledClump& clump = clumps[m];
        coupledParts& p = parts[m];
        const clumpType& type = clump.bonds->type();
        clump.start = p.given.start;
        clump.ext = p.given.ext;
        clump.hasGuess = true;
        clump.received = p.received;
        clump.receivedTorques = p.receivedTorques;

        // The forces act at the end, for the balance over the step
        const point centre(clump.end->centre(type));
        const vectorField arms(clump.end->x - centre);
        const vector there(sum(arms ^ p.received));
        clump.receivedTorques +=
            type.inertias()/sum(type.inertias())*(p.moment - there);

        externalForces ext(*clump.ext);
        ext.f += clump.received;
        ext.t += clump.receivedTorques;
        integrator::balanceMomentum(type, ext, dt, *clump.start, *clump.end);
    }
    return nSolves;
}
