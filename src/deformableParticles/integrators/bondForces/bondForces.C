/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondForces.H"

namespace
{

Eigen::Matrix3d toEigen(const Foam::tensor& t)
{
    Eigen::Matrix3d m;
    m << t.xx(), t.xy(), t.xz(),
         t.yx(), t.yy(), t.yz(),
         t.zx(), t.zy(), t.zz();
    return m;
}


//- The matrix of v x
Foam::tensor crossMatrix(const Foam::vector& v)
{
    return Foam::tensor
    (
        0, -v.z(), v.y(),
        v.z(), 0, -v.x(),
        -v.y(), v.x(), 0
    );
}


//- along*e e + across*(I - e e)
Foam::tensor transverse
(
    const Foam::scalar along,
    const Foam::scalar across,
    const Foam::vector& e
)
{
    return across*Foam::tensor::I + (along - across)*(e*e);
}

}


Foam::bondForces::strains Foam::bondForces::strainsOf
(
    const clumpType::bond& b,
    const bondFrame& frame
)
{
    return {frame.d() - b.length*b.direction, frame.psi()};
}


Foam::bondForces::bondForces(const clumpType& type, const clumpState& start)
:
    type_(type),
    gamma0_(type.bonds().size()),
    psi0_(type.bonds().size()),
    n0_(start.n),
    m0_(start.m),
    grad_(type.size(), Zero)
{
    forAll(type_.bonds(), bi)
    {
        const clumpType::bond& b = type_.bonds()[bi];
        const strains s
        (
            strainsOf
            (
                b,
                bondFrame
                (
                    start.x[b.i], start.x[b.j], start.q[b.i], start.q[b.j]
                )
            )
        );
        gamma0_[bi] = s.gamma;
        psi0_[bi] = s.psi;
    }
}


Foam::bondForces::response Foam::bondForces::respond
(
    const label bi,
    const strains& s,
    const scalar oneByDt
) const
{
    const clumpType::bond& b = type_.bonds()[bi];
    const vector& e = b.direction;
    const bondCoefficients& k = b.stiffness;

    response r;

    if (type_.incremental())
    {
        const vector dGamma(s.gamma - gamma0_[bi]);
        const vector dPsi(s.psi - psi0_[bi]);
        const vector Kn
        (
            transverse(k.normal, k.tangential, e) & dGamma
        );
        const vector Km(transverse(k.torsional, k.bending, e) & dPsi);

        r.n = n0_[bi] + Kn;
        r.m = m0_[bi] + Km;
        r.energy =
            ((n0_[bi] + 0.5*Kn) & dGamma) + ((m0_[bi] + 0.5*Km) & dPsi);
        r.kNormal = k.normal;
    }
    else
    {
        const scalar elongation = s.gamma & e;
        const scalar torsion = s.psi & e;
        const vector shear(s.gamma - elongation*e);
        const vector bending(s.psi - torsion*e);

        const bondModel::axialResponse axial
        (
            type_.elasticity().axial(elongation, b.length, k.normal)
        );

        r.n = axial.force*e + k.tangential*shear;
        r.m = k.torsional*torsion*e + k.bending*bending;
        r.energy =
            axial.energy
          + 0.5*
            (
                k.tangential*magSqr(shear)
              + k.torsional*sqr(torsion)
              + k.bending*magSqr(bending)
            );
        r.kNormal = axial.tangent;
    }

    const bondCoefficients& c = b.damping;

    r.kNormal += c.normal*oneByDt;
    r.kTangential = k.tangential + c.tangential*oneByDt;
    r.kBending = k.bending + c.bending*oneByDt;
    r.kTorsional = k.torsional + c.torsional*oneByDt;

    if (oneByDt > 0)
    {
        const vector dGamma(s.gamma - gamma0_[bi]);
        const vector dPsi(s.psi - psi0_[bi]);
        const vector nd
        (
            oneByDt*(transverse(c.normal, c.tangential, e) & dGamma)
        );
        const vector md
        (
            oneByDt*(transverse(c.torsional, c.bending, e) & dPsi)
        );

        r.n += nd;
        r.m += md;
        r.energy += 0.5*((nd & dGamma) + (md & dPsi));
    }

    return r;
}


