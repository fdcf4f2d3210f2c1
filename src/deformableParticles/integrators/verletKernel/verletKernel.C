/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "verletKernel.H"
#include "verletKernelLoops.H"
#include "bondForces.H"

Foam::verletKernel::verletKernel(const clumpType& type)
:
    type_(type)
{
    lay();
    loadType();
}


void Foam::verletKernel::lay()
{
    layout& a = data_;
    a.nSpheres = type_.size();
    a.nBonds = type_.bonds().size();

    // Lists of spheres and of bonds, as many as layout names
    const int ns = 3*10 + 4 + 6 + 4;
    const int nb = 3*9 + 4 + 9 + 6;
    memory_.assign(ns*a.nSpheres + nb*a.nBonds, 0);
    ends_.assign(2*a.nBonds, 0);

    double* next = memory_.data();
    const auto take = [&next](double*& list, const int n)
    {
        list = next;
        next += n;
    };

    for (lists<3>* l : {&a.x, &a.u, &a.w, &a.F, &a.T, &a.f, &a.t, &a.u0, &a.w0, &a.x0})
    {
        for (double*& c : l->component) take(c, a.nSpheres);
    }
    for (double*& c : a.q.component) take(c, a.nSpheres);
    for (double*& c : a.k.component) take(c, a.nSpheres);
    for (double** c : {&a.oneByM, &a.oneByI, &a.zeta, &a.zetaR})
    {
        take(*c, a.nSpheres);
    }

    for
    (
        lists<3>* l :
        {&a.e, &a.n0, &a.m0, &a.fn, &a.ti, &a.tj, &a.psi, &a.d, &a.v}
    )
    {
        for (double*& c : l->component) take(c, a.nBonds);
    }
    for (double*& c : a.sum.component) take(c, a.nBonds);
    for
    (
        double** c :
        {
            &a.length, &a.kn, &a.shear, &a.kb, &a.kt, &a.cn, &a.cs, &a.cb,
            &a.ct, &a.cosHalf, &a.sin2, &a.h, &a.g, &a.distance, &a.N
        }
    )
    {
        take(*c, a.nBonds);
    }

    a.i = ends_.data();
    a.j = a.i + a.nBonds;
}


void Foam::verletKernel::loadType()
{
    layout& a = data_;
    a.damped = false;
    a.linear = a.nBonds == 0 || type_.elasticity().linear();

    for (label s = 0; s < a.nSpheres; ++s)
    {
        a.oneByM[s] = 1/type_.masses()[s];
        a.oneByI[s] = 1/type_.inertias()[s];
    }

    forAll(type_.bonds(), b)
    {
        const clumpType::bond& bond = type_.bonds()[b];
        const bondCoefficients& k = bond.stiffness;
        const bondCoefficients& c = bond.damping;
        a.i[b] = bond.i;
        a.j[b] = bond.j;
        for (int d = 0; d < 3; ++d)
        {
            a.e[d][b] = bond.direction[d];
        }
        a.length[b] = bond.length;
        a.kn[b] = k.normal;
        a.shear[b] = k.tangential*bond.length;
        a.kb[b] = k.bending;
        a.kt[b] = k.torsional;
        a.cn[b] = c.normal;
        a.cs[b] = c.tangential;
        a.cb[b] = c.bending;
        a.ct[b] = c.torsional;
        a.damped =
            a.damped
         || max(max(c.normal, c.tangential), max(c.bending, c.torsional)) > 0;
    }
}


