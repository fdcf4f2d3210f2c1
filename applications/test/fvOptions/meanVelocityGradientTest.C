/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
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

//- Mean velocity [m/s] in steps of dt from rest, in a fluid that in addition loses the part
//  drag of its velocity per step and gains push [m/s]. Without walls they slip
List<vector> started
(
    const scalar dt,
    const bool walls,
    const scalar drag,
    const string& entries = "Ubar (1e-3 0 0);",
    const vector& push = Zero
)
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
            "type meanVelocityGradient; selectionMode all; fields (U);" + entries
        ), mesh
    );
    const dictionary solver
    (
        dictOf("solver PCG; preconditioner DIC; tolerance 1e-13; relTol 0;")
    );

    List<vector> means;
    for (label n = 0; n < 30; ++n)
    {
        const dimensionedScalar rate("rate", dimless/dimTime, 1/dt);
        fvVectorMatrix equation
        (
            fvm::Sp((1 + drag)*rate, U) - fvm::laplacian(nu, U) - rate*volVectorField(U)
          - rate*dimensionedVector("push", dimVelocity, push)
        );
        fvVectorMatrix source(U, equation.dimensions());
        drive.addSup(source, 0);
        solve(equation == source, solver);
        drive.correct(U);
        means.append(gSum(U.primitiveField()*mesh.V())/gSum(mesh.V()));
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
                scalarList means;
                for (const vector& mean : started(dt, walls, drag))
                {
                    means.append(mean.x()/1e-3);
                }
                INFO("dt " << dt << ", walls " << walls << ", drag " << drag);
                CHECK(max(means) < 1.1);
                CHECK(mag(means[9] - 1) < 0.01);
                CHECK(mag(means.last() - 1) < 1e-3);
            }
        }
    }
}


TEST_CASE("mean velocity: held as a vector against a slanting push", "[fvOptions]")
{
    // Walls in y; x and z are periodic
    const vector push(1e-4, 0, 5e-5);
    const auto last = [&](const string& entries)
    {
        return started(1e-4, true, 0.1, entries, push).last();
    };
    for (const vector& Ubar : {vector(1e-3, 0, 0), vector::zero, vector(3e-4, 0, -2e-4)})
    {
        OStringStream entry;
        entry << "Ubar " << Ubar << ';';
        INFO(entry.str());
        CHECK(mag(last(entry.str()) - Ubar) < 1e-9);
    }
    const vector free(last("Ubar (1e-3 0 0); free (z);"));
    CHECK(mag(free.x() - 1e-3) < 1e-9);
    CHECK(free.z() > 1e-5);
}
