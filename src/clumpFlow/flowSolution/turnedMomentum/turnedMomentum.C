/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "turnedMomentum.H"
#include "coupledPatches.H"
#include "fvMatrices.H"
#include "symmetryPlanes.H"
#include "volFields.H"

namespace
{

using namespace Foam;

//- Deviation from an axis that is rounding
constexpr scalar small = 1e-9;

//- Coefficient g of a face of a plane, from those of the components [m3/s]
scalar conductance(const vector& v, const vector& n)
{
    return cmptSum(v)/cmptSum(cmptMag(n));
}


//- From the axes to coordinates with the normals of all planes as axes; one: no plane is
//  oblique (collective)
tensor toNormals(const fvMesh& mesh)
{
    const symmetryPlanes planes(mesh.boundaryMesh());
    bool oblique = false;
    DynamicList<vector> axes;
    for (const symmetryPlanes::plane& plane : planes.planes())
    {
        oblique = oblique || cmptMax(cmptMag(plane.n)) < 1 - small;
        bool fresh = true;
        for (const vector& other : axes)
        {
            fresh = fresh && mag(other & plane.n) < 0.5;
        }
        if (fresh)
        {
            axes.append(plane.n);
        }
    }
    if (!oblique)
    {
        return I;
    }
    if (axes.size() == 1)
    {
        const vector& n = axes[0];
        const vector aside(mag(n.x()) < 0.7 ? vector(1, 0, 0) : vector(0, 1, 0));
        axes.append(normalised(n ^ aside));
    }
    const vector n(axes[0]);
    const vector second(normalised(axes[1] - (n & axes[1])*n));
    return tensor(n, second, n ^ second);
}


//- Whether the coefficients of the components differ at no patch but the planes
//  (collective)
bool canTurn(const fvVectorMatrix& UEqn)
{
    const fvMesh& mesh = UEqn.psi().mesh();
    bool result = true;
    forAll(mesh.boundary(), patchi)
    {
        if (symmetryPlanes::isOne(mesh.boundary()[patchi].patch()))
        {
            continue;
        }
        for (const vector& v : UEqn.internalCoeffs()[patchi])
        {
            result = result && cmptMax(v) - cmptMin(v) <= small*cmptMax(cmptMag(v));
        }
    }
    return returnReduce(result, andOp<bool>());
}

}


bool Foam::turnedMomentum::isOblique(const fvPatch& patch)
{
    return
        symmetryPlanes::isOne(patch.patch()) && patch.size()
     && cmptMax(cmptMag(patch.nf()()[0])) < 1 - small;
}


Foam::vectorField Foam::turnedMomentum::change
(
    const fvVectorMatrix& UEqn,
    const label patchi,
    const volVectorField& U
)
{
    const fvPatch& patch = U.mesh().boundary()[patchi];
    const vectorField& v = UEqn.internalCoeffs()[patchi];
    vectorField result(-UEqn.boundaryCoeffs()[patchi]);
    const vectorField n(patch.nf());
    forAll(n, i)
    {
        const vector& u = U[patch.faceCells()[i]];
        result[i] += cmptMultiply(v[i], u) - conductance(v[i], n[i])*(n[i] & u)*n[i];
    }
    return result;
}


void Foam::turnedMomentum::solve
(
    fvVectorMatrix& UEqn,
    const volVectorField& gradp,
    const dictionary& controls
)
{
    volVectorField& U = const_cast<volVectorField&>(UEqn.psi());
    const fvMesh& mesh = U.mesh();
    const tensor turn(toNormals(mesh));
    if (turn == tensor(I) || !canTurn(UEqn))
    {
        Foam::solve(UEqn == -gradp, controls);
        return;
    }
    fvVectorMatrix turned(UEqn == -gradp);
    turned.source() = turn & turned.source();
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        vectorField& internal = turned.internalCoeffs()[patchi];
        vectorField& boundary = turned.boundaryCoeffs()[patchi];
        if (symmetryPlanes::isOne(patch.patch()))
        {
            const vectorField n(patch.nf());
            forAll(n, i)
            {
                internal[i] = conductance(internal[i], n[i])*cmptMag(turn & n[i]);
            }
            boundary = Zero;
        }
        else if (!patch.coupled())
        {
            boundary = turn & boundary;
        }
    }

    U.primitiveFieldRef() = turn & U.primitiveField();
    evaluateCoupled(U.boundaryFieldRef());
    turned.solve(controls);
    U.primitiveFieldRef() = turn.T() & U.primitiveField();
    U.correctBoundaryConditions();

    forAll(mesh.boundary(), patchi)
    {
        if (isOblique(mesh.boundary()[patchi]))
        {
            UEqn.boundaryCoeffs()[patchi] += change(UEqn, patchi, U);
        }
    }
}
