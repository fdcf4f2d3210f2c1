/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "implicitEuler.H"

namespace Foam
{
namespace integrators
{
    defineTypeNameAndDebug(implicitEuler, 0);
    addToRunTimeSelectionTable(integrator, implicitEuler, dictionary);
}
}

namespace
{

using namespace Foam;

//- The step's unknowns and their potential
class stepProblem
{
    const clumpType& type_;
    const integrator::externals& ext_;
    const scalar dt_;
    const clumpState& start_;
    const bondForces bonds_;
    vectorField F_;
    vectorField T_;


public:

    stepProblem
    (
        const clumpType& type,
        const integrator::externals& ext,
        const scalar dt,
        const clumpState& start
    )
    :
        type_(type), ext_(ext), dt_(dt), start_(start), bonds_(type, start),
        F_(type.size()), T_(type.size())
    {}

    const bondForces& bonds() const { return bonds_; }

    //- Velocities that belong to the positions of s
    void setVelocities(clumpState& s) const
    {
        forAll(s.x, i)
        {
            s.u[i] = (s.x[i] - start_.x[i])/dt_;
            s.w[i] = rotationVector(s.q[i]*conjugate(start_.q[i]))/dt_;
        }
    }

    //- Potential of s; optionally its gradient and tangent
    scalar potential
    (
        const clumpState& s,
        Eigen::VectorXd* gradient = nullptr,
        Eigen::MatrixXd* K = nullptr,
        const bool geometric = true
    )
    {
        if (K)
        {
            K->setZero();
        }

        scalar W = bonds_.stepForces(s, dt_, F_, T_, K, geometric);

        forAll(s.x, i)
        {
            const vector du(s.u[i] - start_.u[i]);
            const vector dw(s.w[i] - start_.w[i]);
            const vector dx(s.x[i] - start_.x[i]);
            const vector duR(s.u[i] - ext_.u0[i]);
            const vector dwR(s.w[i] - ext_.w0[i]);
            const scalar m = type_.masses()[i];
            const scalar I = type_.inertias()[i];
            const scalar z = ext_.zeta[i]*dt_;
            const scalar zR = ext_.zetaR[i]*dt_;
            const vector kx(ext_.k[i] & dx);

            W +=
                0.5*(m*magSqr(du) + z*magSqr(duR))
              + 0.5*(I*magSqr(dw) + zR*magSqr(dwR))
              - (ext_.f[i] & dx) + 0.5*(kx & dx)
              - (ext_.t[i] & (s.w[i]*dt_));

            if (gradient)
            {
                const vector g
                (
                    (m*du + z*duR)/dt_ - ext_.f[i] + kx - F_[i]
                );
                const vector h((I*dw + zR*dwR)/dt_ - ext_.t[i] - T_[i]);
                gradient->segment<6>(6*i) <<
                    g.x(), g.y(), g.z(), h.x(), h.y(), h.z();
            }

            if (K)
            {
                const symmTensor& k = ext_.k[i];
                Eigen::Matrix3d kw;
                kw << k.xx(), k.xy(), k.xz(),
                      k.xy(), k.yy(), k.yz(),
                      k.xz(), k.yz(), k.zz();
                K->block<3, 3>(6*i, 6*i) += kw;

                for (label c = 0; c < 3; ++c)
                {
                    (*K)(6*i + c, 6*i + c) += (m + z)/sqr(dt_);
                    (*K)(6*i + 3 + c, 6*i + 3 + c) += (I + zR)/sqr(dt_);
                }
            }
        }

        return W;
    }
};

}


Foam::integrators::implicitEuler::implicitEuler(const dictionary& dict)
:
    tolerance_(getPositive(dict, "tolerance")),
    maxIterations_
    (
        dict.getCheck<label>("maxIterations", [](label x){ return x > 0; })
    )
{}


