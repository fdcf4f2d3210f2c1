/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "carriedPressure.H"
#include "fvcLaplacian.H"
#include "fvmLaplacian.H"
#include "fvMatrices.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

using constant::mathematical::twoPi;

const scalar L = 20e-6;     // of the box

//- A pressure on the mesh of the box; the type is that on the walls
volScalarField pressure(const word& onWalls)
{
    const fvMesh& mesh = testMesh();
    wordList types(mesh.boundary().size());
    forAll(types, i)
    {
        const fvPatch& patch = mesh.boundary()[i];
        types[i] = patch.coupled() ? patch.type() : onWalls;
    }
    return volScalarField
    (
        IOobject("p", testTime().timeName(), mesh),
        mesh, dimensionedScalar(sqr(dimVelocity), Zero), types
    );
}

//- Waves along x and z, even at the walls, moved by d
void setWaves(volScalarField& p, const label n, const vector& d)
{
    forAll(p, i)
    {
        const point x(twoPi/L*(p.mesh().C()[i] - d));
        p[i] =
            Foam::sin(n*x.x())*Foam::cos(n*x.z())*Foam::cos(0.5*x.y());
    }
    p.correctBoundaryConditions();
}

//- How to solve for a pressure
dictionary solver()
{
    return dictOf
    (
        "solver PCG; preconditioner DIC; tolerance 1e-14; relTol 0;"
        "maxIter 2000;"
    );
}

//- Sources in the middle, with a first moment
void setSources(volScalarField& p)
{
    volScalarField q("q", 0*p/dimensionedScalar("", dimArea, 1));
    forAll(q, i)
    {
        const vector r((p.mesh().C()[i] - 0.5*L*vector::one)/6e-6);
        q[i] =
            sqr(max(1 - magSqr(r), scalar(0)))
           *(r.x() + 0.3*r.y() - 0.5*r.z())/sqr(L);
    }
    fvScalarMatrix equation(fvm::laplacian(p) == q);
    equation.setReference(Pstream::master() ? 0 : -1, 0);
    equation.solve(solver());
}

//- A hump around the middle
void setHump(volScalarField& p)
{
    forAll(p, i)
    {
        const vector r((p.mesh().C()[i] - 0.5*L*vector::one)/6e-6);
        p[i] = sqr(max(1 - magSqr(r), scalar(0)))*(1 + r.x() + 0.5*r.z());
    }
    p.correctBoundaryConditions();
}

void carry(volScalarField& p, const vector& d)
{
    const volVectorField displacement
    (
        IOobject("d", testTime().timeName(), testMesh()),
        testMesh(), dimensionedVector("", dimLength, d)
    );
    carriedPressure(p, Pstream::master() ? 0 : -1).carry(displacement, solver());
}

scalar norm(const scalarField& f) { return Foam::sqrt(gSumSqr(f)); }

//- Error over the change, for n waves in the box carried by d
scalar shiftError(const label n, const vector& d)
{
    volScalarField p(pressure("zeroGradient"));
    volScalarField moved(p);
    setWaves(p, n, Zero);
    setWaves(moved, n, d);
    const scalar change = norm(moved.primitiveField() - p.primitiveField());

    carry(p, d);
    scalarField difference(moved.primitiveField() - p.primitiveField());
    difference -= gAverage(difference);
    return norm(difference)/change;
}

}

TEST_CASE("carriedPressure: a uniform displacement shifts the pattern")
{
    const vector d(0.6e-6, 0, 0);
    const scalar coarse = shiftError(2, d);
    const scalar fine = shiftError(1, d);
    CHECK(fine < 0.03);

    // Second order in the mesh width over the wave length
    CHECK(coarse/fine > 3);
    CHECK(coarse/fine < 5);

    // Across the mesh, and by more than a mesh cell
    CHECK(shiftError(1, vector(0.6e-6, 0, -0.2e-6)) < 0.05);
    CHECK(shiftError(1, vector(2.3e-6, 0, 0)) < 0.03);
}


TEST_CASE("carriedPressure: nothing moves, nothing changes")
{
    volScalarField p(pressure("zeroGradient"));
    setHump(p);
    const scalarField before(p.primitiveField());
    carry(p, Zero);
    CHECK(norm(p.primitiveField() - before) < 1e-14*norm(before));
}


TEST_CASE("carriedPressure: the moments of the sources")
{
    volScalarField p(pressure("zeroGradient"));
    setSources(p);
    const vectorField x
    (
        (testMesh().C().primitiveField() - 0.5*L*vector::one)/L
    );
    const auto sources = [&p]
    {
        return scalarField
        (
            fvc::laplacian(p)().primitiveField()
           *testMesh().V().field()
        );
    };
    const scalarField q(sources());
    const vector d(0.7e-6, 0.3e-6, -0.4e-6);
    carry(p, d);
    const scalarField change(sources() - q);
    const scalar size = gSum(mag(change));
    const vector moment(gSum(q*x));

    CHECK(size > 0.1*gSum(mag(q)));
    CHECK(mag(gSum(change)) < 1e-8*size);
    CHECK(mag(gSum(change*x)) < 1e-8*size);

    // The second moments: of a source at x that goes to x + d
    const symmTensor expected(twoSymm(moment*d)/L);
    CHECK(mag(expected) > 1e-3*size);
    CHECK(mag(gSum(change*sqr(x)) - expected) < 1e-8*size);
}


TEST_CASE("carriedPressure: a pressure that a patch fixes stays")
{
    volScalarField p(pressure("fixedValue"));
    p.boundaryFieldRef() == 3;
    setHump(p);
    const scalarField before(p.primitiveField());
    carry(p, vector(1e-6, 1e-6, 0));

    CHECK(norm(p.primitiveField() - before) > 0.01*norm(before));
    forAll(p.boundaryField(), i)
    {
        if (!p.boundaryField()[i].coupled() && p.boundaryField()[i].size())
        {
            CHECK(min(p.boundaryField()[i]) == 3);
            CHECK(max(p.boundaryField()[i]) == 3);
        }
    }
}
