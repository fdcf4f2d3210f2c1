/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "integrator.H"
#include "bondForces.H"
#include "foamCompat.H"

namespace Foam
{
    defineTypeNameAndDebug(integrator, 0);
    defineRunTimeSelectionTable(integrator, dictionary);
}


void Foam::integrator::breakBonds(clumpInteraction& group)
{
    for (clumpInteraction::coupledClump& clump : group.coupledClumps())
    {
        if (clump.bonds->breakable())
        {
            bondForces(*clump.bonds).breakBonds(*clump.end);
        }
    }
}


void Foam::integrator::balanceMomentum
(
    const clumpType& type,
    const externalForces& ext,
    const scalar dt,
    const clumpState& start,
    clumpState& s
)
{
    const point centre0(start.centre(type));
    const point centre(s.centre(type));

    // Impulses that are missing in the balance, and the inertia that they act on
    vector P(Zero), L(Zero), S(Zero);
    scalar M = 0;
    tensor I(Zero);

    forAll(s.x, i)
    {
        const scalar m = type.masses()[i];
        const scalar z = ext.zeta[i]*dt;
        const scalar J = type.inertias()[i];
        const scalar JR = ext.zetaR[i]*dt;
        const vector r0(start.x[i] - centre0);
        const vector r(s.x[i] - centre);
        const vector impulse
        (
            dt*(ext.f[i] - (ext.k[i] & (s.x[i] - start.x[i])))
          - z*(s.u[i] - ext.imposedU[i])
        );

        P += impulse - m*(s.u[i] - start.u[i]);
        L +=
            (r ^ impulse) - m*((r ^ s.u[i]) - (r0 ^ start.u[i]))
          + dt*ext.t[i] - J*(s.w[i] - start.w[i])
          - JR*(s.w[i] - ext.imposedW[i]);

        M += m + z;
        S += (m + z)*r;
        I += ((m + z)*magSqr(r) + J + JR)*tensor::I - (m + z)*(r*r);
    }

    // What is missing where the centre is held or moved is the force that does so, and
    // likewise the torque that turns the clump
    P -= ext.held & P;

    // About the centre of that inertia, as zeta need not be proportional to m
    const vector c(S/M);
    L -= c ^ P;
    I -= M*(magSqr(c)*tensor::I - c*c);

    const vector du(P/M);
    const scalar scale = tr(I);
    const vector dw(ext.turned ? vector::zero : (inv(I/scale) & (L/scale)));

    forAll(s.x, i)
    {
        s.u[i] += du + (dw ^ (s.x[i] - centre - c));
        s.w[i] += dw;
    }
}


void Foam::integrator::prescribe
(
    const clumpType& type,
    const externalForces& ext,
    clumpState& s
)
{
    if (!ext.turned)
    {
        s.x += ext.moved;
        return;
    }
    const point centre(s.centre(type));
    const quaternion turn(rotation(ext.turn));
    const tensor R(turn.R());
    forAll(s.x, i)
    {
        s.x[i] = centre + ext.moved + (R & (s.x[i] - centre));
        s.q[i] = turn*s.q[i];
        normalise(s.q[i]);
    }
}
