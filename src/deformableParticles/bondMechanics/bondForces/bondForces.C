/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondForces.H"

namespace
{

inline Eigen::Matrix3d toEigen(const Foam::tensor& t)
{
    Eigen::Matrix3d m;
    m << t.xx(), t.xy(), t.xz(),
         t.yx(), t.yy(), t.yz(),
         t.zx(), t.zy(), t.zz();
    return m;
}


inline Eigen::Vector3d toEigen(const Foam::vector& v)
{
    return Eigen::Vector3d(v.x(), v.y(), v.z());
}


//- The matrix of v x
inline Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v)
{
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(),
         v.z(), 0, -v.x(),
         -v.y(), v.x(), 0;
    return m;
}


//- along*e e + across*(I - e e)
inline Eigen::Matrix3d transverse
(
    const Foam::scalar along,
    const Foam::scalar across,
    const Foam::vector& e
)
{
    const Eigen::Vector3d v(toEigen(e));
    return across*Eigen::Matrix3d::Identity()
      + (along - across)*v*v.transpose();
}


//- The same, applied to v
inline Foam::vector transverse
(
    const Foam::scalar along,
    const Foam::scalar across,
    const Foam::vector& e,
    const Foam::vector& v
)
{
    return across*v + ((along - across)*(e & v))*e;
}

}


void Foam::bondForces::setDamping(const scalar oneByDt) const
{
    if (dampingFor_ == oneByDt)
    {
        return;
    }

    const auto fitted = [oneByDt](const scalar c, const scalar k)
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

    damping_.setSize(type_.bonds().size());
    forAll(damping_, bi)
    {
        const bondCoefficients& c = type_.bonds()[bi].damping;
        const bondCoefficients& k = type_.bonds()[bi].stiffness;
        damping_[bi] =
        {
            fitted(c.normal, k.normal),
            fitted(c.tangential, k.tangential),
            fitted(c.bending, k.bending),
            fitted(c.torsional, k.torsional)
        };
    }
    dampingFor_ = oneByDt;
}


Foam::bondFrame Foam::bondForces::frameOf
(
    const clumpType::bond& b,
    const clumpState& s
)
{
    return bondFrame(s.x[b.i], s.x[b.j], s.q[b.i], s.q[b.j]);
}


Foam::bondForces::bondForces(const clumpType& type)
:
    type_(type),
    start_(type.bonds().size()),
    grad_(type.size(), Zero),
    dampingFor_(-1)
{}


Foam::bondForces::bondForces(const clumpType& type, const clumpState& start)
:
    bondForces(type)
{
    begin(start);
}


void Foam::bondForces::begin(const clumpState& s)
{
    forAll(start_, bi)
    {
        const clumpType::bond& b = type_.bonds()[bi];
        const bondFrame frame(frameOf(b, s));
        startOfStep& start = start_[bi];

        start.d = frame.d();
        start.psi = frame.psi();
        start.t = direction(b, start.d, mag(start.d));

        if (type_.incremental())
        {
            const response r(elastic(b, start.d, start.psi));
            start.n = s.n[bi] - r.n;
            start.m = s.m[bi] - r.m;
        }
    }
}


Foam::vector Foam::bondForces::direction
(
    const clumpType::bond& b,
    const vector& d,
    const scalar length
)
{
    return length > 1e-12*b.length ? d/length : b.direction;
}


