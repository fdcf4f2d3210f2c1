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
    written_(-1)
{}


void Foam::wallMobility::solve(const volScalarField& nu)
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
    mobility_.reset
    (
        new volScalarField
        (
            IOobject("wallMobility", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(dimTime, Zero),
            types
        )
    );
    volScalarField& m = mobility_();
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

    // No mesh cell moves less than it does on its own
    m.primitiveFieldRef() =
        max(m.primitiveField(), 1/equation.A()().primitiveField());
}


Foam::scalar Foam::wallMobility::roundedStep(const volScalarField& nu)
{
    const Time& time = nu.time();
    const scalar dt = time.deltaTValue();
    if (!time.controlDict().getOrDefault("adjustTimeStep", false))
    {
        return dt;
    }
    // Of a number without a unit, the same in any units
    const scalar L = Foam::cbrt(gSum(nu.mesh().V()));
    const scalar x = Foam::log(dt*gMax(nu.primitiveField())/sqr(L));
    return dt*Foam::exp(0.05*std::round(x/0.05) - x);
}


Foam::tmp<Foam::volScalarField> Foam::wallMobility::resistance
(
    const volScalarField& nu
)
{
    const fvMesh& mesh = nu.mesh();
    const Time& time = mesh.time();
    const scalarField& V = mesh.V();
    const scalar rounded = roundedStep(nu);
    if
    (
        !mobility_.valid() || rounded != deltaT_
     || (written_ >= 0 && written_ != time.timeIndex())
     || gSum(V*mag(nu.primitiveField() - nu_)) > 0.1*gSum(V*nu_)
    )
    {
        deltaT_ = rounded;
        nu_ = nu.primitiveField();
        solve(nu);
        written_ = -1;
    }
    if (time.writeTime())
    {
        written_ = time.timeIndex();
    }

    tmp<volScalarField> tresistance
    (
        new volScalarField
        (
            IOobject("wallResistance", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(dimless/dimTime, Zero),
            "zeroGradient"
        )
    );
    volScalarField& resistance = tresistance.ref();
    scalarField& r = resistance.primitiveFieldRef();
    r = 1/mobility_->primitiveField() - 1/deltaT_;

    // What the walls hold back in the momentum equation
    for (const fvPatchScalarField& m : mobility_->boundaryField())
    {
        if (m.coupled())
        {
            continue;
        }
        const fvPatch& patch = m.patch();
        const scalarField friction
        (
          - nu.boundaryField()[patch.index()]*patch.magSf()
           *m.gradientInternalCoeffs()
        );
        const labelUList& cells = patch.faceCells();
        forAll(cells, facei)
        {
            r[cells[facei]] -= friction[facei]/V[cells[facei]];
        }
    }
    resistance.correctBoundaryConditions();
    return tresistance;
}
