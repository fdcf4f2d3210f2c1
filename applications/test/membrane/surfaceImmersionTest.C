/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testImmersion.H"

using namespace Foam;

namespace
{

//- One of 162 nodes
struct immersed
:
    testImmersion
{
    immersed(const point& centre, const word& kernel, const scalar radius = 4e-6)
    :
        testImmersion
        (
            List<point>(1, centre), string("kernel " + kernel + ";"), radius, 2
        )
    {}

    //- The image of the sphere itself, on the master
    clumpImage& own() { return ghosts.images()[0]; }
};

volVectorField fieldOf(const std::function<vector(const point&)>& f)
{
    const fvMesh& mesh = testMesh();
    volVectorField U
    (
        IOobject("test", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimVelocity, Zero)
    );
    forAll(U, celli)
    {
        U[celli] = f(mesh.cellCentres()[celli]);
    }
    return U;
}

}


TEST_CASE("immersion: uniform and linear velocities are exact", "[membrane][parallel]")
{
    const word kernel = GENERATE(word("hat"), word("threePoint"), word("fourPoint"));
    INFO(kernel);
    immersed sphere(point(10e-6, 10e-6, 10e-6), kernel);
    const vector b(1, -2, 3);
    const tensor A(1e5, 2e5, -3e5, 4e5, 5e5, 6e5, -7e5, 8e5, 9e5);
    sphere.immersion->sample
    (
        fieldOf([&](const point& x) { return b + (A & x); }), sphere.ghosts
    );
    if (Pstream::master())
    {
        const clumpImage& own = sphere.own();
        forAll(own.x, i)
        {
            CHECK(mag(own.sampled[i] - b - (A & own.x[i])) < 1e-10);
        }
    }
}


TEST_CASE("immersion: weights add up across periodic patches", "[membrane][parallel]")
{
    immersed sphere(point(0.5e-6, 10e-6, 19e-6), "threePoint");
    const vector b(1, -2, 3);
    sphere.immersion->sample(fieldOf([&](const point&) { return b; }), sphere.ghosts);
    if (Pstream::master())
    {
        CHECK(max(mag(sphere.own().sampled - b)) < 1e-12);
    }
}


TEST_CASE("immersion: nodes next to a wall have weights", "[membrane][parallel]")
{
    // The lowest nodes are a tenth of a mesh cell above the wall
    immersed sphere(point(10e-6, 3.85e-6, 10e-6), "threePoint");
    const vector b(1, -2, 3);
    sphere.immersion->sample(fieldOf([&](const point&) { return b; }), sphere.ghosts);
    if (Pstream::master())
    {
        CHECK(min(sphere.own().x.component(vector::Y)) < 0.2e-6);
        CHECK(max(mag(sphere.own().sampled - b)) < 1e-12);
    }
}


TEST_CASE("immersion: spreading is the transpose of sampling", "[membrane][parallel]")
{
    const point centre = GENERATE
    (
        point(10e-6, 10e-6, 10e-6), point(0.5e-6, 3.85e-6, 19e-6)
    );
    immersed sphere(centre, "threePoint");

    // Any velocity, the same on every number of processors
    const volVectorField U
    (
        fieldOf
        (
            [](const point& x)
            {
                return vector
                (
                    Foam::sin(1e6*x.x()), Foam::cos(2e6*x.y()), Foam::sin(3e6*x.z())
                );
            }
        )
    );
    scalar power = 0;
    vector force(Zero);
    if (Pstream::master())
    {
        Random random(4);
        for (vector& F : sphere.own().force)
        {
            F = 1e-12*randomVector(random);
        }
        force = sum(sphere.own().force);
    }
    sphere.immersion->spread(sphere.ghosts);
    sphere.immersion->sample(U, sphere.ghosts);
    if (Pstream::master())
    {
        power = sum(sphere.own().force & sphere.own().sampled);
    }
    reduce(power, sumOp<scalar>());
    reduce(force, sumOp<vector>());

    const scalarField& V = testMesh().V();
    const vectorField& f = sphere.immersion->force();
    CHECK(gSum(V*(f & U.primitiveField())) == Approx(power).epsilon(1e-10));
    CHECK(mag(gSum(V*f) - force) < 1e-12*mag(force));
}


TEST_CASE("immersion: the width of the mesh cells of the kernel of a node",
    "[membrane][parallel]")
{
    // Of nodes on a sphere in a uniform mesh of 1 um. The variance of the kernel is from
    // 1/4 (between two mesh cells) to 1/3 (in the centre of one) along every direction
    immersed sphere(point(10e-6, 10e-6, 10e-6), "threePoint");
    if (Pstream::master())
    {
        const surfaceKernel K(surfaceKernel::form::threePoint);
        const scalar h = 1e-6/Foam::sqrt(K.variance());
        const scalarField widths
        (
            sphere.immersion->widths
            (
                sphere.own(), sphere.types[0].surface().areaVectors(sphere.own().x)
            )
        );
        CHECK(min(widths) > 0.999*h*Foam::sqrt(1.0/4));
        CHECK(max(widths) < 1.001*h*Foam::sqrt(1.0/3));
    }
}