void Foam::integrators::implicitEuler::advance
(
    const clumpType& type,
    const externals& ext,
    const scalar dt,
    clumpState& s
) const
{
    const clumpState start(s);
    stepProblem problem(type, ext, dt, start);

    const label n = 6*type.size();
    Eigen::MatrixXd K(n, n);
    Eigen::VectorXd gradient(n);
    Eigen::LLT<Eigen::MatrixXd> cholesky(n);

    // Start from the explicit motion where it lies lower than rest
    problem.setVelocities(s);
    const scalar W0 = problem.potential(s);
    forAll(s.x, i)
    {
        s.x[i] += dt*start.u[i];
        s.q[i] = rotation(dt*start.w[i])*start.q[i];
    }
    problem.setVelocities(s);
    if (problem.potential(s) > W0)
    {
        s = start;
        problem.setVelocities(s);
    }

    scalar moved = GREAT;
    label iter = 0;

    for (; iter < maxIterations_ && moved > tolerance_; ++iter)
    {
        const scalar W = problem.potential(s, &gradient, &K, true);

        cholesky.compute(K);
        if (cholesky.info() != Eigen::Success)
        {
            // Past buckling the tangent is indefinite: its material part is not
            problem.potential(s, &gradient, &K, false);
            cholesky.compute(K);
        }
        const Eigen::VectorXd step(-cholesky.solve(gradient));

        const clumpState before(s);
        scalar fraction = 1;

        while (true)
        {
            moved = 0;
            forAll(s.x, i)
            {
                const vector dx(step[6*i], step[6*i + 1], step[6*i + 2]);
                const vector dq(step[6*i + 3], step[6*i + 4], step[6*i + 5]);
                s.x[i] = before.x[i] + fraction*dx;
                s.q[i] = rotation(fraction*dq)*before.q[i];
                s.q[i].normalize();
                moved = max
                (
                    moved,
                    fraction*max(mag(dx)/type.radii()[i], mag(dq))
                );
            }
            problem.setVelocities(s);

            // Below the tolerance the potential is flat to rounding
            if (moved <= tolerance_ || problem.potential(s) <= W)
            {
                break;
            }
            fraction *= 0.5;
        }
    }

    if (moved > tolerance_)
    {
        WarningInFunction
            << "Clump of type " << type.name() << ": Newton's method stopped "
            << "after " << iter << " iterations, last step " << moved
            << " sphere radii" << endl;
    }

    balanceMomentum(type, ext, dt, start, s);
    problem.bonds().store(s);
}


void Foam::integrators::implicitEuler::balanceMomentum
(
    const clumpType& type,
    const externals& ext,
    const scalar dt,
    const clumpState& start,
    clumpState& s
)
{
    const point centre0(start.centre(type));
    const point centre(s.centre(type));

    // What is missing in the balance, and the inertia that answers
    vector P(Zero), L(Zero), S(Zero);
    scalar M = 0;
    tensor I(Zero);

    forAll(s.x, i)
    {
        const scalar m = type.masses()[i];
        const scalar z = ext.zeta[i]*dt;
        const scalar J = type.inertias()[i];
        const scalar JR = ext.zetaR[i]*dt;
        const vector r0(start.x[i] - centre0);
        const vector r(s.x[i] - centre);
        const vector impulse
        (
            dt*(ext.f[i] - (ext.k[i] & (s.x[i] - start.x[i])))
          - z*(s.u[i] - ext.u0[i])
        );

        P += impulse - m*(s.u[i] - start.u[i]);
        L +=
            (r ^ impulse) - m*((r ^ s.u[i]) - (r0 ^ start.u[i]))
          + dt*ext.t[i] - J*(s.w[i] - start.w[i]) - JR*(s.w[i] - ext.w0[i]);

        M += m + z;
        S += (m + z)*r;
        I += ((m + z)*magSqr(r) + J + JR)*tensor::I - (m + z)*(r*r);
    }

    // About the centre of the inertia that answers (zeta may not follow m)
    const vector c(S/M);
    L -= c ^ P;
    I -= M*(magSqr(c)*tensor::I - c*c);

    const vector du(P/M);
    const scalar scale = tr(I);
    const vector dw(inv(I/scale) & (L/scale));

    forAll(s.x, i)
    {
        s.u[i] += du + (dw ^ (s.x[i] - centre - c));
        s.w[i] += dw;
    }
}
