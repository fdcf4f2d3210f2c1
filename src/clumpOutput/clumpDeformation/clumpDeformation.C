/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpDeformation.H"
#include "symmTensor.H"
#include <Eigen/Dense>

Foam::scalar Foam::functionObjects::clumpDeformation::index
(
    const clumpType& type,
    const pointField& x
)
{
    symmTensor M(Zero);
    if (type.hasTriangles())
    {
        M = type.surface().secondMoments(x);
    }
    else
    {
        const scalarField& V = type.volumes();
        point centre(Zero);
        forAll(x, i)
        {
            centre += V[i]*x[i]/sum(V);
        }
        forAll(x, i)
        {
            M += V[i]*(sqr(x[i] - centre) + 0.2*sqr(type.radii()[i])*symmTensor::I);
        }
    }

    Eigen::Matrix3d moments;
    moments <<
        M.xx(), M.xy(), M.xz(),
        M.xy(), M.yy(), M.yz(),
        M.xz(), M.yz(), M.zz();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver
    (
        moments/max(moments.trace(), VSMALL), Eigen::EigenvaluesOnly
    );
    const scalar a1 = Foam::sqrt(max(solver.eigenvalues()[2], scalar(0)));
    const scalar a2 = Foam::sqrt(max(solver.eigenvalues()[1], scalar(0)));
    return (a1 - a2)/max(a1 + a2, VSMALL);
}


Foam::scalarField Foam::functionObjects::clumpDeformation::arealStrains
(
    const clumpType& type,
    const pointField& x
)
{
    if (!type.hasTriangles())
    {
        return scalarField(x.size(), Zero);
    }
    const scalarField rest(type.surface().nodeAreas(type.centres()));

    // Nodes inside have no area
    return
        (type.surface().nodeAreas(x) - rest)/max(rest, VSMALL);
}
