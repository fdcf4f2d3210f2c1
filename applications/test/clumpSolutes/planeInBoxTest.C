/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "planeInBox.H"
#include "testCloud.H"

using namespace Foam;

TEST_CASE("solutes: a plane cuts a box", "[solutes]")
{
    const vector h(1, 2, 0.5);
    const vector n
    (
        GENERATE(vector(1, 0, 0), vector(0.6, 0, -0.8), vector(0.48, 0.6, 0.64))
    );
    const vector m(cmptMultiply(cmptMag(n), h));
    const scalar half = 0.5*cmptSum(m);
    CHECK(planeInBox::behind(1.01*half, m).fraction == 0);
    CHECK(planeInBox::behind(-1.01*half, m).fraction == 1);
    for (const scalar d : {0.0, 0.1, 0.3, 0.45})
    {
        const planeInBox::part part = planeInBox::behind(d, m);

        // The other side has the rest
        CHECK
        (
            part.fraction + planeInBox::behind(-d, m).fraction == Approx(1)
        );

        // The area is the derivative of the volume
        const scalar e = 1e-5;
        const scalar slope =
        (
            planeInBox::behind(d - e, m).fraction
          - planeInBox::behind(d + e, m).fraction
        )/(2*e);
        CHECK(part.area == Approx(slope).epsilon(1e-3).margin(1e-3));

        // Points of the box behind the plane
        label behind = 0;
        constexpr label N = 60;
        for (label i = 0; i < N*N*N; ++i)
        {
            const vector x
            (
                ((i % N + 0.5)/N - 0.5)*h.x(),
                ((i/N % N + 0.5)/N - 0.5)*h.y(),
                ((i/N/N + 0.5)/N - 0.5)*h.z()
            );
            behind += (x & n) < -d;
        }
        CHECK(part.fraction == Approx(scalar(behind)/(N*N*N)).margin(0.02));
    }
}
