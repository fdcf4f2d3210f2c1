/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "velocityVerlet.H"
#include "foamCompat.H"

namespace Foam
{
namespace integrators
{
    defineTypeNameAndDebug(velocityVerlet, 0);
    addToRunTimeSelectionTable(integrator, velocityVerlet, dictionary);
}
}


Foam::integrators::velocityVerlet::velocityVerlet(const dictionary& dict)
:
    stepFraction_(getBetween(dict, "stepFraction", 1e-6, 1))
{
    checkEntries(dict, {"type", "stepFraction"});
}


Foam::scalar Foam::integrators::velocityVerlet::stableStep
(
    const clumpBonds& bonds,
    const externalForces& ext,
    const pointField& x
) const
{
    const clumpType& type = bonds.type();
    const label n = type.size();
    scalarField K(n, Zero), C(ext.zeta), S(n, Zero), D(ext.zetaR);

    forAll(K, i)
    {
        K[i] = tr(ext.k[i]);
    }

    for (const clumpBonds::bond& b : bonds.bonds())
    {
        const scalar arm2 = sqr(0.5*b.length);
        const bondCoefficients& k = b.stiffness;
        const bondCoefficients& c = b.damping;

        for (const label i : {b.i, b.j})
        {
            K[i] += 2*max(k.normal, k.tangential);
            C[i] += 2*max(c.normal, c.tangential);
            S[i] += 2*(max(k.bending, k.torsional) + arm2*k.tangential);
            D[i] += 2*(max(c.bending, c.torsional) + arm2*c.tangential);
        }
    }

    for (const conservationModel& model : bonds.conservation())
    {
        vectorField grad(n);
        model.steepest(x, grad);
        K += model.stiffness()*sum(mag(grad))*mag(grad);
    }

    scalar result = GREAT;
    for (label i = 0; i < n; ++i)
    {
        const scalar m = type.masses()[i];
        const scalar I = type.inertias()[i];
        result = min(result, 2*Foam::sqrt(m/max(K[i], VSMALL)));
        result = min(result, 2*Foam::sqrt(I/max(S[i], VSMALL)));
        result = min(result, 2*m/max(C[i], VSMALL));
        result = min(result, 2*I/max(D[i], VSMALL));
    }

    return stepFraction_*result;
}


void Foam::integrators::velocityVerlet::advance
(
    const clumpBonds& bonds,
    const externalForces& ext,
    const scalar dt,
    clumpState& s
) const
{
    const clumpType& type = bonds.type();
    const bondForces internal(bonds);
    const pointField x0(s.x);
    vectorField F(type.size()), T(type.size());

    const scalar stable = stableStep(bonds, ext, s.x);
    const label nSub = dt > stable ? label(std::ceil(dt/stable)) : 1;
    const scalar h = dt/nSub;

    const auto updateForces = [&]()
    {
        internal.explicitForces(s, F, T);
        forAll(F, i)
        {
            F[i] +=
                ext.f[i] - (ext.k[i] & (s.x[i] - x0[i]))
              - ext.zeta[i]*(s.u[i] - ext.imposedU[i]);
            T[i] += ext.t[i] - ext.zetaR[i]*(s.w[i] - ext.imposedW[i]);
        }
        F -= type.masses()/type.mass()*(ext.held & sum(F));
    };

    const auto accelerate = [&]()
    {
        forAll(F, i)
        {
            s.u[i] += 0.5*h/type.masses()[i]*F[i];
            s.w[i] += 0.5*h/type.inertias()[i]*T[i];
        }
    };

    s.u -= ext.held & s.velocity(type);
    updateForces();
    for (label sub = 0; sub < nSub; ++sub)
    {
        accelerate();
        forAll(s.x, i)
        {
            s.x[i] += h*s.u[i];

            // Rotation by Cayley's map, which has the second order of the method
            s.q[i] = quaternion(1, 0.5*h*s.w[i])*s.q[i];
            normalise(s.q[i]);
        }
        updateForces();
        accelerate();
    }
    internal.breakBonds(s);
}


Foam::label Foam::integrators::velocityVerlet::advance
(
    clumpInteraction& group,
    const scalar dt
) const
{
    UList<clumpInteraction::coupledClump>& clumps = group.coupledClumps();
    label nSolves = 0;

    forAll(clumps, m)
    {
        *clumps[m].end = *clumps[m].start;
        clumps[m].received = vectorField(clumps[m].start->x.size(), Zero);
    }

    // What acts between the clumps is constant over every part of the step
    for (scalar left = dt; left > 0; )
    {
        group.evaluate();
        group.redistribute();
        group.beginMoving(left);
        group.evaluate();

        scalar h = left;
        List<externalForces> ext(clumps.size());
        forAll(clumps, m)
        {
            const clumpInteraction::coupledClump& clump = clumps[m];
            const clumpState& s = *clump.end;
            ext[m] = *clump.ext;
            vectorField added(group.forces(m));
            const vectorField moved(s.x - clump.start->x);
            added -= ext[m].k & moved;
            ext[m].f += added;

            externalForces all(ext[m]);
            all.k += group.stiffness(m);
            h = min(h, stableStep(*clump.bonds, all, s.x));
        }
        reduce(h, minOp<scalar>());

        forAll(clumps, m)
        {
            clumpInteraction::coupledClump& clump = clumps[m];
            advance(*clump.bonds, ext[m], h, *clump.end);
            clump.received += h/dt*group.forces(m);
            ++nSolves;
        }
        left = h < left ? left - h : 0;
    }

    return nSolves;
}
