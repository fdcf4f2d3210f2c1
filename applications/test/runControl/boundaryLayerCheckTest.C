/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "boundaryLayerCheck.H"

using namespace Foam;

TEST_CASE("boundaryLayerCheck: Reynolds number of a drag", "[runControl][serial]")
{
    // Stokes; and the drag of the law at a Reynolds number
    CHECK(boundaryLayerCheck::ReynoldsNumber(1e-6) == Approx(1e-6));
    for (const scalar Re : {0.1, 1.0, 30.0, 86.0, 1e3})
    {
        const scalar f = Re*(1 + 0.15*Foam::pow(Re, 0.687));
        CHECK(boundaryLayerCheck::ReynoldsNumber(f) == Approx(Re).epsilon(1e-6));
    }
}
