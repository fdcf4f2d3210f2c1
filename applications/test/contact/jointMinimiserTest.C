/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "touchingClumps.H"

using namespace Foam;


TEST_CASE("joint minimiser: few iterations, however many clumps touch", "[contact]")
{
    // A lattice of spheres at rest, each pressed into its neighbours, which springs apart
    const scalar r = 0.5e-6;
    const label n = 6, all = n*n*n;
    string clumps;
    for (label k = 0; k < all; ++k)
    {
        const vector place(k % n, (k/n) % n, k/(n*n));
        clumps += at
        (
            "sphere", 5e-6*vector::one + 1.94*r*place, Zero
        );
    }
    dryCloud t(1e-4, clumps, "reducedModulus 1000; restitution 0.5;");
    t.step();

    const label solves = returnReduce(t.cloud->motion().nSolves(), sumOp<label>());
    INFO(scalar(solves)/all << " solutions per clump in one step");
    CHECK(solves <= 9*all);
}