Foam::bondForces::response Foam::bondForces::elastic
(
    const clumpType::bond& b,
    const vector& d,
    const vector& psi
) const
{
    const vector& e = b.direction;
    const bondCoefficients& k = b.stiffness;
    const scalar length = mag(d);
    const scalar torsion = psi & e;
    const vector bending(psi - torsion*e);

    response r;
    r.t = direction(b, d, length);

    const bondModel::axialResponse axial
    (
        type_.elasticity().axial(length - b.length, b.length, k.normal)
    );
    const scalar shear = k.tangential*b.length;

    r.n = (axial.force + shear)*r.t - shear*e;
    r.m = k.torsional*torsion*e + k.bending*bending;
    r.energy =
        axial.energy
      + 0.5*shear*length*magSqr(r.t - e)
      + 0.5*(k.torsional*sqr(torsion) + k.bending*magSqr(bending));

    r.axial = axial.force;
    r.kAlong = axial.tangent;
    r.kAcross = (axial.force + shear)/max(length, 1e-12*b.length);

    return r;
}


Foam::bondForces::response Foam::bondForces::respond
(
    const label bi,
    const bondFrame& frame,
    const scalar oneByDt
) const
{
    const clumpType::bond& b = type_.bonds()[bi];
    const startOfStep& start = start_[bi];

    response r(elastic(b, frame.d(), frame.psi()));

    if (type_.incremental() || oneByDt > 0)
    {
        const vector dd(frame.d() - start.d);
        const vector dPsi(frame.psi() - start.psi);

        if (type_.incremental())
        {
            r.n += start.n;
            r.m += start.m;
            r.energy += (start.n & dd) + (start.m & dPsi);
        }
        if (oneByDt > 0)
        {
            const bondCoefficients& c = damping_[bi];
            const vector nd
            (
                transverse(c.normal, c.tangential, start.t, dd)
            );
            const vector md
            (
                transverse(c.torsional, c.bending, b.direction, dPsi)
            );
            r.n += nd;
            r.m += md;
            r.energy += 0.5*((nd & dd) + (md & dPsi));
        }
    }

    return r;
}