void Foam::verletKernel::load
(
    const clumpState& s,
    const integrator::externals& ext
)
{
    layout& a = data_;
    a.exchanging = false;

    for (label i = 0; i < a.nSpheres; ++i)
    {
        for (int c = 0; c < 3; ++c)
        {
            a.x[c][i] = a.x0[c][i] = s.x[i][c];
            a.u[c][i] = s.u[i][c];
            a.w[c][i] = s.w[i][c];
            a.f[c][i] = ext.f[i][c];
            a.t[c][i] = ext.t[i][c];
            a.u0[c][i] = ext.u0[i][c];
            a.w0[c][i] = ext.w0[i][c];
        }
        a.q[0][i] = s.q[i].w();
        for (int c = 0; c < 3; ++c)
        {
            a.q[c + 1][i] = s.q[i].v()[c];
        }
        for (int c = 0; c < 6; ++c)
        {
            a.k[c][i] = ext.k[i][c];
            a.exchanging = a.exchanging || mag(ext.k[i][c]) > 0;
        }
        a.zeta[i] = ext.zeta[i];
        a.zetaR[i] = ext.zetaR[i];
        a.exchanging = a.exchanging || max(ext.zeta[i], ext.zetaR[i]) > 0;
    }

    // Broken bonds: no stiffness, no damping
    forAll(s.broken, b)
    {
        if (s.broken[b] > 0)
        {
            for
            (
                double* c :
                {a.kn, a.shear, a.kb, a.kt, a.cn, a.cs, a.cb, a.ct}
            )
            {
                c[b] = 0;
            }
        }
    }

    // What incremental bonds keep besides the law does not change over the steps
    if (type_.incremental())
    {
        const bondForces total(type_);
        forAll(s.n, b)
        {
            if (s.broken.size() && s.broken[b] > 0)
            {
                continue;
            }
            vector n, m;
            total.law(s, b, n, m);
            for (int c = 0; c < 3; ++c)
            {
                a.n0[c][b] = s.n[b][c] - n[c];
                a.m0[c][b] = s.m[b][c] - m[c];
            }
        }
    }

    forces();
    addExternals();
}


void Foam::verletKernel::axialForces()
{
    layout& a = data_;
    for (int b = 0; b < a.nBonds; ++b)
    {
        a.N[b] = type_.elasticity().axial
        (
            a.distance[b] - a.length[b], a.length[b], a.kn[b]
        ).force;
    }
}


void Foam::verletKernel::forces()
{
    layout& a = data_;

    verletLoops::frames(a);
    if (verletLoops::largestTurn(a) > verletLoops::seriesLimit)
    {
        verletLoops::largeTurns(a);
    }
    if (!a.linear)
    {
        axialForces();
    }
    a.damped ? verletLoops::dampedForces(a) : verletLoops::elasticForces(a);
}


void Foam::verletKernel::addExternals()
{
    if (data_.exchanging)
    {
        verletLoops::exchange(data_);
    }
}


void Foam::verletKernel::advance(const label n, const scalar h)
{
    for (label k = 0; k < n; ++k)
    {
        verletLoops::kickAndDrift(data_, h);
        forces();
        addExternals();
        verletLoops::kick(data_, h);
    }
}


void Foam::verletKernel::store(clumpState& s) const
{
    const layout& a = data_;

    for (label i = 0; i < a.nSpheres; ++i)
    {
        for (int c = 0; c < 3; ++c)
        {
            s.x[i][c] = a.x[c][i];
            s.u[i][c] = a.u[c][i];
            s.w[i][c] = a.w[c][i];
        }
        s.q[i] = quaternion
        (
            a.q[0][i], vector(a.q[1][i], a.q[2][i], a.q[3][i])
        );
        s.q[i].normalize();
    }

    if (type_.incremental())
    {
        const bondForces total(type_);
        forAll(s.n, b)
        {
            if (s.broken.size() && s.broken[b] > 0)
            {
                continue;
            }
            vector n, m;
            total.law(s, b, n, m);
            for (int c = 0; c < 3; ++c)
            {
                s.n[b][c] = n[c] + a.n0[c][b];
                s.m[b][c] = m[c] + a.m0[c][b];
            }
        }
    }

    if (s.broken.size())
    {
        bondForces(type_, s).store(s);
    }
}
