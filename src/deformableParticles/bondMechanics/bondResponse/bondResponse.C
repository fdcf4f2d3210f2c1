/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondResponse.H"

Foam::vector Foam::bondResponse::direction
(
    const clumpBonds::bond& b,
    const vector& d,
    const scalar length
)
{
    return length > 1e-12*b.length ? d/length : b.direction;
}


Foam::bondResponse::bondResponse
(
    const bondModel& law,
    const clumpBonds::bond& b,
    const vector& d,
    const vector& psi
)
{
    const vector& e = b.direction;
    const bondCoefficients& k = b.stiffness;
    const scalar length = mag(d);
    const scalar torsion = psi & e;
    const vector bending(psi - torsion*e);

    t = direction(b, d, length);

    const bondModel::axialResponse axialLaw
    (
        law.axial(length - b.length, b.length, k.normal)
    );
    const scalar shear = k.tangential*b.length;

    n = (axialLaw.force + shear)*t - shear*e;
    m = k.torsional*torsion*e + k.bending*bending;
    energy =
        axialLaw.energy
      + 0.5*shear*length*magSqr(t - e)
      + 0.5*(k.torsional*sqr(torsion) + k.bending*magSqr(bending));

    locking = Zero;
    const scalar theta = mag(psi);
    const scalar x = theta - lockingAngle;
    if (x > 0)
    {
        const scalar S = 10*max(k.torsional, k.bending);
        const vector a(psi/theta);
        energy += S*pow3(x);
        m += 3*S*sqr(x)*a;
        locking = 6*S*x*sqr(a) + 3*S*sqr(x)/theta*(symmTensor::I - sqr(a));
    }

    axial = axialLaw.force;
    kAlong = axialLaw.tangent;
    kAcross = (axialLaw.force + shear)/max(length, 1e-12*b.length);
}
