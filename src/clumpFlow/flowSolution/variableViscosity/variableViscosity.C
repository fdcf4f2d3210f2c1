/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "variableViscosity.H"
#include "fluidCoupling.H"
#include "fluidsInside.H"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "fvcSnGrad.H"
#include "fvmLaplacian.H"
#include "linear.H"
#include "mirroredValues.H"
#include "turnedMomentum.H"

Foam::variableViscosity::variableViscosity
(
    volVectorField& U,
    const fluidsInside& fluids
)
:
    U_(U),
    fluids_(fluids),
    acceleration_(6),
    onPatches_(Zero),
    nPasses_(0)
{}


Foam::tmp<Foam::volVectorField> Foam::variableViscosity::coupling()
{
    const fvMesh& mesh = U_.mesh();

    // By name: a temporary tensor field would be transposed in place, see
    // fluidsInside::couple
    volTensorField gradU("gradU", fvc::grad(U_));
    setMirroredValues(gradU, U_);
    const surfaceVectorField transposed
    (
        mesh.Sf() & linearInterpolate(T(gradU))
    );
    const surfaceVectorField rest
    (
        *excess_*transposed
      + fluids_.couple(*nu_*(mesh.magSf()*fvc::snGrad(U_) + transposed))
    );
    onPatches_ = patchStress::sumOnPatches(rest);
    return fvc::div(rest);
}


Foam::tmp<Foam::fvVectorMatrix> Foam::variableViscosity::stress
(
    const volScalarField& nu
)
{
    nu_.reset(new surfaceScalarField("nuf", 1/linearInterpolate(1/nu)));
    excess_.reset
    (
        new surfaceScalarField("excess", *nu_ - min(nu))
    );

    // Set anew in every step: a change of the mesh need not map them
    nu_->checkOut();
    excess_->checkOut();
    const volVectorField rest(coupling());
    rest_ = rest.primitiveField();
    return -fvm::laplacian(*nu_, U_, "laplacian(nuEff,U)") - rest;
}


Foam::scalarField Foam::variableViscosity::asScalars(const vectorField& u)
{
    scalarField result(3*u.size());
    forAll(u, i)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            result[3*i + d] = u[i][d];
        }
    }
    return result;
}


void Foam::variableViscosity::solve
(
    fvVectorMatrix& UEqn,
    const volVectorField& gradp
)
{
    constexpr label most = 20;
    constexpr scalar tolerance = 1e-3;

    dictionary controls(UEqn.solverDict());
    const scalar relTol = controls.getOrDefault<scalar>("relTol", 0);
    controls.set("relTol", min(0.05, 500*relTol));

    const scalarField& V = U_.mesh().V();
    const scalar volume = gSum(V);
    const vectorField others(UEqn.source() - V*rest_);
    acceleration_.clear();
    for (nPasses_ = 1; true; ++nPasses_)
    {
        const vectorField before(U_.primitiveField());
        turnedMomentum::solve(UEqn, gradp, controls);
        const vectorField change(U_.primitiveField() - before);
        const vector mean(gSum(V*U_.primitiveField())/volume);
        const scalar size = gSum(V*magSqr(U_.primitiveField() - mean));

        const bool done =
            nPasses_ == most
         || gSum(V*magSqr(change)) <= sqr(tolerance)*size;
        if (!done)
        {
            const scalarField correction
            (
                acceleration_.correction(asScalars(before), asScalars(change))
            );
            forAll(U_, i)
            {
                for (direction d = 0; d < vector::nComponents; ++d)
                {
                    U_[i][d] += correction[3*i + d];
                }
            }
            U_.correctBoundaryConditions();
        }
        UEqn.source() = others + V*coupling()().primitiveField();
        if (done)
        {
            break;
        }
    }
}
