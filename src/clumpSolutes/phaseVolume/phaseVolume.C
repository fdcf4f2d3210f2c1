/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "phaseVolume.H"
#include "fvcSurfaceIntegrate.H"
#include "fvMatrices.H"
#include "fvmSup.H"
#include "gaussLaplacianScheme.H"
#include "linear.H"
#include "StringStream.H"
#include "zeroGradientFvPatchFields.H"
#include "fixedValueFvPatchFields.H"

namespace
{

//- A smaller part of a mesh cell is left alone
constexpr Foam::scalar least = 1e-6;

}


Foam::phaseVolume::phaseVolume(const fvMesh& mesh, const word& name)
:
    mesh_(mesh),
    volume_
    (
        IOobject
        (
            name, mesh.time().timeName(), mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE
        ),
        mesh,
        dimensionedScalar("none", dimless, -1),
        zeroGradientFvPatchScalarField::typeName
    ),
    active_(mesh.nCells(), false)
{}


void Foam::phaseVolume::start(const scalarField& alpha)
{
    if (gMin(volume_.primitiveField()) <= -1)
    {
        volume_.primitiveFieldRef() = alpha;
        volume_.correctBoundaryConditions();
    }
}


Foam::wordList Foam::phaseVolume::patchTypes() const
{
    const auto& U = mesh_.lookupObject<volVectorField>("U");
    wordList types
    (
        mesh_.boundary().size(), zeroGradientFvPatchScalarField::typeName
    );
    forAll(types, patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (patch.coupled())
        {
            types[patchi] = patch.type();
        }
        else if
        (
            !polyPatch::constraintType(patch.type())
         && !U.boundaryField()[patchi].fixesValue()
        )
        {
            types[patchi] = fixedValueFvPatchScalarField::typeName;
        }
    }
    return types;
}


Foam::tmp<Foam::surfaceScalarField> Foam::phaseVolume::between() const
{
    volScalarField inactive
    (
        IOobject
        (
            "inactive", mesh_.time().timeName(), mesh_,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        mesh_,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    forAll(inactive, celli)
    {
        inactive[celli] = !active_[celli];
    }
    inactive.correctBoundaryConditions();
    return neg(linearInterpolate(inactive) - 1e-9);
}


Foam::tmp<Foam::volScalarField> Foam::phaseVolume::correct
(
    const scalarField& alpha,
    const surfaceScalarField& flux
)
{
    const dimensionedScalar dt("dt", dimTime, mesh_.time().deltaTValue());
    volScalarField present
    (
        IOobject
        (
            "present", mesh_.time().timeName(), mesh_,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        mesh_,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    active_.setSize(mesh_.nCells());
    forAll(active_, celli)
    {
        active_[celli] = volume_[celli] > least || alpha[celli] > 0;
        if (active_[celli])
        {
            present[celli] = max(alpha[celli], volume_[celli]);
        }
    }
    present.correctBoundaryConditions();
    const surfaceScalarField both(between());
    flux_.reset
    (
        new surfaceScalarField
        (
            IOobject
            (
                volume_.name() + "Flux", mesh_.time().timeName(), mesh_,
                IOobject::NO_READ, IOobject::NO_WRITE, false
            ),
            both*flux
        )
    );

    volScalarField m("shift", present);
    volScalarField rest("rest", volume_ - dt*fvc::surfaceIntegrate(*flux_));
    forAll(active_, celli)
    {
        const scalar a = alpha[celli];
        m[celli] = active_[celli] ? a*(1 - a + least) + 1e-12 : 1;
        rest[celli] = active_[celli] ? rest[celli] - a : 0;
    }

    // The orthogonal part of a Laplacian is as good as all of it
    const surfaceScalarField weight
    (
        both/linearInterpolate(1/max(present, dimensionedScalar("least", dimless, least)))
       *dimensionedScalar("area", dimArea, magSqr(mesh_.bounds().span()))
    );
    tmp<volScalarField> tpsi
    (
        new volScalarField
        (
            IOobject
            (
                "phaseShift", mesh_.time().timeName(), mesh_,
                IOobject::NO_READ, IOobject::NO_WRITE, false
            ),
            mesh_,
            dimensionedScalar(dimless, Zero),
            patchTypes()
        )
    );
    volScalarField& psi = tpsi.ref();
    mesh_.setFluxRequired(psi.name());
    IStringStream scheme("linear orthogonal");
    fv::gaussLaplacianScheme<scalar, scalar> laplacian(mesh_, scheme);
    fvScalarMatrix equation
    (
        fvm::Sp(m, psi) - laplacian.fvmLaplacian(weight, psi) == rest
    );

    // OpenFOAM's residual is wrong for numbers as small as the volume of a mesh cell
    const dimensionedScalar size("size", dimless, gAverage(mesh_.V()));
    equation *= 1/size;

    static const dictionary usual
    (
        IStringStream("solver PCG; preconditioner DIC; tolerance 1e-11; relTol 0;")()
    );
    const dictionary& solvers = mesh_.solutionDict().subDict("solvers");
    equation.solve
    (
        solvers.found(psi.name(), keyType::REGEX)
      ? solvers.subDict(psi.name()) : usual
    );
    *flux_ += size*equation.flux()/dt;
    return tpsi;
}


Foam::scalarField Foam::phaseVolume::update
(
    const scalarField& alpha,
    const surfaceScalarField& flux
)
{
    scalarField change(mesh_.nCells(), Zero);
    tmp<volScalarField> tpsi(correct(alpha, flux));
    bool kept = true;
    forAll(change, celli)
    {
        if (active_[celli] && mag(tpsi()[celli]) > 0.5)
        {
            change[celli] = alpha[celli] - volume_[celli];
            kept = false;
        }
    }
    if (!returnReduce(kept, andOp<bool>()))
    {
        add(change);
        tpsi = correct(alpha, flux);
    }
    volume_.primitiveFieldRef() -=
        mesh_.time().deltaTValue()*fvc::surfaceIntegrate(*flux_)().primitiveField();
    volume_.correctBoundaryConditions();
    return change;
}
