/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "nodeWeights.H"
#include <Eigen/Eigenvalues>

namespace
{

using namespace Foam;

//- C^-1 v without the directions in which C is nearly zero
vector inverseTimes(const symmTensor& C, const vector& v)
{
    constexpr scalar thinnest = 1e-3;

    // Relative to its size: no underflow
    const scalar size = max(tr(C), VSMALL);
    Eigen::Matrix3d M;
    M <<
        C.xx(), C.xy(), C.xz(),
        C.xy(), C.yy(), C.yz(),
        C.xz(), C.yz(), C.zz();
    M /= size;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(M);
    const Eigen::Vector3d given(v.x(), v.y(), v.z());
    Eigen::Vector3d result(Eigen::Vector3d::Zero());
    for (label d = 0; d < 3; ++d)
    {
        if (eigen.eigenvalues()[d] > thinnest)
        {
            const Eigen::Vector3d e(eigen.eigenvectors().col(d));
            result += e.dot(given)/(size*eigen.eigenvalues()[d])*e;
        }
    }
    return vector(result[0], result[1], result[2]);
}

}


void Foam::nodeMoments::reset(const label n)
{
    m0.setSize(n);
    m1.setSize(n);
    m2.setSize(n);
    m0 = Zero;
    m1 = Zero;
    m2 = Zero;
}


void Foam::nodeMoments::operator+=(const nodeMoments& other)
{
    m0 += other.m0;
    m1 += other.m1;
    m2 += other.m2;
}


void Foam::nodeMoments::bringBack(const imageTransform& from)
{
    from.polars(m1);
    from.tensors(m2);
}


Foam::symmTensor Foam::nodeMoments::covariance(const label i) const
{
    if (!(m0[i] > 0))
    {
        return Zero;
    }
    return m2[i]/m0[i] - sqr(m1[i]/m0[i]);
}


void Foam::nodeWeights::set(const nodeMoments& m)
{
    const label n = m.m0.size();
    a = scalarField(n, Zero);
    b = vectorField(n, Zero);
    for (label i = 0; i < n; ++i)
    {
        if (m.m0[i] > 0)
        {
            const vector mean(m.m1[i]/m.m0[i]);
            const vector slope(inverseTimes(m.covariance(i), mean));
            b[i] = -slope/m.m0[i];
            a[i] = (1 + (slope & mean))/m.m0[i];
        }
    }
}


Foam::Ostream& Foam::operator<<(Ostream& os, const nodeMoments& m)
{
    return os << m.m0 << m.m1 << m.m2;
}


Foam::Istream& Foam::operator>>(Istream& is, nodeMoments& m)
{
    return is >> m.m0 >> m.m1 >> m.m2;
}


Foam::Ostream& Foam::operator<<(Ostream& os, const nodeWeights& w)
{
    return os << w.a << w.b;
}


Foam::Istream& Foam::operator>>(Istream& is, nodeWeights& w)
{
    return is >> w.a >> w.b;
}
