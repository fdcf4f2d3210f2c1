/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondSpring.H"
#include "toEigen.H"

Foam::bondSpring::bondSpring()
:
    arm_(Zero),
    otherArm_(Zero),
    length_(0),
    energy_(0),
    tension_(0),
    force_(Zero),
    K_(Zero)
{}


void Foam::bondSpring::evaluate
(
    const bondKinetics& kinetics,
    const vector& between,
    const vector& arm,
    const vector& otherArm
)
{
    arm_ = arm;
    otherArm_ = otherArm;
    const vector d(between + otherArm - arm);
    length_ = mag(d);
    energy_ = kinetics.energy(length_);
    tension_ = kinetics.tension(length_);
    force_ = Zero;
    K_ = Zero;
    if (tension_ > 0)
    {
        const vector e(d/length_);
        force_ = tension_*e;
        K_ =
            kinetics.stiffness(length_)*sqr(e)
          + tension_/length_*(symmTensor::I - sqr(e));
    }
}


void Foam::bondSpring::addRotations(clumpTangent::block& D) const
{
    const Eigen::Matrix3d K(toEigen(K_));
    const Eigen::Matrix3d C(crossMatrix(toEigen(arm_)));
    D.topRightCorner<3, 3>() -= K*C;
    D.bottomLeftCorner<3, 3>() += C*K;
    D.bottomRightCorner<3, 3>() -= C*K*C;

    // The arm turns as well. Where this lowers the torque, Newton's method does without
    const scalar outward = arm_ & force_;
    if (outward > 0)
    {
        D.bottomRightCorner<3, 3>() +=
            outward*toEigen(symmTensor::I - sqr(arm_)/magSqr(arm_));
    }
}


void Foam::bondSpring::ofOther
(
    const vector& moved,
    const vector& turned,
    vector& force,
    vector& torque
) const
{
    force = K_ & (moved + (turned ^ otherArm_));
    torque = arm_ ^ force;
}
