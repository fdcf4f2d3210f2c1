/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "catch2/catch.hpp"
#include "testCase.H"
#include "meanVelocityGradient.H"
#include "fixedValueFvPatchFields.H"
#include "wallFvPatch.H"
#include "zeroGradientFvPatchFields.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"
#include "volFields.H"

using namespace Foam;

namespace
{

//- Mean velocity over Ubar in steps of dt from rest, in a fluid that in addition loses the
//  part drag of its velocity per step. Without walls they slip
scalarList started(const scalar dt, const bool walls, const scalar drag)
{
    const fvMesh& mesh = testMesh();
    wordList types(mesh.boundary().size(), zeroGradientFvPatchVectorField::typeName);
    forAll(types, patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (patch.coupled())
        {
            types[patchi] = patch.type();
        }
        else if (walls && isA<wallFvPatch>(patch))
        {
            types[patchi] = fixedValueFvPatchVectorField::typeName;
        }
    }
    volVectorField U
    (
        IOobject("U", testTime().timeName(), mesh),
        mesh, dimensionedVector(dimVelocity, Zero), types
    );
    const volScalarField nu
    (
        IOobject("nu", testTime().timeName(), mesh),
        mesh, dimensionedScalar("nu", dimViscosity, 1.2e-6)
    );
    const scalar before = testTime().deltaTValue();
    testTime().setDeltaT(dt, false);
    fv::meanVelocityGradient drive
    (
        "testDrive", "meanVelocityGradient", dictOf
        (
            "type meanVelocityGradient; selectionMode all; fields (U);"
            "Ubar (1e-3 0 0);"
        ), mesh
    );
    const dictionary solver
    (
        dictOf("solver PCG; preconditioner DIC; tolerance 1e-13; relTol 0;")
    );

    scalarList means;
    for (label n = 0; n < 30; ++n)
    {
        const dimensionedScalar rate("rate", dimless/dimTime, 1/dt);
        fvVectorMatrix equation
        (
            fvm::Sp((1 + drag)*rate, U) - fvm::laplacian(nu, U) - rate*volVectorField(U)
        );
        fvVectorMatrix source(U, equation.dimensions());
        drive.addSup(source, 0);
        solve(equation == source, solver);
        drive.correct(U);
        means.append
        (
            gSum(U.primitiveField().component(vector::X)*mesh.V())/gSum(mesh.V())/1e-3
        );
    }
    testTime().setDeltaT(before, false);
    return means;
}

}


TEST_CASE("mean velocity: reached from rest, without swinging past", "[fvOptions]")
{
    // Of the time in which momentum reaches the walls, h^2/nu with h of 10 um: 1/80 to 100
    for (const scalar dt : {1e-6, 1e-5, 1e-4, 1e-2})
    {
        for (const bool walls : {true, false})
        {
            for (const scalar drag : {0.0, 0.1, 1.0})
            {
                const scalarList means(started(dt, walls, drag));
                INFO("dt " << dt << ", walls " << walls << ", drag " << drag);
                CHECK(max(means) < 1.1);
                CHECK(mag(means[9] - 1) < 0.01);
                CHECK(mag(means.last() - 1) < 1e-3);
            }
        }
    }
}
