/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondCases.H"
#include "bondForces.H"

using namespace Foam;

namespace
{

//- Natural angular frequencies at rest, ascending, with their modes in columns,
//  and how much of a mode is motion out of the x-y plane
void modes
(
    const dictionary& dict,
    scalarField& omega,
    scalarField& outOfPlane
)
{
    const bondedClump clump("line", dict);
    const clumpType& type = clump.type;
    const clumpState s(type);
    const label n = 6*type.size();
    vectorField F(type.size()), T(type.size());
    clumpTangent K(clump.bonds.pattern());
    K.setZero();
    bondForces(clump.bonds, s).stepForces(s, 0, F, T, &K);

    Eigen::VectorXd scale(n);
    for (label i = 0; i < type.size(); ++i)
    {
        scale.segment<3>(6*i).setConstant(1/Foam::sqrt(type.masses()[i]));
        scale.segment<3>(6*i + 3).setConstant
        (
            1/Foam::sqrt(type.inertias()[i])
        );
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver
    (
        scale.asDiagonal()*K.dense()*scale.asDiagonal()
    );

    omega.setSize(n);
    outOfPlane.setSize(n);
    for (label k = 0; k < n; ++k)
    {
        omega[k] = Foam::sqrt(max(solver.eigenvalues()[k], 0.0));
        outOfPlane[k] = 0;
        for (label i = 0; i < type.size(); ++i)
        {
            const auto v = solver.eigenvectors().col(k);
            outOfPlane[k] +=
                sqr(v[6*i + 2]) + sqr(v[6*i + 3]) + sqr(v[6*i + 4]);
        }
    }
}


//- The frequencies that are no rigid motion (all others here are above 1), in or
//  out of the plane
DynamicList<scalar> firstOf
(
    const scalarField& omega,
    const scalarField& outOfPlane,
    const bool out
)
{
    DynamicList<scalar> result;
    forAll(omega, k)
    {
        if ((outOfPlane[k] > 0.5) == out && omega[k] > 0.1)
        {
            result.append(omega[k]);
        }
    }
    return result;
}

}


void Foam::frequencies()
{
    scalarField omega, out;

    for (const label n : {8, 16, 32, 64})
    {
        // A ring of radius 1 with mass 1 per length; thin spheres
        lineProperties l;
        l.EA = l.GA = 1e4;
        l.GJ = 0.7;
        l.bond = "timoshenko";
        l.radius = 1e-3;
        l.density = 6.283185307179586/n/(4.18879020478639*pow3(l.radius));
        modes(ringOf(n, 1, l), omega, out);
        const auto in(firstOf(omega, out, false));
        const auto across(firstOf(omega, out, true));
        print("ring in plane", 2, n, in[0]);
        print("ring in plane", 3, n, in[2]);
        print("ring out of plane", 2, n, across[0]);

        // Every sphere stands for a piece of the chain: length 1 is n pieces
        l.density = 1.0/n/(4.18879020478639*pow3(l.radius));
        modes(chainOf(n, 1 - 1.0/n, l), omega, out);
        print("free beam bending", 1, n, firstOf(omega, out, false)[0]);
    }
}
