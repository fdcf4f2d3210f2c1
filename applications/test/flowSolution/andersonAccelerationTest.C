/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "andersonAcceleration.H"

using namespace Foam;

namespace
{

//- Residual over that at the start, after passes of x <- a x + 1 with a from
//  -0.9 to 0.9
scalar residualAfter(const label nPasses, const label depth)
{
    const scalarField a(List<scalar>({-0.9, -0.5, 0.1, 0.4, 0.7, 0.9}));
    andersonAcceleration acceleration(depth);
    scalarField x(a.size(), Zero);
    scalarField r(a.size(), 1);
    for (label pass = 0; pass < nPasses; ++pass)
    {
        r = a*x + 1 - x;
        x += r + acceleration.correction(x, r);
    }
    r = a*x + 1 - x;
    return Foam::sqrt(sumSqr(r)/a.size());
}

}

TEST_CASE("andersonAcceleration: a linear map ends in as many passes as unknowns", "[serial]")
{
    const scalar plain = residualAfter(8, 0);
    CHECK(plain > 0.2);
    CHECK(residualAfter(8, 2) < 0.5*plain);
    CHECK(residualAfter(8, 6) < 1e-3);
    CHECK(residualAfter(12, 6) < 1e-6);
}


TEST_CASE("andersonAcceleration: nothing without a depth or in the first pass", "[serial]")
{
    const scalarField x(2, 1);
    scalarField r(2, 3);
    r[1] = 4;
    const scalarField nothing(2, Zero);
    andersonAcceleration none(0);
    none.correction(x, r);
    CHECK(none.correction(r, x) == nothing);

    andersonAcceleration two(2);
    CHECK(two.correction(x, r) == nothing);
    CHECK(two.correction(r, 2*r) != nothing);
    two.clear();
    CHECK(two.correction(x, r) == nothing);
}
