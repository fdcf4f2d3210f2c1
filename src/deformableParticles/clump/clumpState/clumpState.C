/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpState.H"

Foam::clumpState::clumpState
(
    const clumpType& type,
    const quaternion& orientation
)
:
    x(type.centres()),
    u(type.size(), Zero),
    q(type.size(), orientation),
    w(type.size(), Zero),
    a(type.size(), Zero),
    b(type.size(), Zero)
{
    const tensor R(orientation.R());
    for (point& p : x)
    {
        p = R & p;
    }
}


Foam::clumpState Foam::clumpState::part
(
    const labelUList& spheres,
    const labelUList& bonds
) const
{
    clumpState result;
    result.x = pointField(x, spheres);
    result.u = vectorField(u, spheres);
    result.w = vectorField(w, spheres);
    result.a = vectorField(a, spheres);
    result.b = vectorField(b, spheres);
    for (const label i : spheres)
    {
        result.q.append(q[i]);
    }
    if (broken.size())
    {
        const scalarField ofPiece(broken, bonds);
        if (ofPiece.size() && max(ofPiece) > 0)
        {
            result.broken = ofPiece;
        }
    }
    return result;
}


Foam::point Foam::clumpState::centre(const clumpType& type) const
{
    return sum(type.masses()*x)/type.mass();
}


Foam::vector Foam::clumpState::velocity(const clumpType& type) const
{
    return sum(type.masses()*u)/type.mass();
}


Foam::vector Foam::clumpState::angularMomentum(const clumpType& type) const
{
    const point xc(centre(type));
    vector L(Zero);
    forAll(x, i)
    {
        L += ((x[i] - xc) ^ (type.masses()[i]*u[i])) + type.inertias()[i]*w[i];
    }
    return L;
}


Foam::tensor Foam::clumpState::inertia(const clumpType& type) const
{
    const point xc(centre(type));
    tensor I(Zero);
    forAll(x, i)
    {
        const vector r(x[i] - xc);
        I +=
            (type.masses()[i]*magSqr(r) + type.inertias()[i])*tensor::I
          - type.masses()[i]*(r*r);
    }
    return I;
}


Foam::vector Foam::clumpState::angularVelocity(const clumpType& type) const
{
    // Scaled to order one: the inverse's determinant would underflow
    const tensor I(inertia(type));
    const scalar scale = tr(I);
    return inv(I/scale) & (angularMomentum(type)/scale);
}


Foam::scalar Foam::clumpState::kineticEnergy(const clumpType& type) const
{
    return
        0.5*sum(type.masses()*magSqr(u))
      + 0.5*sum(type.inertias()*magSqr(w));
}


void Foam::clumpState::setRigidMotion
(
    const clumpType& type,
    const vector& velocity,
    const vector& omega
)
{
    const point xc(centre(type));
    forAll(x, i)
    {
        u[i] = velocity + (omega ^ (x[i] - xc));
        w[i] = omega;
    }
}


Foam::Ostream& Foam::operator<<(Ostream& os, const clumpState& s)
{
    os  << s.x << token::SPACE << s.u << token::SPACE << s.q << token::SPACE
        << s.w << token::SPACE << s.a << token::SPACE << s.b << token::SPACE << s.broken
        << token::SPACE << s.nodeForces << token::SPACE << s.nodeForceRates;
    os.check(FUNCTION_NAME);
    return os;
}


Foam::Istream& Foam::operator>>(Istream& is, clumpState& s)
{
    is >> s.x >> s.u >> s.q >> s.w >> s.a >> s.b >> s.broken
        >> s.nodeForces >> s.nodeForceRates;
    is.check(FUNCTION_NAME);
    return is;
}
