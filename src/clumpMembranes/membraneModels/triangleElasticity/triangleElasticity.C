/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "triangleElasticity.H"
#include "toEigen.H"
#include <Eigen/Eigenvalues>

namespace
{

using namespace Foam;

typedef Eigen::Matrix<double, 6, 1> vector6;
typedef Eigen::Matrix<double, 6, 6> matrix6;

vector toFoam(const Eigen::Vector3d& v)
{
    return vector(v.x(), v.y(), v.z());
}

}


Foam::triangleElasticity::rest::rest(const triFace& t, const pointField& x0)
{
    const vector a(x0[t[1]] - x0[t[0]]);
    const vector b(x0[t[2]] - x0[t[0]]);
    const scalar q = magSqr(a ^ b);
    aa = (b & b)/q;
    ab = -(a & b)/q;
    bb = (a & a)/q;
    area = 0.5*Foam::sqrt(q);
}


Foam::triangleElasticity::triangleElasticity
(
    const closedSurface& surface,
    const pointField& x0
)
:
    surface_(surface),
    rest_(surface.triangles().size())
{
    forAll(rest_, n)
    {
        rest_[n] = rest(surface.triangles()[n], x0);
    }
}


Eigen::Matrix<double, 6, 6> Foam::triangleElasticity::areaHessian
(
    const Eigen::Vector3d& a,
    const Eigen::Vector3d& b
)
{
    const Eigen::Matrix3d one(Eigen::Matrix3d::Identity());
    matrix6 H;
    H.block<3, 3>(0, 0) = 2*(b.dot(b)*one - b*b.transpose());
    H.block<3, 3>(3, 3) = 2*(a.dot(a)*one - a*a.transpose());
    H.block<3, 3>(0, 3) =
        2*(2*a*b.transpose() - b*a.transpose() - a.dot(b)*one);
    H.block<3, 3>(3, 0) = H.block<3, 3>(0, 3).transpose();
    return H;
}


Eigen::Matrix<double, 6, 6> Foam::triangleElasticity::kept
(
    const Eigen::Matrix<double, 6, 6>& H,
    const membraneTangent& tangent
)
{
    if (tangent.exact())
    {
        return H;
    }
    const Eigen::SelfAdjointEigenSolver<matrix6> eigen(H);
    if (eigen.eigenvalues()[0] >= 0)
    {
        return H;
    }
    Eigen::Matrix<double, 6, 1> values(eigen.eigenvalues());
    for (label k = 0; k < 6; ++k)
    {
        values[k] = tangent.kept(values[k]);
    }
    return
        eigen.eigenvectors()*values.asDiagonal()*eigen.eigenvectors().transpose();
}


void Foam::triangleElasticity::addEdges
(
    const triFace& t,
    const Eigen::Matrix<double, 6, 6>& H,
    membraneTangent& tangent
)
{
    // The edges are the differences of the nodes 1 and 2 from node 0
    Eigen::Matrix<double, 9, 9> full;
    full.block<6, 6>(3, 3) = H;
    full.block<6, 3>(3, 0) = -H.leftCols<3>() - H.rightCols<3>();
    full.block<3, 6>(0, 3) = full.block<6, 3>(3, 0).transpose();
    full.block<3, 3>(0, 0) =
        -full.block<3, 3>(0, 3) - full.block<3, 3>(0, 6);
    tangent.addDense(t, 3, full);
}


Foam::scalar Foam::triangleElasticity::addTriangle
(
    const triFace& t,
    const rest& r,
    const scalar factor,
    const pointField& x,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    const Eigen::Vector3d a(toEigen(x[t[1]] - x[t[0]]));
    const Eigen::Vector3d b(toEigen(x[t[2]] - x[t[0]]));
    const scalar aa = a.dot(a);
    const scalar ab = a.dot(b);
    const scalar bb = b.dot(b);
    const scalar q0 = 4*sqr(r.area);
    const scalar weight = factor*r.area;

    const response w
    (
        law
        (
            r.aa*aa + 2*r.ab*ab + r.bb*bb - 2,
            (aa*bb - sqr(ab))/q0 - 1
        )
    );

    vector6 g1, g2;
    g1 << 2*(r.aa*a + r.ab*b), 2*(r.ab*a + r.bb*b);
    g2 << 2/q0*(bb*a - ab*b), 2/q0*(aa*b - ab*a);

    const vector6 g(weight*(w.W1*g1 + w.W2*g2));
    gradient[t[1]] += toFoam(g.head<3>());
    gradient[t[2]] += toFoam(g.tail<3>());
    gradient[t[0]] -= toFoam(g.head<3>() + g.tail<3>());

    if (tangent)
    {
        const Eigen::Matrix3d one(Eigen::Matrix3d::Identity());
        matrix6 H1;
        H1 <<
            2*r.aa*one, 2*r.ab*one,
            2*r.ab*one, 2*r.bb*one;
        matrix6 H
        (
            w.W1*H1 + w.W2/q0*areaHessian(a, b)
          + w.W11*g1*g1.transpose() + w.W22*g2*g2.transpose()
        );
        H += w.W12*(g1*g2.transpose() + g2*g1.transpose());
        H *= weight;
        addEdges(t, kept(H, *tangent), *tangent);
    }
    return weight*w.W;
}


Foam::scalar Foam::triangleElasticity::add
(
    const pointField& x,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    scalar energy = 0;
    forAll(rest_, n)
    {
        energy += addTriangle
        (
            surface_.triangles()[n], rest_[n], 1, x, gradient, tangent
        );
    }
    return energy;
}


void Foam::triangleElasticity::addTensions
(
    const pointField& x,
    symmTensorField& tensions
) const
{
    forAll(rest_, n)
    {
        const rest& r = rest_[n];
        const triFace& t = surface_.triangles()[n];
        const vector a(x[t[1]] - x[t[0]]);
        const vector b(x[t[2]] - x[t[0]]);
        const Pair<scalar> I(invariants(r, a, b));
        const response w(law(I.first(), I.second()));
        const vector normal(a ^ b);
        const scalar q0 = 4*sqr(r.area);

        // Derivatives of the energy per area at rest by the edges
        const vector ga(2*w.W1*(r.aa*a + r.ab*b) + 2*w.W2/q0*(b ^ normal));
        const vector gb(2*w.W1*(r.ab*a + r.bb*b) - 2*w.W2/q0*(a ^ normal));
        tensions[n] += 2*r.area/max(mag(normal), VSMALL)*symm(a*ga + b*gb);
    }
}


Foam::scalar Foam::triangleElasticity::addRelative
(
    const pointField& from,
    const UList<scalar>& factors,
    const pointField& x,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    scalar energy = 0;
    forAll(factors, n)
    {
        const triFace& t = surface_.triangles()[n];
        energy += addTriangle(t, rest(t, from), factors[n], x, gradient, tangent);
    }
    return energy;
}
