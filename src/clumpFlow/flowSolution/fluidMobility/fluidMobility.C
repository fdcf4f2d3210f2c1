/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fluidMobility.H"
#include "fixedValueFvPatchFields.H"
#include "fvMatrices.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"

namespace
{

using namespace Foam;

bool differs(const scalarField& a, const scalarField& b, const scalar part)
{
    if (a.size() != b.size())
    {
        return true;
    }
    forAll(a, i)
    {
        if (mag(a[i] - b[i]) > part*mag(b[i]))
        {
            return true;
        }
    }
    return false;
}

}


Foam::fluidMobility::fluidMobility(const volVectorField& U)
:
    m_(zero(U).ptr()),
    timeIndex_(-1)
{}


void Foam::fluidMobility::meshChanged(const volVectorField& U)
{
    m_.reset(zero(U).ptr());
    timeIndex_ = -1;
}


Foam::tmp<Foam::volScalarField> Foam::fluidMobility::zero
(
    const volVectorField& U
)
{
    const auto& patches = U.boundaryField();
    wordList types(patches.size(), "zeroGradient");
    forAll(patches, i)
    {
        if (patches[i].coupled())
        {
            types[i] = patches[i].type();
        }
        else if (isA<fixedValueFvPatchVectorField>(patches[i]))
        {
            types[i] = "fixedValue";
        }
    }
    const fvMesh& mesh = U.mesh();
    return tmp<volScalarField>::New
    (
        // Not registered: OpenFOAM would map it when the mesh refines
        IOobject
        (
            "mobility", mesh.time().timeName(), mesh,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        mesh, dimensionedScalar(dimTime, Zero), types
    );
}


void Foam::fluidMobility::solve
(
    const volScalarField& A,
    const volScalarField& nu
)
{
    volScalarField& m = m_();
    const scalarField& V = m.mesh().V();
    volScalarField::Internal a(A.internalField());
    for (const fvPatchScalarField& pm : m.boundaryField())
    {
        if (!pm.coupled())
        {
            const fvPatch& patch = pm.patch();
            const scalarField friction
            (
              - nu.boundaryField()[patch.index()]*patch.magSf()
               *pm.gradientInternalCoeffs()
            );
            const labelUList& cells = patch.faceCells();
            forAll(cells, facei)
            {
                a[cells[facei]] -= friction[facei]/V[cells[facei]];
            }
        }
    }

    // What is left beside a wall has the rounding of the friction
    a.field() = max(a.field(), 1e-10*A.primitiveField());

    // From zero, so that it does not depend on earlier steps, and so far that it does
    // not on the number of processors
    dictionary solver;
    solver.set("solver", "PCG");
    solver.set("preconditioner", "DIC");
    solver.set("tolerance", scalar(1e-8));
    solver.set("relTol", scalar(0));

    m == dimensionedScalar(dimTime, Zero);
    fvScalarMatrix equation
    (
        fvm::Sp(a, m)
      - fvm::laplacian(nu, m, "laplacian(nuEff,U)")
     == dimensionedScalar("one", dimless, 1)
    );
    equation.solve(solver);

    // No mesh cell moves less than it does on its own
    m.primitiveFieldRef() =
        max(m.primitiveField(), 1/equation.A()().primitiveField());
    m.correctBoundaryConditions();
}


const Foam::volScalarField& Foam::fluidMobility::value
(
    const volScalarField& A,
    const volScalarField& nu
)
{
    const label now = nu.time().timeIndex();
    const scalar part = timeIndex_ == now ? 0.1 : 0;
    const bool changed =
        timeIndex_ < 0 || differs(A, A_, part) || differs(nu, nu_, part);
    if (returnReduce(changed, orOp<bool>()))
    {
        A_ = A.primitiveField();
        nu_ = nu.primitiveField();
        solve(A, nu);
    }
    timeIndex_ = now;
    return m_();
}
