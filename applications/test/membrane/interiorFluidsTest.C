/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testImmersion.H"

using namespace Foam;

namespace
{

//- Mass of the excess of density over the density of the flow [m3]
scalar excessMass(const testImmersion& spheres)
{
    return returnReduce(spheres.immersion->excessMass(), sumOp<scalar>());
}

}


TEST_CASE("density ratio: the inside has its mass", "[membrane][parallel]")
{
    // In the middle, and across periodic patches and processors
    const point centre = GENERATE
    (
        point(10e-6, 10e-6, 10e-6), point(0.5e-6, 9e-6, 19e-6)
    );
    const scalar ratio = GENERATE(0.1, 4.0);
    const scalar viscosity = GENERATE(1.0, 5.0);
    const testImmersion sphere
    (
        List<point>(1, centre), "viscosityRatio " + Foam::name(viscosity) + ";",
        4e-6, 3, 1000/ratio
    );
    CHECK(!sphere.immersion->viscosity() == (viscosity == 1));

    const scalar V = sphere.types[0].volume();
    CHECK(excessMass(sphere) == Approx((ratio - 1)*V).epsilon(0.01));
    const scalarField& density = sphere.immersion->density()->primitiveField();
    CHECK(gMin(density) > min(ratio, 1.0) - 1e-9);
    CHECK(gMax(density) < max(ratio, 1.0) + 1e-9);

    // Its momentum in a uniform flow
    const volVectorField U
    (
        IOobject("U", testMesh().time().timeName(), testMesh()), testMesh(),
        dimensionedVector("U", dimVelocity, vector(1, -2, 3))
    );
    const vector momentum
    (
        returnReduce(sphere.immersion->excessMomentum(U), sumOp<vector>())
    );
    CHECK(mag(momentum/excessMass(sphere) - vector(1, -2, 3)) < 1e-12);
}


TEST_CASE("density ratio: between two surfaces it is not that of both",
    "[membrane][parallel]")
{
    List<point> centres(2, point(6e-6, 10e-6, 10e-6));
    centres[1].x() = 13.7e-6;
    const testImmersion spheres(centres, "", 4e-6, 3, 200);
    CHECK(gMax(spheres.immersion->density()->primitiveField()) < 5.0001);
}


TEST_CASE("density ratio: off where it is one", "[membrane][serial]")
{
    const testImmersion sphere(List<point>(1, point(10e-6, 10e-6, 10e-6)), "", 4e-6, 2);
    CHECK(!sphere.immersion->density());
    CHECK(excessMass(sphere) == 0);
}
