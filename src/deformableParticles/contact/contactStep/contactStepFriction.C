/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStep.H"
#include "bondFrame.H"
#include "mathematicalConstants.H"
#include "toEigen.H"

namespace
{

using namespace Foam;

//- Change of the rotation vector phi by a small further rotation: J^-1 with the left
//  Jacobian J of the exponential map
Eigen::Matrix3d byFurtherRotation(const vector& phi)
{
    Eigen::Matrix3d result;
    for (direction k = 0; k < vector::nComponents; ++k)
    {
        vector e(Zero);
        e[k] = 1;
        result.row(k) = toEigen(rotationGradient(phi, e)).transpose();
    }
    return result;
}

}


void Foam::contactStep::frictionPotential::evaluate
(
    const vector& s,
    const vector& n
)
{
    const scalar root2 = magSqr(s) + sqr(smooth);
    const scalar root = Foam::sqrt(root2);
    energy = limit*(root - smooth);
    force = -limit/max(root, VSMALL)*s;
    tangent = Zero;
    if (limit > 0 && smooth > 0)
    {
        tangent = limit/root*(symmTensor::I - sqr(n) - sqr(s)/root2);
    }
}


void Foam::contactStep::setPressed(sphereContact& t) const
{
    t.pressed = t.pressing;
    t.slipNormal = t.n;
    const scalar friction = t.law ? t.law->friction() : 0;
    const scalar rolling = t.law ? t.law->rollingFriction() : 0;

    // What the force would move the body in the step, against its inertia and the fluid
    const scalar drag =
        6*constant::mathematical::pi*gaps_.viscosity()*t.R;
    const scalar moved =
        1e-3*smoothing_*t.pressed*dt_/max(t.m/dt_ + drag, VSMALL);
    t.sliding = {friction*t.pressed, friction*moved, Zero, Zero, 0};
    t.rolling = {rolling*t.R*t.pressed, rolling*moved/t.R, Zero, Zero, 0};

    // The place of contact is in the middle of the overlap, at the wall in its plane
    const scalar radius = type(t.a).radii()[t.i];
    if (t.b < 0)
    {
        t.arm = radius - t.d;
        t.otherArm = 0;
    }
    else
    {
        const scalar distance = t.radii - t.d;
        t.arm = radius*distance/(radius + otherRadius(t));
        t.otherArm = distance - t.arm;
    }
}


void Foam::contactStep::setPressed()
{
    for (const label a : clumpOf_)
    {
        for (label k = begins_[a]; k < begins_[a + 1]; ++k)
        {
            setPressed(sphereContacts_[k]);
        }
    }
}


Foam::vector Foam::contactStep::slip(const sphereContact& t) const
{
    const vector& n = t.slipNormal;
    vector dx(displacement(t));
    if (inPart_)
    {
        dx -= before_[t.a][t.i];
        dx += t.b < 0 ? vector::zero : ofImage(t, before_[t.otherIndex][t.j]);
    }
    vector turned(t.arm*turned_[t.a][t.i]);
    if (t.b >= 0)
    {
        turned += t.otherArm*turnOfImage(t, turned_[t.otherIndex][t.j]);
    }
    else
    {
        dx -= dt_*walls_.velocity(t.patch, t.place) + t.moved;
    }
    return dx - (n & dx)*n + (n ^ turned);
}


Foam::vector Foam::contactStep::roll(const sphereContact& t) const
{
    const vector other
    (
        t.b < 0
      ? vector(dt_*walls_.rotation(t.patch))
      : turnOfImage(t, turned_[t.otherIndex][t.j])
    );
    const vector r(turned_[t.a][t.i] - other);
    return r - (t.slipNormal & r)*t.slipNormal;
}


void Foam::contactStep::evaluateFriction(sphereContact& t) const
{
    if (rubs_ && t.pressed > 0)
    {
        t.sliding.evaluate(slip(t), t.slipNormal);
        t.rolling.evaluate(roll(t), t.slipNormal);
    }
    else
    {
        t.sliding = t.rolling = {0, 0, Zero, Zero, 0};
    }
}


void Foam::contactStep::addRotations(const label m, clumpTangent& K) const
{
    const label a = clumpOf_[m];
    for (label k = begins_[a]; k < begins_[a + 1]; ++k)
    {
        const sphereContact& t = sphereContacts_[k];
        if (t.pressed <= 0)
        {
            continue;
        }
        const Eigen::Matrix3d A(toEigen(t.sliding.tangent));
        const Eigen::Matrix3d J(byFurtherRotation(turned_[a][t.i]));
        const Eigen::Matrix3d N(t.arm*crossMatrix(toEigen(t.slipNormal))*J);
        clumpTangent::block& D = K.diagonal(t.i);
        D.topRightCorner<3, 3>() += A*N;
        D.bottomLeftCorner<3, 3>() += N.transpose()*A;
        D.bottomRightCorner<3, 3>() +=
            N.transpose()*A*N + J.transpose()*toEigen(t.rolling.tangent)*J;
    }
    for (label n = bondBegins_[a]; n < bondBegins_[a + 1]; ++n)
    {
        bondEnds_[n].spring.addRotations(K.diagonal(bondEnds_[n].i));
    }
}


void Foam::contactStep::coupleFriction(const motions& p, motions& Ap)
{
    const List<vectorField> moves(gatherVectors(p));
    const List<vectorField> turns(gatherVectors(p, 3));

    forAll(coupled_, m)
    {
        const label a = clumpOf_[m];
        for (label k = begins_[a]; k < begins_[a + 1]; ++k)
        {
            const sphereContact& t = sphereContacts_[k];
            if (t.b < 0 || t.pressed <= 0 || moves[t.otherIndex].empty())
            {
                continue;
            }
            const vector& n = t.slipNormal;
            const vector turn
            (
                turnOfImage
                (
                    t,
                    rotationGradient
                    (
                        -turned_[t.otherIndex][t.j], turns[t.otherIndex][t.j]
                    )
                )
            );
            const vector otherSlip
            (
                t.otherArm*(n ^ turn) - ofImage(t, moves[t.otherIndex][t.j])
            );
            const vector f(t.sliding.tangent & otherSlip);
            const vector moment(t.rolling.tangent & turn);
            Ap[m].segment<3>(6*t.i) += toEigen(f);
            Ap[m].segment<3>(6*t.i + 3) += toEigen
            (
                rotationGradient(turned_[a][t.i], t.arm*(f ^ n) - moment)
            );
        }
    }
}
