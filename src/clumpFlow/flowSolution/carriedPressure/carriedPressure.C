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
#include "orthogonalSnGrad.H"
#include "surfaceInterpolate.H"

Foam::carriedPressure::carriedPressure
(
    volScalarField& p,
    const label refCell
)
:
    p_(p),
    refCell_(refCell),
    orthogonal_(false)
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
            // Not the condition of p, which may have a jump
            types[i] = patches[i].patch().type();
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


void Foam::carriedPressure::findLevels()
{
    const fvMesh& mesh = p_.mesh();
    tmp<volScalarField> tlogV(zero("logV", dimless));
    volScalarField& logV = tlogV.ref();
    logV.primitiveFieldRef() = Foam::log(mesh.V().field());
    logV.correctBoundaryConditions();

    // Two levels differ by a factor of eight, or four in two dimensions
    const surfaceScalarField change
    (
        mag(fv::orthogonalSnGrad<scalar>(mesh).snGrad(logV))
       /mesh.nonOrthDeltaCoeffs()
    );
    tmp<volScalarField> tbeside(zero("beside", dimless));
    volScalarField& beside = tbeside.ref();
    beside.primitiveFieldRef() =
        fvc::surfaceSum(pos(change - Foam::log(scalar(3))))()
       .primitiveField();
    beside.correctBoundaryConditions();

    sameLevel_.reset
    (
        // Not registered: OpenFOAM would map it when the mesh refines
        new surfaceScalarField
        (
            IOobject
            (
                "sameLevel", mesh.time().timeName(), mesh,
                IOobject::NO_READ, IOobject::NO_WRITE, false
            ),
            neg0(fvc::interpolate(beside))
        )
    );
    orthogonal_ =
        gMax(magSqr(mesh.nonOrthCorrectionVectors().primitiveField())) < 1e-6;
}


void Foam::carriedPressure::carrySources
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
    dS *= sameLevel_();

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


void Foam::carriedPressure::carry
(
    const volVectorField& d,
    const dictionary& solver
)
{
    if (!sameLevel_.valid())
    {
        findLevels();
    }
    const dimensionSet dimensions(p_.dimensions()/dimArea);
    tmp<volScalarField> tq(zero("q", dimensions));
    volScalarField& q = tq.ref();
    q.primitiveFieldRef() = fvc::laplacian(p_)().primitiveField();
    q.correctBoundaryConditions();

    const volScalarField before("qBefore", q);
    carrySources(d, q);

    tmp<volScalarField> tchange(zero("dp", p_.dimensions(), "fixedValue"));
    volScalarField& change = tchange.ref();
    // The second solution has the non-orthogonal part of the gradient
    const label nSolutions = orthogonal_ ? 1 : 2;
    for (label i = 0; i < nSolutions; ++i)
    {
        fvScalarMatrix equation(fvm::laplacian(change) == q - before);
        if (p_.needReference())
        {
            equation.setReference(refCell_, 0);
        }
        equation.solve(solver);
    }
    p_.primitiveFieldRef() += change.primitiveField();
    p_.correctBoundaryConditions();
}
