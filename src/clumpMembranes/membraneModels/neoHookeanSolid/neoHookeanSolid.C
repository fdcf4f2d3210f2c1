/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "neoHookeanSolid.H"
#include "toEigen.H"
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace Foam
{
namespace membraneModels
{
    defineTypeNameAndDebug(neoHookeanSolid, 0);
    addToRunTimeSelectionTable(membraneModel, neoHookeanSolid, dictionary);
}
}

namespace
{

typedef Eigen::Matrix<double, 9, 9> matrix9;
typedef Eigen::Matrix<double, 12, 12> matrix12;

//- Where the logarithm of J goes over into a parabola
constexpr Foam::scalar leastJ = 0.1;

}


Foam::membraneModels::neoHookeanSolid::neoHookeanSolid
(
    const dictionary& dict,
    const closedSurface& surface,
    const pointField& x0
)
:
    inside_(surface.triangles(), surface.nNodes(), dict),
    shearModulus_(getPositive(dict, "shearModulus"))
{
    checkEntries(dict, {"type", "shearModulus", "poissonRatio"});

    const scalar nu = getBetweenOrDefault(dict, "poissonRatio", 0.4, 0, 0.49);
    lambda_ = 2*shearModulus_*nu/(1 - 2*nu);

    if (x0.size() != inside_.nNodes())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'type' is " << typeName << ", which needs nodes inside the surface."
            << " Give the type a shape that is filled:"
            << "  shape { type filled; surface { type icosphere; ... } }"
            << exit(FatalIOError);
    }
    for (const auto& t : inside_.tetrahedra())
    {
        rest_.push_back({edgesOf(t, x0).inverse(), filledSurface::volume(t, x0)});
    }
}


Eigen::Matrix3d Foam::membraneModels::neoHookeanSolid::edgesOf
(
    const filledSurface::tetrahedron& t,
    const pointField& x
)
{
    Eigen::Matrix3d result;
    for (label k = 0; k < 3; ++k)
    {
        const vector d(x[t[k + 1]] - x[t[0]]);
        result.col(k) = toEigen(d);
    }
    return result;
}


Foam::membraneModels::neoHookeanSolid::response
Foam::membraneModels::neoHookeanSolid::ofVolume(const scalar J) const
{
    // The logarithm, and its derivatives
    const scalar a = max(J, leastJ);
    const scalar d = (J - a)/a;
    const scalar L = Foam::log(a) + d - 0.5*sqr(d);
    const scalar L1 = (1 - d)/a;
    const scalar L2 = -1/sqr(a);

    const scalar slope = lambda_*L - shearModulus_;
    return
    {
        0.5*lambda_*sqr(L) - shearModulus_*L,
        slope*L1,
        lambda_*sqr(L1) + slope*L2
    };
}


void Foam::membraneModels::neoHookeanSolid::addNeighbours(labelListList& around) const
{
    for (const auto& t : inside_.tetrahedra())
    {
        for (const label i : t)
        {
            for (const label j : t)
            {
                around[i].append(j);
            }
        }
    }
}


Foam::scalar Foam::membraneModels::neoHookeanSolid::add
(
    const pointField& x,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    const Eigen::Matrix3d one(Eigen::Matrix3d::Identity());
    scalar energy = 0;
    forAll(inside_.tetrahedra(), n)
    {
        const filledSurface::tetrahedron& t = inside_.tetrahedra()[n];
        const rest& r = rest_[n];
        const Eigen::Matrix3d d(edgesOf(t, x));
        const Eigen::Matrix3d F(d*r.inverse);
        const scalar J = F.determinant();
        const response w(ofVolume(J));
        energy +=
            r.volume*(0.5*shearModulus_*(F.squaredNorm() - 3) + w.W);

        // Derivatives of J by the edges
        const scalar perVolume = r.inverse.determinant();
        Eigen::Matrix3d g;
        g.col(0) = perVolume*d.col(1).cross(d.col(2));
        g.col(1) = perVolume*d.col(2).cross(d.col(0));
        g.col(2) = perVolume*d.col(0).cross(d.col(1));

        const Eigen::Matrix3d forces
        (
            r.volume*(shearModulus_*F*r.inverse.transpose() + w.W1*g)
        );
        for (label k = 0; k < 3; ++k)
        {
            const vector f(forces(0, k), forces(1, k), forces(2, k));
            gradient[t[k + 1]] += f;
            gradient[t[0]] -= f;
        }
        if (!tangent)
        {
            continue;
        }

        const Eigen::Matrix3d metric(r.inverse*r.inverse.transpose());
        matrix9 H;
        for (label k = 0; k < 3; ++k)
        {
            for (label l = 0; l < 3; ++l)
            {
                H.block<3, 3>(3*k, 3*l) =
                    shearModulus_*metric(k, l)*one
                  + w.W2*g.col(k)*g.col(l).transpose();
            }
        }
        for (label k = 0; k < 3; ++k)
        {
            const label l = (k + 1) % 3;
            const Eigen::Matrix3d C(w.W1*perVolume*crossMatrix(d.col((k + 2) % 3)));
            H.block<3, 3>(3*k, 3*l) -= C;
            H.block<3, 3>(3*l, 3*k) += C;
        }
        H *= r.volume;
        if (!tangent->exact())
        {
            const Eigen::MatrixXd dense(H);
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(dense);
            Eigen::VectorXd values(eigen.eigenvalues());
            for (label k = 0; k < 9; ++k)
            {
                values[k] = tangent->kept(values[k]);
            }
            H =
                eigen.eigenvectors()*values.asDiagonal()
               *eigen.eigenvectors().transpose();
        }

        // The edges are the differences of the other nodes from the first one
        matrix12 full;
        full.block<9, 9>(3, 3) = H;
        full.block<9, 3>(3, 0) =
            -H.leftCols<3>() - H.middleCols<3>(3) - H.rightCols<3>();
        full.block<3, 9>(0, 3) = full.block<9, 3>(3, 0).transpose();
        full.block<3, 3>(0, 0) =
            -full.block<3, 3>(0, 3) - full.block<3, 3>(0, 6) - full.block<3, 3>(0, 9);
        tangent->addDense(t, 4, full);
    }
    return energy;
}
