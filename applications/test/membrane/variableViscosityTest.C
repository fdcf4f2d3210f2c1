/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testImmersion.H"
#include "variableViscosity.H"

using namespace Foam;

TEST_CASE("variable viscosity: a rotation has no stress", "[membrane][parallel]")
{
    // Neither has any linear velocity where the viscosity is uniform; one that is
    // sheared has that of the gradient of the viscosity
    const fvMesh& mesh = testMesh();
    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimVelocity, Zero), "fixedValue"
    );
    volScalarField nu
    (
        IOobject("nuTest", mesh.time().timeName(), mesh), mesh,
        dimensionedScalar("nu", dimViscosity, 1e-6)
    );
    const tensor shear(0, 10, 0, -4, 0, 2, 0, 6, 0);
    const vector slope(2e10, 6e9, -4e9);
    const point centre(1e-5*vector::one);
    const auto nuAt = [&](const point& x)
    {
        return 1/(6e5 + (slope & (x - centre)));
    };
    forAll(U, celli)
    {
        const point& x = mesh.cellCentres()[celli];
        U[celli] = shear & (x - centre);
        nu[celli] = nuAt(x);
    }
    U.correctBoundaryConditions();
    nu.correctBoundaryConditions();
    const testInterior none(List<point>(), 5);
    variableViscosity viscosity(U, *none.immersion);
    const tmp<fvVectorMatrix> tstress(viscosity.stress(nu));
    const volVectorField force(tstress() & U);

    // div(nu (G + G^T)) = (G + G^T) . grad nu, of the mesh cell with these viscosities on
    // its faces; the box is periodic, the fields are not
    vectorField gradNu(mesh.nCells(), Zero);
    forAll(mesh.faces(), facei)
    {
        const vector part(nuAt(mesh.faceCentres()[facei])*mesh.faceAreas()[facei]);
        gradNu[mesh.faceOwner()[facei]] += part/mesh.V()[mesh.faceOwner()[facei]];
        if (mesh.isInternalFace(facei))
        {
            const label celli = mesh.faceNeighbour()[facei];
            gradNu[celli] -= part/mesh.V()[celli];
        }
    }
    forAll(U, celli)
    {
        const vector x(mesh.cellCentres()[celli]);
        if (mag(cmptMax(cmptMag(x - centre))) < 7.6e-6)
        {
            const vector expected((shear + shear.T()) & gradNu[celli]);
            CHECK(mag(force[celli] + expected) < 1e-6*mag(expected));
        }
    }
}


TEST_CASE("variable viscosity: a sphere that turns with the fluid around it",
    "[membrane][parallel]")
{
    const fvMesh& mesh = testMesh();
    const testInterior sphere(List<point>(1, point(10e-6, 10e-6, 10e-6)), 20);
    const volScalarField nu
    (
        dimensionedScalar("nu", dimViscosity, 1e-6)*sphere.factor()
    );
    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimVelocity, Zero), "fixedValue"
    );
    variableViscosity viscosity(U, *sphere.immersion);
    const auto largestForce = [&](const tensor& gradient)
    {
        forAll(U, celli)
        {
            U[celli] = gradient & (mesh.cellCentres()[celli] - 1e-5*vector::one);
        }
        U.correctBoundaryConditions();
        const tmp<fvVectorMatrix> tstress(viscosity.stress(nu));
        const volVectorField force(tstress() & U);

        // The box is periodic, the velocity is not
        scalar result = 0;
        forAll(U, celli)
        {
            const vector x(mesh.cellCentres()[celli] - 1e-5*vector::one);
            if (cmptMax(cmptMag(x)) < 7.6e-6)
            {
                result = max(result, mag(force[celli]));
            }
        }
        return returnReduce(result, maxOp<scalar>());
    };
    const scalar sheared = largestForce(tensor(0, 10, 0, 10, 0, 0, 0, 0, 0));
    CHECK(largestForce(tensor(0, 10, 20, -10, 0, 30, -20, -30, 0)) < 1e-9*sheared);
}


TEST_CASE("variable viscosity: the momentum equation is solved with all of it",
    "[membrane][parallel]")
{
    const fvMesh& mesh = testMesh();
    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimVelocity, Zero), "fixedValue"
    );
    const testInterior sphere(List<point>(1, point(10e-6, 10e-6, 10e-6)), 5);
    const volScalarField nu
    (
        dimensionedScalar("nu", dimViscosity, 1e-6)*sphere.factor()
    );

    // A force that turns the inside
    volVectorField force
    (
        IOobject("forceTest", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimAcceleration, Zero)
    );
    const vector omega(10, 20, -30);
    forAll(force, celli)
    {
        const vector x(mesh.cellCentres()[celli] - point(10e-6, 10e-6, 10e-6));
        force[celli] = mag(x) < 4e-6 ? 1e8*(omega ^ x) : vector::zero;
    }
    variableViscosity viscosity(U, *sphere.immersion);
    fvVectorMatrix UEqn(viscosity.stress(nu) - force);
    UEqn.lower();       // as in rbcIbFoam
    viscosity.solve(UEqn, 0*force);
    CHECK(viscosity.nPasses() < 20);

    // What is left, with the stress of the solution
    const tmp<fvVectorMatrix> tstress(viscosity.stress(nu));
    const volVectorField left((tstress() & U) - force);
    const scalar residual =
        Foam::sqrt(gSumMag(left.primitiveField())/gSumMag(force.primitiveField()));
    CHECK(residual < 0.15);
}
