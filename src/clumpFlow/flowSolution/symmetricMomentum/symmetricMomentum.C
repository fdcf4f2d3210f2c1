/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "symmetricMomentum.H"
#include "fvMesh.H"
#include "symmetryPlanes.H"
#include "turnedMomentum.H"

Foam::symmetricMomentum::symmetricMomentum(const fvVectorMatrix& UEqn)
:
    UEqn_(UEqn)
{
    const fvMesh& mesh = UEqn.psi().mesh();
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (!symmetryPlanes::isOne(patch.patch()))
        {
            continue;
        }

        // Also where this processor has no face of it: the functions are collective
        missing_.setSize(mesh.nCells(), Zero);
        given_.setSize(mesh.nCells(), Zero);
        const vectorField n(patch.nf());
        forAll(n, i)
        {
            // OpenFOAM's coefficients of a patch of this kind are 2 g |n_x| etc.
            const vector& v = UEqn.internalCoeffs()[patchi][i];
            const scalar g = 0.5*cmptSum(v)/cmptSum(cmptMag(n[i]));
            const label celli = patch.faceCells()[i];
            missing_[celli] += g - cmptAv(v);
            given_[celli] += cmptAv(v);
        }
    }
}


Foam::tmp<Foam::volScalarField> Foam::symmetricMomentum::A() const
{
    tmp<volScalarField> tA(UEqn_.A());
    if (missing_.size())
    {
        tA.ref().primitiveFieldRef() += missing_/UEqn_.psi().mesh().V();
        tA.ref().correctBoundaryConditions();
    }
    return tA;
}


Foam::tmp<Foam::volVectorField> Foam::symmetricMomentum::H
(
    const volVectorField& U
) const
{
    tmp<volVectorField> tH(UEqn_.H());
    if (missing_.size())
    {
        tH.ref().primitiveFieldRef() +=
            missing_/U.mesh().V()*U.primitiveField();
        forAll(U.mesh().boundary(), patchi)
        {
            const fvPatch& patch = U.mesh().boundary()[patchi];
            if (!turnedMomentum::isOblique(patch))
            {
                continue;
            }
            const vectorField change(turnedMomentum::change(UEqn_, patchi, U));
            forAll(change, i)
            {
                const label celli = patch.faceCells()[i];
                tH.ref()[celli] += change[i]/U.mesh().V()[celli];
            }
        }
        tH.ref().correctBoundaryConditions();
    }
    return tH;
}


Foam::tmp<Foam::volScalarField> Foam::symmetricMomentum::H1() const
{
    tmp<volScalarField> tH1(UEqn_.H1());
    if (missing_.size())
    {
        tH1.ref().primitiveFieldRef() +=
            (missing_ + given_)/UEqn_.psi().mesh().V();
        tH1.ref().correctBoundaryConditions();
    }
    return tH1;
}
