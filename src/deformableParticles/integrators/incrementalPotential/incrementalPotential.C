/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "incrementalPotential.H"
#include "toEigen.H"
#include <Eigen/Eigenvalues>

Foam::incrementalPotential::incrementalPotential
(
    const clumpBonds& bonds,
    const externalForces& ext,
    const scalar dt,
    const clumpState& start
)
:
    bonds_(bonds),
    type_(bonds.type()),
    ext_(ext),
    oneByDt_(dt > 0 ? 1/dt : 0),
    start_(start),
    group_(nullptr),
    groupIndex_(-1),
    forces_(bonds, start),
    F_(type_.size()),
    T_(type_.size())
{}


Foam::scalar Foam::incrementalPotential::value
(
    const clumpState& s,
    Eigen::VectorXd* gradient,
    clumpTangent* K,
    const bool geometric
) const
{
    if (K)
    {
        K->setZero();
    }

    scalar W = forces_.stepForces
    (
        s, moving() ? 1/oneByDt_ : 0, F_, T_, K, geometric
    );

    forAll(s.x, i)
    {
        const vector dx(s.x[i] - start_.x[i]);
        const vector phi(rotationVector(s.q[i]*conjugate(start_.q[i])));
        const vector du(oneByDt_*dx - start_.u[i]);
        const vector dw(oneByDt_*phi - start_.w[i]);
        const vector duR(oneByDt_*dx - ext_.imposedU[i]);
        const vector dwR(oneByDt_*phi - ext_.imposedW[i]);
        const scalar m = type_.masses()[i]*oneByDt_;
        const scalar I = type_.inertias()[i]*oneByDt_;
        const scalar z = ext_.zeta[i];
        const scalar zR = ext_.zetaR[i];
        const vector kx(ext_.k[i] & dx);

        if (moving())
        {
            W +=
                0.5*(m*magSqr(du) + z*magSqr(duR))/oneByDt_
              + 0.5*(I*magSqr(dw) + zR*magSqr(dwR))/oneByDt_;
        }
        W += 0.5*(kx & dx) - (ext_.f[i] & dx) - (ext_.t[i] & phi);

        if (gradient)
        {
            vector g(kx - ext_.f[i] - F_[i]);
            vector h(-ext_.t[i]);
            if (group_ && group_->turns())
            {
                h -= group_->torques(groupIndex_)[i];
            }
            if (moving())
            {
                g += m*du + z*duR;
                h += I*dw + zR*dwR;
            }
            h = rotationGradient(phi, h) - T_[i];
            gradient->segment<6>(6*i) <<
                g.x(), g.y(), g.z(), h.x(), h.y(), h.z();
        }

        if (K)
        {
            clumpTangent::block& D = K->diagonal(i);
            D.topLeftCorner<3, 3>() += toEigen(ext_.k[i]);

            if (moving())
            {
                D.diagonal().head<3>().array() += (m + z)*oneByDt_;
                D.diagonal().tail<3>().array() += (I + zR)*oneByDt_;
            }
        }
    }

    if (group_)
    {
        W += group_->energy(groupIndex_);
        addInteraction(gradient, K);
    }
    if (ext_.turned || tr(ext_.held) > 0)
    {
        hold(gradient, K);
    }

    return W;
}


void Foam::incrementalPotential::hold
(
    Eigen::VectorXd* gradient,
    clumpTangent* K
) const
{
    const scalarField share(type_.masses()/type_.mass());
    const Eigen::Matrix3d P(toEigen(ext_.held));
    if (ext_.turned)
    {
        // What is left of the forces and torques is their sum across the held directions
        if (gradient)
        {
            Eigen::Vector3d F(Eigen::Vector3d::Zero());
            forAll(share, i)
            {
                F += gradient->segment<3>(6*i);
            }
            gradient->setZero();
            forAll(share, i)
            {
                gradient->segment<3>(6*i) = share[i]*(F - P*F);
            }
        }
        if (K)
        {
            K->constrainToTranslation(P);
        }
        return;
    }
    if (gradient)
    {
        Eigen::Vector3d H(Eigen::Vector3d::Zero());
        forAll(share, i)
        {
            H += P*gradient->segment<3>(6*i);
        }
        forAll(share, i)
        {
            gradient->segment<3>(6*i) -= share[i]*H;
        }
    }
    if (K)
    {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> directions(P);
        for (label k = 0; k < 3; ++k)
        {
            if (directions.eigenvalues()[k] > 0.5)
            {
                Eigen::VectorXd g(Eigen::VectorXd::Zero(6*share.size()));
                forAll(share, i)
                {
                    g.segment<3>(6*i) = share[i]*directions.eigenvectors().col(k);
                }
                K->addConstraint(g);
            }
        }
    }
}


void Foam::incrementalPotential::addInteraction
(
    Eigen::VectorXd* gradient,
    clumpTangent* K
) const
{
    if (gradient)
    {
        const vectorField& f = group_->forces(groupIndex_);
        forAll(f, i)
        {
            gradient->segment<3>(6*i) -=
                Eigen::Vector3d(f[i].x(), f[i].y(), f[i].z());
        }
    }
    if (K)
    {
        const symmTensorField stiffness(group_->stiffness(groupIndex_));
        forAll(stiffness, i)
        {
            K->diagonal(i).topLeftCorner<3, 3>() += toEigen(stiffness[i]);
        }
        if (group_->turns())
        {
            group_->addRotations(groupIndex_, *K);
        }
    }
}
