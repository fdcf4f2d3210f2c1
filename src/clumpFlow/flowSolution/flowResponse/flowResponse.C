/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "flowResponse.H"
#include "basicSymmetryFvPatchFields.H"
#include "constrainHbyA.H"
#include "fvcDiv.H"
#include "fvcFlux.H"
#include "fvcGrad.H"
#include "fvmLaplacian.H"
#include "incompressibleFlow.H"
#include "rotationalCorrection.H"

namespace
{

using namespace Foam;

IOobject unregistered(const word& name, const fvMesh& mesh)
{
    return IOobject
    (
        name, mesh.time().timeName(), mesh,
        IOobject::NO_READ, IOobject::NO_WRITE, false
    );
}


//- Conditions of the change of a field: zero where the field is fixed
template<class Type>
wordList conditions(const GeometricField<Type, fvPatchField, volMesh>& field)
{
    wordList result(field.boundaryField().size(), "zeroGradient");
    forAll(result, patchi)
    {
        const fvPatchField<Type>& pf = field.boundaryField()[patchi];
        if (pf.coupled() || polyPatch::constraintType(pf.patch().type()))
        {
            result[patchi] = pf.patch().type();
        }
        else if (isA<basicSymmetryFvPatchField<Type>>(pf))
        {
            result[patchi] = pf.type();
        }
        else if (pf.fixesValue() && !pf.assignable())
        {
            result[patchi] = "fixedValue";
        }
    }
    return result;
}

}


Foam::flowResponse::flowResponse
(
    const fvVectorMatrix& UEqn,
    const volScalarField& rAU,
    const volScalarField& rAtU,
    incompressibleFlow& flow,
    const vector& d,
    const labelList& cells
)
:
    U_
    (
        unregistered("responseU", rAU.mesh()), rAU.mesh(),
        dimensionedVector(dimTime, Zero), conditions(flow.U())
    ),
    phi_
    (
        unregistered("responsePhi", rAU.mesh()), rAU.mesh(),
        dimensionedScalar(dimTime*dimArea, Zero)
    ),
    p_
    (
        unregistered("responseP", rAU.mesh()), rAU.mesh(),
        dimensionedScalar(dimLength, Zero), conditions(flow.p())
    )
{
    const fvMesh& mesh = rAU.mesh();
    mesh.setFluxRequired(p_.name());
    const tmp<fvVectorMatrix> tEqn(equation(UEqn, d, cells));
    tmp<fvVectorMatrix>(new fvVectorMatrix(tEqn()))->solve
    (
        mesh.solverDict(flow.U().select(false))
    );

    // As in pEqn.H of rbcIbFoam, from a pressure of zero and with the schemes of p
    const volVectorField HbyA(constrainHbyA(rAU*tEqn().H(), U_, p_));
    const surfaceScalarField phiHbyA(fvc::flux(HbyA));
    const volScalarField excess(fvc::div(phiHbyA));

    const word& p = flow.p().name();
    fvScalarMatrix pEqn
    (
        fvm::laplacian(rAtU, p_, "laplacian(" + rAtU.name() + ',' + p + ')')
     == excess
    );
    pEqn.setReference(flow.pRefCell(), 0);
    pEqn.solve(mesh.solverDict(flow.p().select(false)));

    phi_ = phiHbyA - pEqn.flux();
    U_ = HbyA - rAtU*fvc::grad(p_, "grad(" + p + ')');
    U_.correctBoundaryConditions();
    if (flow.control().consistent())
    {
        p_ -=
            rotationalCorrection::coefficient
            (
                flow.viscosity(), rAU, flow.U(), flow.p()
            )*excess;
        p_.correctBoundaryConditions();
    }
}


Foam::tmp<Foam::fvVectorMatrix> Foam::flowResponse::equation
(
    const fvVectorMatrix& UEqn,
    const vector& d,
    const labelList& cells
)
{
    tmp<fvVectorMatrix> result(new fvVectorMatrix(U_, dimVolume));
    fvVectorMatrix& eqn = result.ref();
    eqn.lduMatrix::operator=(UEqn);
    eqn.internalCoeffs() = UEqn.internalCoeffs();
    forAll(eqn.boundaryCoeffs(), patchi)
    {
        if (U_.boundaryField()[patchi].coupled())
        {
            eqn.boundaryCoeffs()[patchi] = UEqn.boundaryCoeffs()[patchi];
        }
    }
    for (const label celli : cells)
    {
        eqn.source()[celli] = U_.mesh().V()[celli]*d;
    }
    return result;
}


void Foam::flowResponse::addTo
(
    incompressibleFlow& flow,
    const scalar force
) const
{
    const dimensionedScalar f("force", dimAcceleration, force);
    flow.U() += f*U_;
    flow.U().correctBoundaryConditions();
    flow.phi() += f*phi_;
    flow.p() += f*p_;
    flow.p().correctBoundaryConditions();
}


Foam::vector Foam::flowResponse::mean() const
{
    const scalarField& V = U_.mesh().V();
    return gSum(V*U_.primitiveField())/gSum(V);
}
