/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondTangent.H"
#include "toEigen.H"

namespace
{

using namespace Foam;
using Eigen::Matrix3d;

//- along*e e + across*(I - e e)
inline Matrix3d transverse
(
    const scalar along,
    const scalar across,
    const vector& e
)
{
    const Eigen::Vector3d v(toEigen(e));
    return across*Matrix3d::Identity()
      + (along - across)*v*v.transpose();
}


//- Second variation of the energy in the frame of the bond with respect to u (relative
//  displacement), s (mean rotation) and p (relative rotation): gamma changes by
//  u + d x (s + C p), psi by H p. Each matrix is named after the pair of variables that
//  it couples
struct variation
{
    Matrix3d uu, us, up, ss, sp, pp;
};

variation secondVariation
(
    const clumpBonds::bond& b,
    const bondFrame& frame,
    const bondResponse& r,
    const stepDamping::tangent& damped,
    const vector& dampedDirection,
    const bool geometric
)
{
    const bondCoefficients& k = b.stiffness;
    const bondCoefficients& c = damped.c;
    const Eigen::Vector3d dv(toEigen(frame.d()));
    const Matrix3d C(toEigen(frame.C()));
    const Matrix3d H(toEigen(frame.H()));
    const Matrix3d d(crossMatrix(dv));
    Matrix3d D
    (
        transverse(r.kAlong, geometric ? r.kAcross : max(r.kAcross, 0), r.t)
      + transverse(c.normal, c.tangential, dampedDirection)
    );
    Matrix3d S
    (
        transverse(k.torsional + c.torsional, k.bending + c.bending, b.direction)
      + toEigen(tensor(r.locking))
    );

    // Damping that falls with the rate couples the strains: gamma.N psi
    const bool thinning = damped.slope < 0;
    Matrix3d N;
    if (thinning)
    {
        const Eigen::Vector3d n(toEigen(damped.n));
        const Eigen::Vector3d m(toEigen(damped.m));
        D += damped.slope*n*n.transpose();
        S += damped.slope*m*m.transpose();
        N = damped.slope*n*m.transpose();
    }

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
    Matrix3d up(us*C);

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
    if (thinning)
    {
        const Matrix3d NH(N*H);
        const Matrix3d sNH(-d*NH);
        const Matrix3d twist(C.transpose()*sNH);
        up += NH;
        sp += sNH;
        pp += twist + twist.transpose();
    }
    return {D, us, up, ss, sp, pp};
}

}


void Foam::bondTangent::add
(
    const List<clumpBonds::bond>& bonds,
    const label bi,
    const bondFrame& frame,
    const bondResponse& r,
    const stepDamping& damping,
    const bool geometric,
    clumpTangent& K
)
{
    const clumpBonds::bond& b = bonds[bi];
    const variation v
    (
        secondVariation
        (
            b, frame, r, damping.derivative(bi, frame), damping.direction(bi),
            geometric
        )
    );

    // Rotations of the spheres: s is their mean, p their difference
    const Matrix3d R(toEigen(frame.R()));
    const Matrix3d RT(R.transpose());
    const auto turn = [&R, &RT](const Matrix3d& m) -> Matrix3d
    {
        return R*m*RT;
    };

    const Matrix3d uu(turn(v.uu));
    const Matrix3d ui(turn(0.5*v.us - v.up));
    const Matrix3d uj(turn(0.5*v.us + v.up));
    const Matrix3d even(0.25*v.ss + v.pp);
    const Matrix3d odd(0.5*(v.sp + v.sp.transpose()));
    const Matrix3d skew(0.5*(v.sp - v.sp.transpose()));

    clumpTangent::block B;

    B << uu, -ui, -ui.transpose(), turn(even - odd);
    K.diagonal(b.i) += B;

    B << uu, uj, uj.transpose(), turn(even + odd);
    K.diagonal(b.j) += B;

    B << -uu, -uj, ui.transpose(), turn(0.25*v.ss - v.pp + skew);
    K.addCoupling(bi, b.i, b.j, B);
}
