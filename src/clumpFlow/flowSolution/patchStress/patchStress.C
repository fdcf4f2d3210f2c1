/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "patchStress.H"
#include "volFields.H"

namespace Foam
{
    defineTypeNameAndDebug(patchStress, 0);
}


Foam::patchStress::patchStress(const fvMesh& mesh)
:
    regIOobject
    (
        IOobject(typeName, mesh.time().timeName(), mesh)
    ),
    rest_(Zero)
{}


void Foam::patchStress::set
(
    const surfaceScalarField& nu,
    const surfaceVectorField& rest
)
{
    set(nu, sumOnPatches(rest));
}


void Foam::patchStress::set(const surfaceScalarField& nu, const vector& rest)
{
    nu_.setSize(nu.boundaryField().size());
    forAll(nu_, patchi)
    {
        nu_[patchi] = nu.boundaryField()[patchi];
    }
    rest_ = rest;
}


Foam::vector Foam::patchStress::sumOnPatches(const surfaceVectorField& onFaces)
{
    vector result(Zero);
    for (const fvsPatchVectorField& onPatch : onFaces.boundaryField())
    {
        if (!onPatch.coupled())
        {
            result += sum(onPatch);
        }
    }
    return result;
}


Foam::tmp<Foam::vectorField> Foam::patchStress::implicitPart
(
    const fvPatchVectorField& U
) const
{
    return nu_[U.patch().index()]*U.patch().magSf()*U.snGrad();
}


Foam::vector Foam::patchStress::explicitPart() const
{
    return returnReduce(rest_, sumOp<vector>());
}
