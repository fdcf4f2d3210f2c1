/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "catch2/catch.hpp"
#include "testCase.H"
#include "nearestCentres.H"
#include "rigidDeflation.H"

using namespace Foam;

namespace
{

const scalar dt = 1e-3;

//- A clump in motion, with the coefficients of a coupling
struct example
{
    const clumpType type;
    Random random;
    clumpState s;
    externalForces ext;
    scalarField z;
    scalarField zR;
    rigidDeflation deflation;

    explicit example(const dictionary& dict)
    :
        type("cell", dict),
        random(21),
        s(type),
        ext(type.size()),
        z(0.018*type.radii()),
        zR(0.01*pow3(type.radii())),
        deflation(type)
    {
        disturb(type, s, 0.1, random);
        ext.zeta = z + 0.3*type.masses()/dt;
        ext.zetaR = zR + 0.3*type.inertias()/dt;
        forAll(s.u, i)
        {
            ext.imposedU[i] = s.u[i] + 1e-4*randomVector(random);
            ext.imposedW[i] = s.w[i] + 10*randomVector(random);
        }
    }

    //- Forces under which the clump ends the step with the motion u0, w0 + V, W
    //  about its centre, where a share of z answers to V and W
    void setForces(const vector& V, const vector& W)
    {
        const vectorField r(s.x - s.centre(type));
        forAll(r, i)
        {
            const vector D(V + (W ^ r[i]));
            const vector rest
            (
                (1 - deflation.translation())*V
              + ((1 - deflation.rotation())*W ^ r[i])
            );
            const vector u(ext.imposedU[i] + D);
            const vector w(ext.imposedW[i] + W);
            ext.f[i] =
                type.masses()[i]/dt*(u - s.u[i]) + ext.zeta[i]*D - z[i]*rest;
            ext.t[i] =
                type.inertias()[i]/dt*(w - s.w[i]) + ext.zetaR[i]*W
              - zR[i]*(1 - deflation.rotation())*W;
        }
    }

    void shift()
    {
        const vectorField u0(ext.imposedU), w0(ext.imposedW);
        deflation.shift(type, s, u0, w0, z, zR, dt, ext);
    }

    //- What remains of the balances at a velocity
    scalar imbalance(const vectorField& u, const vectorField& w) const
    {
        scalar result = 0;
        forAll(u, i)
        {
            const vector f
            (
                ext.f[i]
              - ext.zeta[i]*(u[i] - ext.imposedU[i])
              - type.masses()[i]/dt*(u[i] - s.u[i])
            );
            const vector t
            (
                ext.t[i] - ext.zetaR[i]*(w[i] - ext.imposedW[i])
              - type.inertias()[i]/dt*(w[i] - s.w[i])
            );
            result = max(result, mag(f)/max(mag(ext.f)));
            result = max(result, mag(t)/max(mag(ext.t)));
        }
        return result;
    }
};

}

TEST_CASE("rigidDeflation: a rigid motion is solved for with its share", "[serial]")
{
    example e(cellDict());
    const vector V(1e-3, -2e-3, 5e-4);
    const vector W(100, 200, -50);
    const vectorField r(e.s.x - e.s.centre(e.type));
    const vectorField u(e.ext.imposedU + V + (W ^ r));
    const vectorField w(e.ext.imposedW + W);

    e.setForces(V, W);
    CHECK(e.imbalance(u, w) > 0.1);
    e.shift();
    CHECK(e.imbalance(u, w) < 1e-10);
}


TEST_CASE("rigidDeflation: a converged step does not change", "[serial]")
{
    example e(cellDict());
    const vectorField u(e.ext.imposedU), w(e.ext.imposedW);
    e.setForces(Zero, Zero);
    e.shift();
    CHECK(max(mag(e.ext.imposedU - u)) < 1e-10*max(mag(u)));
    CHECK(max(mag(e.ext.imposedW - w)) < 1e-10*max(mag(w)));
}


TEST_CASE("rigidDeflation: the shares", "[serial]")
{
    // No body has more resistance than a sphere around it; half of that is needed
    const clumpType cell("cell", cellDict());
    const rigidDeflation ring(cell);
    CHECK(ring.translation()*sum(cell.radii()) > 0.5*cell.reach());
    CHECK(ring.translation() < 0.5);
    CHECK(ring.rotation() > ring.translation());
    CHECK(ring.rotation() < 1);

    // A sphere needs the whole
    dictionary dict(cellDict());
    dict.set("shape", dictOf("type chain; nSpheres 1; sphereRadius 1e-6;"));
    const rigidDeflation sphere(clumpType("sphere", dict));
    CHECK(sphere.translation() == 1);
    CHECK(sphere.rotation() == 1);

    // And spheres far from each other
    dict.set
    (
        "shape",
        dictOf("type chain; nSpheres 2; spacing 50e-6; sphereRadius 1e-6;")
    );
    const rigidDeflation far(clumpType("far", dict));
    CHECK(far.translation() == 1);
    CHECK(far.rotation() == Approx(1).epsilon(0.05));
}


TEST_CASE("nearestCentres: as a search of all", "[serial]")
{
    Random random(22);
    const label n = GENERATE(1, 3, 200);
    pointField centres(n), points(2000);
    for (point& c : centres)
    {
        c = cmptMultiply(vector(3, 1.5, 1), randomVector(random));
    }
    for (point& x : points)
    {
        x = randomVector(random);
    }
    const scalar reach = 0.7;
    const labelList found(nearestCentres(points, centres, reach));

    label nWrong = 0, nNone = 0;
    forAll(points, k)
    {
        label nearest = -1;
        scalar least = reach;
        forAll(centres, i)
        {
            const scalar d = mag(centres[i] - points[k]);
            if (d < least)
            {
                least = d;
                nearest = i;
            }
        }
        nWrong += found[k] != nearest;
        nNone += nearest < 0;
    }
    CHECK(nWrong == 0);
    CHECK((n > 3 || nNone > 0));

    CHECK(nearestCentres(points, pointField(), reach)[0] == -1);
    CHECK(nearestCentres(pointField(), centres, reach).empty());
}
