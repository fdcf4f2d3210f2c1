/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallMobility.H"
#include "fixedValueFvPatchFields.H"
#include "fvMatrices.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"

Foam::wallMobility::wallMobility(const volVectorField& U)
:
    U_(U),
    deltaT_(0),
    nu_(0)
{}


void Foam::wallMobility::update(const volScalarField& nu)
{
    const fvMesh& mesh = U_.mesh();
    const auto& patches = U_.boundaryField();
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
    volScalarField m
    (
        IOobject("wallMobility", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimTime, Zero),
        types
    );
    const dimensionedScalar rate("rate", dimless/dimTime, 1/deltaT_);

    // So small that the result is the same on any number of processors
    dictionary solver;
    solver.set("solver", "PCG");
    solver.set("preconditioner", "DIC");
    solver.set("tolerance", scalar(1e-12));
    solver.set("relTol", scalar(0));

    fvScalarMatrix equation
    (
        fvm::Sp(rate, m) - fvm::laplacian(nu, m)
     == dimensionedScalar("one", dimless, 1)
    );
    equation.solve(solver);

    // A - H1 without clumps: 1/dt and what the walls hold back
    scalarField alone(mesh.nCells(), rate.value());
    forAll(patches, i)
    {
        if (patches[i].coupled())
        {
            continue;
        }
        const labelUList& cells = patches[i].patch().faceCells();
        forAll(cells, facei)
        {
            alone[cells[facei]] +=
                equation.internalCoeffs()[i][facei]/mesh.V()[cells[facei]];
        }
    }

    // No mesh cell moves less than it does on its own
    resistance_.reset
    (
        new volScalarField
        (
            IOobject("wallResistance", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(dimless/dimTime, Zero),
            "zeroGradient"
        )
    );
    resistance_->primitiveFieldRef() =
        1/max(m.primitiveField(), 1/equation.A()().primitiveField()) - alone;
    resistance_->correctBoundaryConditions();
}


const Foam::volScalarField& Foam::wallMobility::resistance
(
    const volScalarField& nu
)
{
    const scalar dt = nu.mesh().time().deltaTValue();
    const scalar mean = nu.weightedAverage(nu.mesh().V()).value();
    if
    (
        !resistance_.valid()
     || mag(dt - deltaT_) > 0.1*deltaT_
     || mag(mean - nu_) > 0.1*nu_
    )
    {
        deltaT_ = dt;
        nu_ = mean;
        update(nu);
    }
    return resistance_();
}
