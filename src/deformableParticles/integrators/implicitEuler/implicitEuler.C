/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "implicitEuler.H"
#include "jointMinimiser.H"
#include "newtonMinimiser.H"

namespace
{
    //- Last step of Newton's method that needs no warning, in sphere radii
    constexpr Foam::scalar harmless = 1e-6;

    //- Iterations for a solution from which another outer corrector goes on, and the part
    //  of what they begin with below which there are no more. A few clumps of many need
    //  more. With 5 and 0.01, 1000 red cells took 7 % more outer correctors
    constexpr Foam::label few = 8;
    constexpr Foam::scalar rough = 0.003;
}

namespace Foam
{
namespace integrators
{
    defineTypeNameAndDebug(implicitEuler, 0);
    addToRunTimeSelectionTable(integrator, implicitEuler, dictionary);
}
}

Foam::integrators::implicitEuler::implicitEuler(const dictionary& dict)
:
    tolerance_(getBetween(dict, "tolerance", smallestEntry, 0.01)),
    maxIterations_(getNumber(dict, "maxIterations", 1, 100000))
{
    checkEntries(dict, {"type", "tolerance", "maxIterations"});
}


void Foam::integrators::implicitEuler::advance
(
    const clumpBonds& bonds,
    const externalForces& ext,
    const scalar dt,
    clumpState& s
) const
{
    const clumpType& type = bonds.type();
    const clumpState start(s);
    const incrementalPotential potential(bonds, ext, dt, start);

    // Start from the motion at the old velocities if its potential is lower than
    // that of the positions at the start, or of the prescribed motion alone
    clumpState rest(start);
    prescribe(type, ext, rest);
    const scalar W0 = potential.value(rest);
    predict(type, dt, ext, s);
    if (potential.value(s) > W0)
    {
        s.x = rest.x;
        s.q = rest.q;
    }

    newtonMinimiser newton(tolerance_, maxIterations_);
    if (!newton.minimise(potential, s) && newton.lastStep() > harmless)
    {
        WarningInFunction
            << "Newton's method did not converge for a clump of type "
            << type.name() << ": after " << newton.nIterations()
            << " iterations the last step is " << newton.lastStep()
            << " sphere radii." << endl;
    }

    setVelocities(type, ext, dt, start, s);
    potential.forces().breakBonds(s);
}


Foam::label Foam::integrators::implicitEuler::advance
(
    clumpInteraction& group,
    const scalar dt
) const
{
    group.begin(dt);
    const label nSolves = solve(group, dt, group.endsStep || group.turns());
    breakBonds(group);
    return nSolves;
}


Foam::label Foam::integrators::implicitEuler::solve
(
    clumpInteraction& group,
    const scalar dt,
    const bool exact
) const
{
    UList<clumpInteraction::coupledClump>& clumps = group.coupledClumps();

    clumpInteraction::motions steps;
    for (const clumpInteraction::coupledClump& m : clumps)
    {
        const clumpState& start = *m.start;
        clumpState& s = *m.end;
        steps.push_back(Eigen::VectorXd::Zero(6*start.x.size()));
        if (!m.hasGuess)
        {
            if (s.x == start.x)
            {
                predict(m.bonds->type(), dt, *m.ext, s);
            }
            forAll(s.x, i)
            {
                const vector dx(s.x[i] - start.x[i]);
                const vector phi
                (
                    rotationVector(s.q[i]*conjugate(start.q[i]))
                );
                steps.back().segment<6>(6*i) <<
                    dx.x(), dx.y(), dx.z(), phi.x(), phi.y(), phi.z();
            }
            if (!m.ext->turned && m.ext->moved == vector::zero)
            {
                s = start;
            }
        }
    }

    const label most = exact ? maxIterations_ : min(maxIterations_, few);
    const scalar reduction = exact ? 0 : rough;

    // Friction is found by several solutions with an ever sharper corner
    jointMinimiser newton(group, dt, tolerance_, most);
    newton.predict(steps);
    bool converged = newton.minimise(reduction);
    for (label n = 0; exact && n < 10; ++n)
    {
        if (!newton.resume(group.redistribute()))
        {
            group.restore();
            break;
        }
        converged = newton.minimise(reduction);
    }
    group.complete = newton.complete();
    if (exact && !converged && newton.lastStep() > harmless && Pstream::master())
    {
        WarningInFunction
            << "Newton's method did not converge for the clumps that touch each"
            << " other or a wall: after " << maxIterations_
            << " iterations the last step is " << newton.lastStep()
            << " sphere radii. So large an error remains in their positions; a"
            << " shorter time step, or a softer contact, converges better." << endl;
    }

    forAll(clumps, m)
    {
        clumpInteraction::coupledClump& clump = clumps[m];
        clump.received = group.forces(m);
        clump.hasGuess = true;
        externalForces ext(*clump.ext);
        ext.f += clump.received;
        if (group.turns())
        {
            clump.receivedTorques = group.torques(m);
            ext.t += clump.receivedTorques;
        }
        setVelocities
        (
            clump.bonds->type(), ext, dt, *clump.start, *clump.end
        );
    }
    return newton.nSolves();
}


void Foam::integrators::implicitEuler::setVelocities
(
    const clumpType& type,
    const externalForces& ext,
    const scalar dt,
    const clumpState& start,
    clumpState& s
)
{
    forAll(s.x, i)
    {
        s.u[i] = (s.x[i] - start.x[i])/dt;
        s.w[i] = rotationVector(s.q[i]*conjugate(start.q[i]))/dt;
    }
    balanceMomentum(type, ext, dt, start, s);
}


void Foam::integrators::implicitEuler::predict
(
    const clumpType& type,
    const scalar dt,
    const externalForces& ext,
    clumpState& s
)
{
    const vector velocity(s.velocity(type));
    const vector freely(dt*(velocity - (ext.held & velocity)));
    if (ext.turned)
    {
        prescribe(type, ext, s);
        s.x += freely;
        return;
    }
    const point centre(s.centre(type));
    const vector omega(s.angularVelocity(type));
    const quaternion turn(rotation(dt*omega));
    const tensor R(turn.R());

    // A velocity is the displacement of the last step over its time, hence the
    // velocity in the middle of that step
    const tensor half(rotation(0.5*dt*omega).R());

    forAll(s.x, i)
    {
        const vector r(s.x[i] - centre);
        const vector deformation
        (
            (half & (s.u[i] - velocity)) - (omega ^ r)
        );
        s.x[i] = centre + ext.moved + freely + (R & (r + dt*deformation));
        s.q[i] = turn*rotation(dt*(s.w[i] - omega))*s.q[i];
    }
}
