/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "couplingCoefficient.H"
#include "modelSelection.H"

namespace
{

using namespace Foam;

//- Coefficients of a scheme without the inertia of the fluid inside
scalarField viscous
(
    const couplingScheme& scheme,
    const clumpType& type,
    const scalar mu,
    const scalar rho,
    const scalar dt
)
{
    scalarField z, zR;
    scheme.coefficients(type, mu, rho, dt, z, zR);
    return z - rho*type.volumes()/dt;
}


//- Multiply coefficients z by a factor without their inertia
void raise(scalarField& z, const scalarField& inertia, const scalar factor)
{
    if (factor > 1)
    {
        z = inertia + factor*(z - inertia);
    }
}

}


Foam::couplingCoefficient::couplingCoefficient
(
    const PtrList<clumpType>& types,
    const immersedBoundary& boundary,
    const scalar rho,
    const dictionary& clumpProperties
)
:
    types_(types),
    boundary_(boundary),
    rho_(rho),
    scheme_
    (
        selectModel<couplingScheme>(getDict(clumpProperties, "couplingScheme"))
    )
{}


void Foam::couplingCoefficient::set
(
    const clumpParcel& p,
    const scalar mu,
    const scalar dt,
    externalForces& ext
) const
{
    const clumpType& type = types_[p.typeId()];
    scheme_->coefficients(type, mu, rho_, dt, ext.zeta, ext.zetaR);
    raise(ext.zeta, rho_/dt*type.volumes(), p.couplingFactor());
    raise(ext.zetaR, rho_/dt*type.volumeInertias(), p.couplingFactor());
}


void Foam::couplingCoefficient::anticipate
(
    clumpParcel& p,
    const scalar mu,
    const scalar dt
) const
{
    if (scheme_->damps())
    {
        clumpStep& step = p.step();
        scalar q;
        const scalar needed = neededRaise(p, mu, dt, q);

        // What other clumps did in one corrector they seldom do in two
        const scalar raise = min(needed, step.neededBefore);
        step.neededBefore = needed/raise;
        raiseFactor(p, raise);
    }
}


bool Foam::couplingCoefficient::adapt
(
    clumpParcel& p,
    const scalar mu,
    const scalar dt,
    const bool repeated
) const
{
    clumpStep& step = p.step();
    const vectorField now(step.end.u - step.imposedU);
    const vectorField& last = step.change;
    const scalar uu = sum(magSqr(step.end.u));
    const bool reverses = sum(now & last) < 0;
    const bool overshoots =
        reverses
     && sum(magSqr(now)) > 1e-6*uu
     && sum(magSqr(now)) > sum(magSqr(last));

    // A single one may be the change of an acceleration's sign, if small
    p.overshoots() = overshoots ? step.overshootsBefore + 1 : 0;
    const bool unstable =
        p.overshoots() > 1 || (overshoots && sum(magSqr(now)) > 0.01*uu);

    scalar& factor = p.couplingFactor();
    step.needsShorterStep =
        unstable && !(scheme_->damps() && factor < maxFactor);
    if (!scheme_->damps())
    {
        return false;
    }
    if (unstable)
    {
        scalar q;
        const scalar needed = neededRaise(p, mu, dt, q);
        if (p.overshoots() > 1 || explains(p, q))
        {
            const bool persists = p.overshoots() > 4;
            return raiseFactor(p, max(needed, scalar(persists ? 2 : 1)));
        }
        if (!repeated)
        {
            raiseFactor(p, min(needed, 2.0));
        }
    }
    else if (!reverses && !repeated)
    {
        factor = max(0.98*factor, 1.0);
    }
    return false;
}


bool Foam::couplingCoefficient::raiseFactor(clumpParcel& p, const scalar raise)
{
    scalar& factor = p.couplingFactor();
    if (raise <= 1 || factor >= maxFactor)
    {
        return false;
    }
    factor = min(raise*factor, maxFactor);
    p.step().raised = true;
    return true;
}


Foam::scalar Foam::couplingCoefficient::neededRaise
(
    const clumpParcel& p,
    const scalar mu,
    const scalar dt,
    scalar& q
) const
{
    q = 1;
    const clumpType& type = types_[p.typeId()];
    const clumpStep& step = p.step();
    const vectorField& d = step.imposedChange;
    const scalarField dd(magSqr(d));
    if (sum(dd) < 1e-6*sum(magSqr(step.imposedU)))
    {
        return 1;
    }

    const scalarField z
    (
        p.couplingFactor()*viscous(*scheme_, type, mu, rho_, dt)
    );
    const scalar own = sum(type.masses()*dd)/dt;
    const scalar inside = rho_*sum(type.volumes()*dd)/dt;
    const scalar inertia = own + inside;
    const scalar viscousResistance = max(sum(z*dd), VSMALL);
    vectorField Gd(step.lastFluidForces - p.fluidForces());
    if (boundary_.addsInteriorInertia())
    {
        Gd -= step.fadeFactor*rho_/dt*step.solidVolumes*d;
    }
    const scalar fluid = sum(Gd & d);

    q = (own + fluid)/max(inertia + viscousResistance, VSMALL);

    // The motion that a locked interior resists most is seldom d itself
    const scalar stiffest =
        !boundary_.dilates() && fluid > 0
      ? sum(magSqr(Gd)/(z + rho_*type.volumes()/dt))/fluid
      : q;
    const scalar most = max(q, stiffest);

    return
        most > 1.5
      ? min(most + (most - 1)*inertia/viscousResistance, maxRaise)
      : 1;
}


bool Foam::couplingCoefficient::explains
(
    const clumpParcel& p,
    const scalar q
) const
{
    const clumpStep& step = p.step();
    const vectorField& d = step.imposedChange;
    const scalar dd = sum(magSqr(d));
    const vectorField now(step.end.u - step.imposedU);
    const scalar growth = -sum(now & d)/max(dd, VSMALL);
    const bool moved = sum(magSqr(p.state().a)) > 0;
    const bool asAWhole =
        now.size()*magSqr(average(now)) > 0.5*sum(magSqr(now));

    return
        growth > 0.5*(q - 1) && growth < 2*(q - 1)
     && moved
     && (asAWhole || !boundary_.dilates())
     && dd > 1e-4*sum(magSqr(step.end.u));
}


void Foam::couplingCoefficient::report
(
    const Cloud<clumpParcel>& clumps,
    const label nClumps
)
{
    label nRaised = 0;
    scalar largest = 0;
    for (const clumpParcel& p : clumps)
    {
        if (p.step().raised)
        {
            ++nRaised;
            largest = max(largest, p.couplingFactor());
        }
    }
    reduce(nRaised, sumOp<label>());
    if (!nRaised)
    {
        return;
    }
    reduce(largest, maxOp<scalar>());

    Info<< "Coupling coefficient raised for " << nRaised << " of " << nClumps
        << " clumps, to at most " << largest << " times its value"
        << (largest < maxFactor ? "" : ", which is the limit") << endl;
}