void Foam::bondForces::addTangent
(
    const label bi,
    const bondFrame& frame,
    const response& r,
    const scalar oneByDt,
    const bool geometric,
    clumpTangent& K
) const
{
    using Eigen::Matrix3d;

    const clumpType::bond& b = type_.bonds()[bi];
    const bondCoefficients& k = b.stiffness;
    const bondCoefficients& c = damping_[bi];
    const Eigen::Vector3d dv(toEigen(frame.d()));
    const Matrix3d C(toEigen(frame.C()));
    const Matrix3d H(toEigen(frame.H()));
    const Matrix3d d(crossMatrix(dv));
    const Matrix3d D
    (
        transverse(r.kAlong, geometric ? r.kAcross : max(r.kAcross, 0), r.t)
      + transverse(c.normal, c.tangential, start_[bi].t)
    );
    const Matrix3d S
    (
        transverse
        (
            k.torsional + c.torsional,
            k.bending + c.bending,
            b.direction
        )
    );

    // Second variation in the bond's frame by u (relative displacement), s (mean
    // rotation) and p (relative rotation): gamma changes by u + d x (s + C p),
    // psi by H p. The names say which pair of them.
    Matrix3d us(D*d);
    Matrix3d ss(-d*us);

    if (geometric)
    {
        const Eigen::Vector3d n(toEigen(r.n));
        us -= crossMatrix(n);
        ss += 0.5*(n*dv.transpose() + dv*n.transpose());
        ss.diagonal().array() -= n.dot(dv);
    }

    Matrix3d sp(ss*C);
    Matrix3d pp(C.transpose()*sp + H*S*H);

    if (geometric)
    {
        // The maps C and H change with p, the frame turns with s
        const vector w(frame.d() ^ r.n);
        const Matrix3d g(crossMatrix(toEigen(frame.C(w) + frame.H(r.m))));
        const Matrix3d change
        (
            toEigen(frame.coupleTangent(r.m, w))*H - g*C
        );

        sp += 0.5*(crossMatrix(toEigen(w))*C + g);
        pp += 0.5*(change + change.transpose());
    }
    const Matrix3d up(us*C);

    // Rotations of the spheres: s is their mean, p their difference
    const Matrix3d R(toEigen(frame.R()));
    const Matrix3d RT(R.transpose());
    const auto turn = [&R, &RT](const Matrix3d& m) -> Matrix3d
    {
        return R*m*RT;
    };

    const Matrix3d uu(turn(D));
    const Matrix3d ui(turn(0.5*us - up));
    const Matrix3d uj(turn(0.5*us + up));
    const Matrix3d even(0.25*ss + pp);
    const Matrix3d odd(0.5*(sp + sp.transpose()));
    const Matrix3d skew(0.5*(sp - sp.transpose()));

    clumpTangent::block B;

    B << uu, -ui, -ui.transpose(), turn(even - odd);
    K.diagonal(b.i) += B;

    B << uu, uj, uj.transpose(), turn(even + odd);
    K.diagonal(b.j) += B;

    B << -uu, -uj, ui.transpose(), turn(0.25*ss - pp + skew);
    K.addCoupling(bi, b.i, b.j, B);
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
        if (broken(s, bi))
        {
            continue;
        }

        const clumpType::bond& b = type_.bonds()[bi];
        const bondFrame frame(frameOf(b, s));

        vector gammaRate, psiRate;
        frame.rates
        (
            s.u[b.i], s.u[b.j], s.w[b.i], s.w[b.j], gammaRate, psiRate
        );

        const bondCoefficients& c = b.damping;
        const vector t(direction(b, frame.d(), mag(frame.d())));
        frame.addForces
        (
            transverse(c.normal, c.tangential, t, gammaRate),
            transverse(c.torsional, c.bending, b.direction, psiRate),
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
    clumpTangent* K,
    const bool geometric
) const
{
    F = Zero;
    T = Zero;
    const scalar oneByDt = dt > 0 ? 1/dt : 0;
    setDamping(oneByDt);
    scalar energy = 0;

    forAll(type_.bonds(), bi)
    {
        if (broken(s, bi))
        {
            continue;
        }

        const clumpType::bond& b = type_.bonds()[bi];
        const bondFrame frame(frameOf(b, s));
        const response r(respond(bi, frame, oneByDt));

        energy += r.energy;
        frame.addForces(r.n, r.m, F[b.i], F[b.j], T[b.i], T[b.j]);

        if (K)
        {
            addTangent(bi, frame, r, oneByDt, geometric, *K);
        }
    }

    for (const conservationModel& model : type_.conservation())
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

    return energy;
}


void Foam::bondForces::store(clumpState& s) const
{
    if (s.n.empty() && s.broken.empty())
    {
        return;
    }

    forAll(type_.bonds(), bi)
    {
        if (broken(s, bi))
        {
            continue;
        }

        const clumpType::bond& b = type_.bonds()[bi];
        const response r(respond(bi, frameOf(b, s), 0));
        const bool breaks =
            s.broken.size()
         && type_.elasticity().breaks(r.n, r.m, r.t, b.direction, b.radius);

        if (breaks)
        {
            s.broken[bi] = 1;
        }
        if (s.n.size())
        {
            s.n[bi] = breaks ? vector::zero : r.n;
            s.m[bi] = breaks ? vector::zero : r.m;
        }
    }
}


void Foam::bondForces::law
(
    const clumpState& s,
    const label bondi,
    vector& n,
    vector& m
) const
{
    const clumpType::bond& b = type_.bonds()[bondi];
    const bondFrame frame(frameOf(b, s));
    const response r(elastic(b, frame.d(), frame.psi()));
    n = r.n;
    m = r.m;
}


Foam::scalarField Foam::bondForces::tension(const clumpState& s) const
{
    scalarField result(type_.bonds().size(), Zero);

    forAll(result, bi)
    {
        if (broken(s, bi))
        {
            continue;
        }

        const response r(respond(bi, frameOf(type_.bonds()[bi], s), 0));
        result[bi] =
            type_.incremental() ? r.n & r.t : r.axial;
    }

    return result;
}
