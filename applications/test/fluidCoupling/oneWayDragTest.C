/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCloud.H"
#include "oneWayDrag.H"
#include "mathematicalConstants.H"

using namespace Foam;

TEST_CASE("oneWayDrag: a clump is dragged as a sphere of its volume", "[oneWay]")
{
    testCloud t(point(10e-6, 9e-6, 8e-6), vector(1e-3, 0, 0));
    const scalar mu = 1.2e-3;
    const scalar r = Foam::cbrt(0.75*t.type().volume()/constant::mathematical::pi);
    const scalar drag = 6*constant::mathematical::pi*mu*r;

    CHECK(sum(oneWayDrag::resistance(t.type(), mu)) == Approx(drag));

    // In a uniform flow across processors, images and all
    const volVectorField U
    (
        IOobject("testU", testTime().timeName(), testMesh()),
        testMesh(),
        dimensionedVector("U", dimVelocity, vector(3e-3, -1e-3, 0))
    );
    List<clumpImage> images(t.cloud().ghosts().images());
    oneWayDrag(t.cloud().types()).integrate(U, mu, false, images);

    vector force(Zero);
    for (const clumpImage& image : images)
    {
        force += sum(image.fluid.f);
        CHECK(max(mag(image.fluid.t)) == 0);
    }
    reduce(force, sumOp<vector>());
    CHECK(mag(force - drag*vector(2e-3, -1e-3, 0)) < 1e-10*drag*1e-3);
}
