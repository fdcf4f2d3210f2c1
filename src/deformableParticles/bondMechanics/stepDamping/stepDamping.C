/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "stepDamping.H"

Foam::stepDamping::stepDamping(const clumpBonds& bonds)
:
    clump_(bonds),
    bonds_(bonds.bonds()),
    start_(bonds_.size()),
    oneByDt_(-1)
{}


void Foam::stepDamping::setStart(const label bondi, const bondFrame& frame)
{
    strains& start = start_[bondi];
    start.d = frame.d();
    start.psi = frame.psi();
    start.t = bondResponse::direction(bonds_[bondi], start.d, mag(start.d));
}


void Foam::stepDamping::setStep(const scalar oneByDt)
{
    if (oneByDt_ == oneByDt)
    {
        return;
    }

    // 1/(tau (exp(dt/tau) - 1)) times c, as a series for small dt/tau
    const auto oneByH = [oneByDt](const scalar c, const scalar k)
    {
        if (c <= 0 || k <= 0 || oneByDt <= 0)
        {
            return c*oneByDt;
        }
        const scalar x = k/(c*oneByDt);
        return
            x < 1e-3 ? c*oneByDt/(1 + x*(0.5 + x/6))
          : x < 500 ? k/std::expm1(x)
          : 0.0;
    };

    oneByH_.setSize(bonds_.size());
    forAll(oneByH_, bi)
    {
        const bondCoefficients& c = bonds_[bi].damping;
        const bondCoefficients& k = bonds_[bi].stiffness;
        oneByH_[bi] =
        {
            oneByH(c.normal, k.normal),
            oneByH(c.tangential, k.tangential),
            oneByH(c.bending, k.bending),
            oneByH(c.torsional, k.torsional)
        };
    }
    oneByDt_ = oneByDt;
}


Foam::stepDamping::linearPart Foam::stepDamping::linear
(
    const label bondi,
    const bondFrame& frame
) const
{
    const strains& start = start_[bondi];
    const bondCoefficients& c = oneByH_[bondi];
    const vector dd(frame.d() - start.d);
    const vector dPsi(frame.psi() - start.psi);

    return
    {
        dd,
        dPsi,
        bondResponse::transverse(c.normal, c.tangential, start.t, dd),
        bondResponse::transverse
        (
            c.torsional, c.bending, bonds_[bondi].direction, dPsi
        )
    };
}


void Foam::stepDamping::add
(
    const label bondi,
    const bondFrame& frame,
    bondResponse& r
) const
{
    const linearPart p(linear(bondi, frame));
    const scalar thinning = bonds_[bondi].thinning;
    if (thinning > 0)
    {
        const scalar s = thinning*oneByDt_*p.work();
        const scalar g = clump_.thinning().factor(s);
        r.n += g*p.n;
        r.m += g*p.m;
        r.energy += 0.5*clump_.thinning().mean(s)*p.work();
    }
    else
    {
        r.n += p.n;
        r.m += p.m;
        r.energy += 0.5*p.work();
    }
}


Foam::stepDamping::tangent Foam::stepDamping::derivative
(
    const label bondi,
    const bondFrame& frame
) const
{
    tangent result{oneByH_[bondi], 0, Zero, Zero};
    const scalar perWork = bonds_[bondi].thinning*oneByDt_;
    if (perWork > 0)
    {
        const linearPart p(linear(bondi, frame));
        const scalar s = perWork*p.work();
        const scalar g = clump_.thinning().factor(s);
        bondCoefficients& c = result.c;
        c = {g*c.normal, g*c.tangential, g*c.bending, g*c.torsional};
        result.slope = 2*perWork*clump_.thinning().slope(s);
        result.n = p.n;
        result.m = p.m;
    }
    return result;
}
