/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondForces.H"
#include "bondTangent.H"

namespace
{

using namespace Foam;

//- True when a bond of the clump has broken
bool broken(const clumpState& s, const label bondi)
{
    return s.broken.size() && s.broken[bondi] > 0;
}


bondFrame frameOf(const clumpBonds::bond& b, const clumpState& s)
{
    return bondFrame(s.x[b.i], s.x[b.j], s.q[b.i], s.q[b.j]);
}

}


Foam::bondForces::bondForces(const clumpBonds& bonds)
:
    bonds_(bonds),
    damping_(bonds),
    grad_(bonds.type().size(), Zero)
{}


Foam::bondForces::bondForces(const clumpBonds& bonds, const clumpState& start)
:
    bondForces(bonds)
{
    forAll(bonds_.bonds(), bi)
    {
        damping_.setStart(bi, frameOf(bonds_.bonds()[bi], start));
    }
}


Foam::bondResponse Foam::bondForces::elastic
(
    const label bondi,
    const bondFrame& frame
) const
{
    return bondResponse
    (
        bonds_.law(), bonds_.bonds()[bondi], frame.d(), frame.psi()
    );
}


Foam::scalar Foam::bondForces::explicitForces
(
    const clumpState& s,
    vectorField& F,
    vectorField& T
) const
{
    F = Zero;
    T = Zero;
    scalar energy = 0;

    forAll(bonds_.bonds(), bi)
    {
        if (broken(s, bi))
        {
            continue;
        }

        const clumpBonds::bond& b = bonds_.bonds()[bi];
        const bondFrame frame(frameOf(b, s));
        bondResponse r(elastic(bi, frame));

        if (bonds_.damped())
        {
            vector gammaRate, psiRate;
            frame.rates
            (
                s.u[b.i], s.u[b.j], s.w[b.i], s.w[b.j], gammaRate, psiRate
            );

            const bondCoefficients& c = b.damping;
            vector n
            (
                bondResponse::transverse(c.normal, c.tangential, r.t, gammaRate)
            );
            vector m
            (
                bondResponse::transverse
                (
                    c.torsional, c.bending, b.direction, psiRate
                )
            );
            if (b.thinning > 0)
            {
                const scalar power = (n & gammaRate) + (m & psiRate);
                const scalar g = bonds_.thinning().factor(b.thinning*power);
                n *= g;
                m *= g;
            }
            r.n += n;
            r.m += m;
        }

        energy += r.energy;
        frame.addForces(r.n, r.m, F[b.i], F[b.j], T[b.i], T[b.j]);
    }

    addConservation(s, F, energy);
    return energy;
}


Foam::scalar Foam::bondForces::stepForces
(
    const clumpState& s,
    const scalar dt,
    vectorField& F,
    vectorField& T,
    clumpTangent* K,
    const bool geometric
) const
{
    F = Zero;
    T = Zero;
    const scalar oneByDt = dt > 0 ? 1/dt : 0;
    damping_.setStep(oneByDt);
    scalar energy = 0;

    forAll(bonds_.bonds(), bi)
    {
        if (broken(s, bi))
        {
            continue;
        }

        const clumpBonds::bond& b = bonds_.bonds()[bi];
        const bondFrame frame(frameOf(b, s));
        bondResponse r(elastic(bi, frame));
        if (oneByDt > 0)
        {
            damping_.add(bi, frame, r);
        }

        energy += r.energy;
        frame.addForces(r.n, r.m, F[b.i], F[b.j], T[b.i], T[b.j]);

        if (K)
        {
            bondTangent::add
            (
                bonds_.bonds(), bi, frame, r, damping_, geometric, *K
            );
        }
    }

    addConservation(s, F, energy, K);
    return energy;
}


void Foam::bondForces::addConservation
(
    const clumpState& s,
    vectorField& F,
    scalar& energy,
    clumpTangent* K
) const
{
    for (const conservationModel& model : bonds_.conservation())
    {
        const scalar k = model.stiffness();
        const scalar dQ = model.deviation(s.x, grad_);

        F -= k*dQ*grad_;
        energy += 0.5*k*sqr(dQ);

        if (K)
        {
            Eigen::VectorXd g(Eigen::VectorXd::Zero(6*grad_.size()));
            forAll(grad_, i)
            {
                g.segment<3>(6*i) << grad_[i].x(), grad_[i].y(), grad_[i].z();
            }
            K->addRankOne(k, g);
        }
    }
}


void Foam::bondForces::breakBonds(clumpState& s) const
{
    if (!bonds_.breakable())
    {
        return;
    }

    forAll(bonds_.bonds(), bi)
    {
        if (broken(s, bi))
        {
            continue;
        }

        const clumpBonds::bond& b = bonds_.bonds()[bi];
        const bondResponse r(elastic(bi, frameOf(b, s)));
        if (bonds_.law().breaks(r.n, r.m, r.t, b.direction, b.radius))
        {
            s.broken.setSize(bonds_.bonds().size(), 0);
            s.broken[bi] = 1;
        }
    }
}


Foam::Pair<Foam::scalar> Foam::bondForces::stresses
(
    const clumpState& s,
    const label bondi
) const
{
    const clumpBonds::bond& b = bonds_.bonds()[bondi];
    const bondResponse r(elastic(bondi, frameOf(b, s)));
    return bondModel::stresses(r.n, r.m, r.t, b.direction, b.radius);
}


Foam::scalarField Foam::bondForces::tension(const clumpState& s) const
{
    scalarField result(bonds_.bonds().size(), Zero);

    forAll(result, bi)
    {
        if (!broken(s, bi))
        {
            result[bi] = elastic(bi, frameOf(bonds_.bonds()[bi], s)).axial;
        }
    }

    return result;
}
