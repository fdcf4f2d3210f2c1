/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "clumpMotion.H"
#include "touchingClumps.H"

using namespace Foam;

namespace
{

//- n spheres along x, from x0 at this distance, of which the first has the velocity u
string row(const label n, const scalar x0, const scalar distance, const scalar u)
{
    string result;
    for (label k = 0; k < n; ++k)
    {
        const point p(x0 + k*distance, 10e-6, 10e-6);
        result += at("sphere", p, vector(k ? 0 : u, 0, 0));
    }
    return result;
}

}


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


TEST_CASE("joint minimiser: a pair that takes long costs the others nothing", "[contact]")
{
    const scalar r = 0.5e-6;
    string light;
    for (label k = 0; k < 25; ++k)
    {
        const point p(2e-6 + 3.5e-6*(k % 5), 2e-6 + 3.5e-6*(k/5), 4e-6);
        light += at("sphere", p, Zero) + at("sphere", p + vector(1.999*r, 0, 0), Zero);
    }
    const point p(10e-6, 10e-6, 12e-6);
    // In a step that is longer than ten contact times, and not divided
    const scalar dt = 4e-4;
    const vector u(1e-3, 0, 0);
    const string hard
    (
        at("sphere", p, u) + at("sphere", p + vector(1.2*r, 0, 0), -u)
    );

    const auto solves = [&](const string& clumps)
    {
        dryCloud t(dt, clumps, "reducedModulus 1000; restitution 0.5;");
        t.step();
        return returnReduce(t.cloud->motion().nSolves(), sumOp<label>());
    };
    const label ofLight = solves(light), ofHard = solves(hard), together = solves(light + hard);
    INFO(ofLight << " and " << ofHard << " solutions alone, " << together << " together");
    CHECK(together <= ofLight + ofHard + 4);
}


TEST_CASE("joint minimiser: those that will touch take part at once", "[contact]")
{
    // The first of a row of spheres pushes them together, one after the other
    const scalar r = 0.5e-6, dt = 1e-4, u = 0.5*r/dt;
    const label n = 8;
    const auto pushed = [&](const scalar gap)
    {
        dryCloud t(dt, row(n, 4e-6, 2*r + gap, u), "reducedModulus 1000; restitution 0.5;");
        const vector P(t.momentum());
        t.step();
        CHECK(mag(t.momentum() - P) < 1e-9*mag(P));
        label number = 0;
        for (const clumpParcel& p : *t.cloud)
        {
            number += p.state().u[0].x() > 1e-6*u;
        }
        INFO("gaps of " << gap/r << " radii");
        CHECK(returnReduce(number, sumOp<label>()) == n);
        return returnReduce(t.cloud->motion().nSolves(), sumOp<label>());
    };
    const label touching = pushed(0), near = pushed(0.005*r);
    INFO(touching << " solutions where they touch, " << near << " with gaps");
    CHECK(near <= touching + n);
}


TEST_CASE("joint minimiser: those that are pushed into others join later", "[contact]")
{
    // Each gap is wider than a tenth of a radius, so that no clump is coupled before
    // the one behind it has moved
    const scalar r = 0.5e-6, dt = 1e-4, u = 0.9*r/dt, gap = 0.15*r;
    const label n = 3;
    dryCloud t(dt, row(n, 8.5e-6, 2*r + gap, u), "reducedModulus 1000; restitution 0.5;");
    const vector P(t.momentum());
    t.step();
    const vectorField x(t.centres());
    CHECK(mag(t.momentum() - P) < 1e-9*mag(P));
    for (label k = 0; k + 1 < n; ++k)
    {
        INFO("spheres " << k << " and " << k + 1);
        CHECK(x[k + 1].x() - x[k].x() > 1.9*r);
    }
    CHECK(x[n - 1].x() > 8.5e-6 + (2*r + gap)*(n - 1) + 0.01*r);
}
