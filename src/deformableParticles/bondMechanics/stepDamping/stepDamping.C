/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "stepDamping.H"

Foam::stepDamping::stepDamping(const List<clumpBonds::bond>& bonds)
:
    bonds_(bonds),
    start_(bonds.size()),
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


void Foam::stepDamping::add
(
    const label bondi,
    const bondFrame& frame,
    bondResponse& r
) const
{
    const strains& start = start_[bondi];
    const bondCoefficients& c = oneByH_[bondi];
    const vector dd(frame.d() - start.d);
    const vector dPsi(frame.psi() - start.psi);

    const vector n
    (
        bondResponse::transverse(c.normal, c.tangential, start.t, dd)
    );
    const vector m
    (
        bondResponse::transverse
        (
            c.torsional, c.bending, bonds_[bondi].direction, dPsi
        )
    );
    r.n += n;
    r.m += m;
    r.energy += 0.5*((n & dd) + (m & dPsi));
}
