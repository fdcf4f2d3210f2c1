/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "resistanceMatrix.H"
#include "foamCompat.H"
#include "mathematicalConstants.H"

Foam::resistanceMatrix::resistanceMatrix
(
    deformableCloud& cloud,
    const label clump,
    const bool rotation
)
:
    cloud_(cloud),
    clump_(clump),
    rotation_(rotation),
    size_(0),
    typeId_(-1)
{
    label lowest = labelMax;
    label highest = -1;
    for (const clumpParcel& p : cloud)
    {
        lowest = min(lowest, p.origId());
        highest = max(highest, p.origId());
        if (p.origId() == clump)
        {
            typeId_ = p.typeId();
            x_ = p.state().x - p.state().centre(cloud.type(p));
        }
    }
    reduce(typeId_, maxOp<label>());
    reduce(lowest, minOp<label>());
    reduce(highest, maxOp<label>());
    if (typeId_ < 0)
    {
        FatalErrorInFunction << "There is no clump " << clump << '.';
        if (highest >= 0)
        {
            FatalError
                << " The clumps have numbers from " << lowest << " to " << highest
                << '.';
        }
        FatalError << exit(FatalError);
    }
    x_.setSize(type().size(), point::min);
    reduceList(x_, maxEqOp<point>());

    size_ = (rotation ? 6 : 3)*type().size();
    R_.setZero(size_, size_);
}


void Foam::resistanceMatrix::setVelocity(const label column)
{
    for (clumpParcel& p : cloud_)
    {
        clumpState& s = p.state();
        s.u = Zero;
        s.w = Zero;
        if (p.origId() == clump_ && column >= 0)
        {
            const label n = s.u.size();
            const label i = column/3 % n;
            vector& v = column < 3*n ? s.u[i] : s.w[i];
            v[column % 3] = column < 3*n ? 1 : 1/type().radii()[i];
        }
    }
}


Eigen::VectorXd Foam::resistanceMatrix::forces() const
{
    scalarField f(size_, Zero);
    for (const clumpParcel& p : cloud_)
    {
        if (p.origId() != clump_)
        {
            continue;
        }
        const label n = p.fluidForces().size();
        forAll(f, row)
        {
            const label i = row/3 % n;
            f[row] =
                row < 3*n
              ? p.fluidForces()[i][row % 3]
              : p.fluidTorques()[i][row % 3]/type().radii()[i];
        }
    }
    reduceList(f, plusEqOp<scalar>());
    return Eigen::Map<const Eigen::VectorXd>(f.cdata(), size_);
}


void Foam::resistanceMatrix::store(const label column)
{
    if (column < 0)
    {
        base_ = forces();
    }
    else
    {
        R_.col(column) = base_ - forces();
    }
}


Eigen::MatrixXd Foam::resistanceMatrix::rigid() const
{
    Eigen::MatrixXd J(Eigen::MatrixXd::Zero(size_, 6));
    for (label row = 0; row < size_; ++row)
    {
        const label i = row/3 % x_.size();
        const direction d = row % 3;
        vector e(Zero);
        e[d] = 1;
        const bool turning = row >= 3*x_.size();

        for (direction c = 0; c < 3; ++c)
        {
            vector axis(Zero);
            axis[c] = 1;
            J(row, c) = turning ? 0 : (d == c);
            J(row, 3 + c) =
                turning ? type().radii()[i]*(d == c) : ((axis ^ x_[i]) & e);
        }
    }
    return J.transpose()*R_*J;
}


void Foam::resistanceMatrix::print(Ostream& os, const scalar mu)
{
    using constant::mathematical::pi;
    const scalar unit = 6*pi*mu*type().radii()[0];

    const Eigen::MatrixXd skew(R_ - R_.transpose());
    const Eigen::VectorXd spectrum
    (
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>
        (
            0.5*(R_ + R_.transpose())
        ).eigenvalues()/unit
    );
    const scalar least = spectrum[0];
    const scalar most = spectrum[size_ - 1];

    os  << "Unit 6 pi mu r = " << unit << " N s/m" << nl
        << "Asymmetry |R - R^T|/|R| = "
        << skew.norm()/R_.norm() << nl
        << "Eigenvalues:";
    for (label i = 0; i < size_; ++i)
    {
        os  << (i % 10 ? " " : "\n    ") << spectrum[i];
    }
    os  << nl << nl
        << "The coupling is stable with a coefficient above " << 0.5*most
        << nl << "Lag of the slowest motion: coefficient x "
        << 1/max(least, ROOTVSMALL) << " steps" << nl << nl
        << "Rigid-body resistance: drag along x, y, z [N s/m] and torque about "
        << "them [N m s]" << nl;

    const Eigen::MatrixXd rb(rigid());
    for (label i = 0; i < 6; ++i)
    {
        os  << "    " << rb(i, i) << nl;
    }
    os  << nl;
}


void Foam::resistanceMatrix::write(Ostream& os) const
{
    os.precision(10);
    os  << "# resistance [N s/m]; rows forces, columns velocities,"
        << " x y z of sphere 0, 1, ..."
        << (rotation_ ? ", then torques over r and angular velocities times r" : "")
        << nl;
    for (label i = 0; i < size_; ++i)
    {
        for (label j = 0; j < size_; ++j)
        {
            os  << (j ? "," : "") << R_(i, j);
        }
        os  << nl;
    }
}
