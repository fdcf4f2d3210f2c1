/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondFrame.H"
#include "foamCompat.H"

namespace
{

//- x/sin(x) and the series of its remainder, both functions of t = sin^2(x/2):
//  x/sin(x) = 1 + t g, g = sum of a_k t^(k - 1), a_k = a_(k - 1) 2k/(2k + 1)
inline void halfAngleOverSine
(
    const Foam::scalar t,
    const Foam::scalar halfAngle,
    Foam::scalar& f,
    Foam::scalar& g
)
{
    // For relative rotations above 1.3 rad the series converges slowly
    if (t > 0.1)
    {
        f = halfAngle/Foam::sin(halfAngle);
        g = (f - 1)/t;
        return;
    }

    // Terms down to rounding
    Foam::scalar term = 2.0/3.0;
    g = term;
    for (int k = 2; term > 1e-17 && k < 20; ++k)
    {
        term *= t*2*k/(2*k + 1.0);
        g += term;
    }
    f = 1 + t*g;
}


//- Of the two quaternions of a rotation, that of the sign which is continuous up to 1.7 pi
inline Foam::scalar signOf(const Foam::scalar w)
{
    return w < -0.9 ? -1 : 1;
}

}


Foam::vector Foam::rotationVector(const quaternion& q)
{
    const scalar sign = signOf(q.w());
    const scalar w = sign*q.w();
    const scalar s2 = magSqr(q.v());
    const scalar t = s2/(2*(1 + w));

    scalar f, g;
    halfAngleOverSine(t, t > 0.1 ? Foam::atan2(Foam::sqrt(s2), w) : 0, f, g);
    return (2*sign*f)*q.v();
}


Foam::quaternion Foam::rotation(const vector& v)
{
    const scalar a2 = magSqr(v)/4;
    if (a2 < 1e-2)
    {
        // Series of sine and cosine, to rounding
        const scalar s =
            1 - a2/6*(1 - a2/20*(1 - a2/42*(1 - a2/72*(1 - a2/110))));
        const scalar c =
            1 - a2/2*(1 - a2/12*(1 - a2/30*(1 - a2/56*(1 - a2/90))));
        return quaternion(c, (0.5*s)*v);
    }

    const scalar a = Foam::sqrt(a2);
    quaternion q(Foam::cos(a), (0.5*Foam::sin(a)/a)*v);
    normalise(q);
    return q;
}


Foam::bondFrame::bondFrame
(
    const point& xi,
    const point& xj,
    const quaternion& qi,
    const quaternion& qj
)
{
    // Relative rotation
    const vector& a = qi.v();
    const vector& b = qj.v();
    scalar w = qi.w()*qj.w() + (a & b);
    const scalar sign = signOf(w);
    w *= sign;
    const vector v(sign*(qi.w()*b - qj.w()*a - (a ^ b)));

    // t = sin^2(theta/4) without cancellation
    const scalar s2 = magSqr(v);
    const scalar t = s2/(2*(1 + w));
    scalar g;
    halfAngleOverSine
    (
        t, t > 0.1 ? Foam::atan2(Foam::sqrt(s2), w) : 0, h_, g
    );

    psi_ = 2*h_*v;
    cosHalf_ = w;
    c_ = -1/(4*h_*(1 + w));
    k_ = -g/(8*sqr(h_)*(1 + w));

    // The mean orientation is the normalised sum
    const scalar w0 = qi.w() + sign*qj.w();
    const vector v0(a + sign*b);
    const scalar n2 = 2/(sqr(w0) + magSqr(v0));
    const scalar x = v0.x(), y = v0.y(), z = v0.z();
    R_ = tensor
    (
        1 - n2*(y*y + z*z), n2*(x*y - w0*z), n2*(x*z + w0*y),
        n2*(x*y + w0*z), 1 - n2*(x*x + z*z), n2*(y*z - w0*x),
        n2*(x*z - w0*y), n2*(y*z + w0*x), 1 - n2*(x*x + y*y)
    );
    d_ = (xj - xi) & R_;
}


Foam::tensor Foam::bondFrame::coupleTangent
(
    const vector& m,
    const vector& w
) const
{
    const scalar theta2 = magSqr(psi_);

    // Derivatives of h, k and c by theta, over theta
    scalar dh = 1.0/12.0 + 7*theta2/1440;
    scalar dk = -7.0/2880.0;
    scalar dc = -1.0/192.0;
    if (theta2 > 1e-4)
    {
        dh = h_*(1 - h_*cosHalf_)/theta2;
        dk = -(dh + 2*k_)/theta2;
        dc = -(1/(4*(1 + cosHalf_)) + c_)/theta2;
    }

    const scalar pm = psi_ & m;
    const vector pw(psi_ ^ w);

    return
        (dh*m + dk*pm*psi_ + dc*pw)*psi_
      + k_*(pm*tensor::I + psi_*m)
      - c_*tensor
        (
            0, -w.z(), w.y(),
            w.z(), 0, -w.x(),
            -w.y(), w.x(), 0
        );
}


void Foam::bondFrame::rates
(
    const vector& ui,
    const vector& uj,
    const vector& wi,
    const vector& wj,
    vector& gammaRate,
    vector& psiRate
) const
{
    const vector relative((wj - wi) & R_);
    const vector omega(((0.5*(wi + wj)) & R_) + C(relative));

    gammaRate = ((uj - ui) & R_) - (omega ^ d_);
    psiRate = H(relative);
}


void Foam::bondFrame::addForces
(
    const vector& n,
    const vector& m,
    vector& Fi,
    vector& Fj,
    vector& Ti,
    vector& Tj
) const
{
    const vector w(d_ ^ n);
    const vector couple(C(w) + H(m));
    const vector F(R_ & n);

    Fi += F;
    Fj -= F;
    Ti += R_ & (0.5*w + couple);
    Tj += R_ & (0.5*w - couple);
}


Foam::vector Foam::rotationGradient(const vector& phi, const vector& v)
{
    const scalar p2 = magSqr(phi);
    scalar c = 1.0/12.0 + p2/720*(1 + p2/42*(1 + p2/40));
    if (p2 > 0.01)
    {
        const scalar p = Foam::sqrt(p2);
        c = (1 - 0.5*p/Foam::tan(0.5*p))/p2;
    }
    const vector pv(phi ^ v);

    return v + 0.5*pv + c*(phi ^ pv);
}


Foam::vector Foam::rotationVectorGradient(const vector& phi, const vector& v)
{
    const scalar a2 = magSqr(phi);
    const scalar a = Foam::sqrt(a2);
    const bool small = a2 < 1e-4;
    const scalar f = small ? 0.5 - a2/24 : (1 - Foam::cos(a))/a2;
    const scalar g = small ? 1.0/6 - a2/120 : (a - Foam::sin(a))/(a*a2);
    const vector pv(phi ^ v);

    return v - f*pv + g*(phi ^ pv);
}
