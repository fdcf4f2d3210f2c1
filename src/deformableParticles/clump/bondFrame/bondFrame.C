/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondFrame.H"

Foam::vector Foam::rotationVector(const quaternion& q)
{
    const scalar sign = q.w() < 0 ? -1 : 1;
    const scalar s = mag(q.v());

    // theta/sin(theta/2) -> 2 for small angles
    const scalar scale =
        s > 1e-8 ? 2*Foam::atan2(s, sign*q.w())/s : 2/(sign*q.w());

    return sign*scale*q.v();
}


Foam::quaternion Foam::rotation(const vector& v)
{
    const scalar angle = mag(v);
    const scalar s = angle > 1e-8 ? Foam::sin(angle/2)/angle : 0.5;
    quaternion q(Foam::cos(angle/2), s*v);
    q.normalize();
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
    const quaternion relative(conjugate(qi)*qj);
    psi_ = rotationVector(relative);

    quaternion mean(qi*rotation(0.5*psi_));
    mean.normalize();
    R_ = mean.R();
    d_ = R_.T() & (xj - xi);

    const scalar theta = mag(psi_);
    if (theta > 1e-6)
    {
        h_ = (theta/2)/Foam::sin(theta/2);
        c_ = -Foam::tan(theta/4)/(2*theta);
        invTheta2_ = 1/sqr(theta);
    }
    else
    {
        h_ = 1;
        c_ = -0.125;
        invTheta2_ = 0;
    }
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
    const vector relative(R_.T() & (wj - wi));
    const vector spin((R_.T() & (0.5*(wi + wj))) + C(relative));

    gammaRate = (R_.T() & (uj - ui)) - (spin ^ d_);
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
