/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "rigidDeflation.H"
#include <Eigen/Dense>

namespace
{

using namespace Foam;

using Motion = Eigen::Matrix<double, 6, 1>;
using Motions = Eigen::Matrix<double, 6, 6>;
using Jacobian = Eigen::Matrix<double, 3, 6>;

Eigen::Vector3d toEigen(const vector& v)
{
    return Eigen::Vector3d(v.x(), v.y(), v.z());
}

//- Velocity at r due to the rigid motions, angular velocities times a length a
Jacobian rigid(const vector& r, const scalar a)
{
    Jacobian J;
    J.leftCols<3>().setIdentity();
    J.rightCols<3>() <<
        0, r.z()/a, -r.y()/a,
        -r.z()/a, 0, r.x()/a,
        r.y()/a, -r.x()/a, 0;
    return J;
}

//- Mobilities of the spheres, averaged over the directions
Eigen::MatrixXd mobilities(const pointField& x, const scalarField& r)
{
    const label n = r.size();
    Eigen::MatrixXd h(n, n);
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            const scalar mean = 0.5*(r[i] + r[j]);
            const scalar d = mag(x[i] - x[j]);
            h(i, j) = d < 2*mean ? (1 - d/(4*mean))/mean : 1/d;
        }
    }
    return h;
}

}


Foam::rigidDeflation::rigidDeflation(const clumpType& type)
:
    translation_(1),
    rotation_(1)
{
    const clumpState rest(type);
    const pointField x(rest.x - rest.centre(type));
    const scalarField& r = type.radii();
    const label n = r.size();

    Eigen::MatrixXd X(n, 3);
    for (label i = 0; i < n; ++i)
    {
        X.row(i) = toEigen(x[i]).transpose();
    }
    const Eigen::LDLT<Eigen::MatrixXd> h(mobilities(x, r));
    const Eigen::VectorXd one(Eigen::VectorXd::Ones(n));
    const scalar ofTranslation = one.dot(h.solve(one));
    const scalar ofRotation = (X.transpose()*h.solve(X)).trace();
    const scalar moment = sum(r*magSqr(x));

    // Spheres inside each other may have no positive estimate
    if (ofTranslation > 0)
    {
        translation_ = min(scalar(1), 2*ofTranslation/sum(r));
    }
    if (ofRotation > 0 && moment > SMALL*sum(pow3(r)))
    {
        rotation_ = min(scalar(1), ofRotation/moment);
    }
}


void Foam::rigidDeflation::shift
(
    const clumpType& type,
    const clumpState& s,
    const vectorField& fluidU,
    const vectorField& fluidW,
    const scalarField& z,
    const scalarField& zR,
    const scalar dt,
    externalForces& ext
) const
{
    const vectorField r(s.x - s.centre(type));
    const scalar a = max(type.radii());

    Motion rest;
    rest <<
        Eigen::Vector3d::Constant(1 - translation_),
        Eigen::Vector3d::Constant(1 - rotation_);

    Motions A(Motions::Zero());
    Motions Z(Motions::Zero());
    Motion b(Motion::Zero());
    forAll(r, i)
    {
        const Jacobian J(rigid(r[i], a));
        const scalar m = type.masses()[i]/dt;
        const scalar I = type.inertias()[i]/dt;
        const vector f
        (
            ext.f[i] - m*(fluidU[i] - s.u[i])
          - ext.zeta[i]*(fluidU[i] - ext.imposedU[i])
        );
        const vector t
        (
            ext.t[i] - I*(fluidW[i] - s.w[i])
          - ext.zetaR[i]*(fluidW[i] - ext.imposedW[i])
        );
        A += (m + ext.zeta[i])*J.transpose()*J;
        Z += z[i]*J.transpose()*J;
        b += J.transpose()*toEigen(f);

        A.diagonal().tail<3>().array() += (I + ext.zetaR[i])/sqr(a);
        Z.diagonal().tail<3>().array() += zR[i]/sqr(a);
        b.tail<3>() += toEigen(t)/a;
    }

    // The entries are far below one
    const scalar scale = A.trace();
    const Motions balance((A - Z*rest.asDiagonal())/scale);
    const Motion D(rest.asDiagonal()*balance.partialPivLu().solve(b/scale));
    if (!D.allFinite())
    {
        return;
    }
    const vector V(D[0], D[1], D[2]);
    const vector W(vector(D[3], D[4], D[5])/a);
    forAll(r, i)
    {
        ext.imposedU[i] += z[i]/max(ext.zeta[i], VSMALL)*(V + (W ^ r[i]));
        ext.imposedW[i] += zR[i]/max(ext.zetaR[i], VSMALL)*W;
    }
}
