/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "carriedPressure.H"
#include "fvcDiv.H"
#include "fvcFlux.H"
#include "fvcLaplacian.H"
#include "fvcSnGrad.H"
#include "fvcSurfaceIntegrate.H"
#include "fvmLaplacian.H"
#include "fvMatrices.H"
#include "surfaceInterpolate.H"

Foam::carriedPressure::carriedPressure
(
    volScalarField& p,
    const label refCell
)
:
    p_(p),
    refCell_(refCell)
{}


Foam::tmp<Foam::volScalarField> Foam::carriedPressure::zero
(
    const word& name,
    const dimensionSet& dimensions,
    const word& fixed
) const
{
    const auto& patches = p_.boundaryField();
    wordList types(patches.size(), "zeroGradient");
    forAll(patches, i)
    {
        if (patches[i].coupled())
        {
            types[i] = patches[i].type();
        }
        else if (patches[i].fixesValue())
        {
            types[i] = fixed;
        }
    }
    return tmp<volScalarField>::New
    (
        IOobject(name, p_.time().timeName(), p_.mesh()),
        p_.mesh(),
        dimensionedScalar(dimensions, Zero),
        types
    );
}


void Foam::carriedPressure::carry
(
    const volVectorField& d,
    volScalarField& q
) const
{
    const fvMesh& mesh = q.mesh();
    surfaceScalarField dS(fvc::flux(d));
    forAll(dS.boundaryField(), i)
    {
        if (!dS.boundaryField()[i].coupled())
        {
            dS.boundaryFieldRef()[i] = Zero;
        }
    }
    const surfaceScalarField courant(mag(dS)*mesh.deltaCoeffs()/mesh.magSf());
    const scalar most =
        0.5*gMax(fvc::surfaceSum(courant)().primitiveField());
    const label n = max(label(1), label(std::ceil(most/0.7)));
    dS /= scalar(n);

    for (label part = 0; part < n; ++part)
    {
        q -= fvc::div
        (
            dS*fvc::interpolate(q)
          - 0.5*sqr(dS)/mesh.magSf()*fvc::snGrad(q)
        );
        q.correctBoundaryConditions();
    }
}


void Foam::carriedPressure::correct
(
    const volVectorField& d,
    const dictionary& solver
)
{
    const dimensionSet dimensions(p_.dimensions()/dimArea);
    tmp<volScalarField> tq(zero("q", dimensions));
    volScalarField& q = tq.ref();
    q.primitiveFieldRef() = fvc::laplacian(p_)().primitiveField();
    q.correctBoundaryConditions();

    const volScalarField before("qBefore", q);
    carry(d, q);

    tmp<volScalarField> tdp(zero("dp", p_.dimensions(), "fixedValue"));
    fvScalarMatrix equation(fvm::laplacian(tdp.ref()) == q - before);
    if (p_.needReference())
    {
        equation.setReference(refCell_, 0);
    }
    equation.solve(solver);

    p_ += tdp;
    p_.correctBoundaryConditions();
}