void Foam::bondForces::addTangent
(
    const clumpType::bond& b,
    const bondFrame& frame,
    const response& r,
    const bool geometric,
    Eigen::MatrixXd& K
) const
{
    using Eigen::Matrix3d;

    // Quadratic form in u (relative displacement), s (spin of the frame) and
    // p (relative rotation): gamma changes by u - s x d, psi by H p
    const Matrix3d D(toEigen(transverse(r.kNormal, r.kTangential, b.direction)));
    const Matrix3d H(toEigen(frame.H()));
    const Matrix3d d(toEigen(crossMatrix(frame.d())));

    Eigen::Matrix<double, 9, 9> Q;
    Q.setZero();
    Q.block<3, 3>(0, 0) = D;
    Q.block<3, 3>(0, 3) = D*d;
    Q.block<3, 3>(3, 3) = d.transpose()*D*d;
    Q.block<3, 3>(6, 6) =
        H*toEigen(transverse(r.kTorsional, r.kBending, b.direction))*H;

    if (geometric)
    {
        const tensor nd(r.n*frame.d());
        Q.block<3, 3>(0, 3) -= toEigen(crossMatrix(r.n));
        Q.block<3, 3>(3, 3) +=
            toEigen(0.5*(nd + nd.T()) - tr(nd)*tensor::I);
    }
    Q.block<3, 3>(3, 0) = Q.block<3, 3>(0, 3).transpose();

    // (u, s, p) from (x_i, theta_i, x_j, theta_j) in space
    const Matrix3d RT(toEigen(frame.R().T()));
    const Matrix3d C(toEigen(frame.C()));
    Eigen::Matrix<double, 9, 12> B;
    B.setZero();
    B.block<3, 3>(0, 0) = -RT;
    B.block<3, 3>(0, 6) = RT;
    B.block<3, 3>(3, 3) = 0.5*RT - C*RT;
    B.block<3, 3>(3, 9) = 0.5*RT + C*RT;
    B.block<3, 3>(6, 3) = -RT;
    B.block<3, 3>(6, 9) = RT;

    const Eigen::Matrix<double, 12, 12> k(B.transpose()*(Q*B));

    K.block<6, 6>(6*b.i, 6*b.i) += k.block<6, 6>(0, 0);
    K.block<6, 6>(6*b.i, 6*b.j) += k.block<6, 6>(0, 6);
    K.block<6, 6>(6*b.j, 6*b.i) += k.block<6, 6>(6, 0);
    K.block<6, 6>(6*b.j, 6*b.j) += k.block<6, 6>(6, 6);
}


Foam::scalar Foam::bondForces::explicitForces
(
    const clumpState& s,
    vectorField& F,
    vectorField& T
) const
{
    const scalar energy = stepForces(s, -1, F, T);

    forAll(type_.bonds(), bi)
    {
        const clumpType::bond& b = type_.bonds()[bi];
        const bondFrame frame(s.x[b.i], s.x[b.j], s.q[b.i], s.q[b.j]);

        vector gammaRate, psiRate;
        frame.rates
        (
            s.u[b.i], s.u[b.j], s.w[b.i], s.w[b.j], gammaRate, psiRate
        );

        const bondCoefficients& c = b.damping;
        frame.addForces
        (
            transverse(c.normal, c.tangential, b.direction) & gammaRate,
            transverse(c.torsional, c.bending, b.direction) & psiRate,
            F[b.i], F[b.j], T[b.i], T[b.j]
        );
    }

    return energy;
}


Foam::scalar Foam::bondForces::stepForces
(
    const clumpState& s,
    const scalar dt,
    vectorField& F,
    vectorField& T,
    Eigen::MatrixXd* K,
    const bool geometric
) const
{
    F = Zero;
    T = Zero;
    scalar energy = 0;

    forAll(type_.bonds(), bi)
    {
        const clumpType::bond& b = type_.bonds()[bi];
        const bondFrame frame(s.x[b.i], s.x[b.j], s.q[b.i], s.q[b.j]);
        const response r(respond(bi, strainsOf(b, frame), dt > 0 ? 1/dt : 0));

        energy += r.energy;
        frame.addForces(r.n, r.m, F[b.i], F[b.j], T[b.i], T[b.j]);

        if (K)
        {
            addTangent(b, frame, r, geometric, *K);
        }
    }

    if (type_.conservation().active())
    {
        const scalar k = type_.conservation().stiffness();
        const scalar dQ = type_.conservation().deviation(s.x, grad_);

        F -= k*dQ*grad_;
        energy += 0.5*k*sqr(dQ);

        if (K)
        {
            Eigen::VectorXd g(Eigen::VectorXd::Zero(K->rows()));
            forAll(grad_, i)
            {
                g.segment<3>(6*i) << grad_[i].x(), grad_[i].y(), grad_[i].z();
            }
            K->noalias() += k*g*g.transpose();
        }
    }

    return energy;
}


void Foam::bondForces::store(clumpState& s) const
{
    forAll(s.n, bi)
    {
        const clumpType::bond& b = type_.bonds()[bi];
        const bondFrame frame(s.x[b.i], s.x[b.j], s.q[b.i], s.q[b.j]);
        const response r(respond(bi, strainsOf(b, frame), 0));

        s.n[bi] = r.n;
        s.m[bi] = r.m;
    }
}


Foam::scalarField Foam::bondForces::tension(const clumpState& s) const
{
    scalarField result(type_.bonds().size());

    forAll(result, bi)
    {
        const clumpType::bond& b = type_.bonds()[bi];
        const bondFrame frame(s.x[b.i], s.x[b.j], s.q[b.i], s.q[b.j]);
        result[bi] = respond(bi, strainsOf(b, frame), 0).n & b.direction;
    }

    return result;
}
