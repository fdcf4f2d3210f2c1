/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testMembrane.H"
#include "buckledPart.H"

using namespace Foam;

namespace
{

clumpType sphere(const char* subdivisions)
{
    return clumpType
    (
        "test",
        dictOf
        (
            string("density 1; shape { type icosphere; radius 1; subdivisions ")
          + subdivisions + "; }"
        )
    );
}

}


TEST_CASE("buckled part: smooth shapes have none", "[membrane]")
{
    for (const char* subdivisions : {"2", "3"})
    {
        const clumpType type(sphere(subdivisions));
        pointField x(type.centres());
        REQUIRE(buckledPart(type.surface(), x) == 0);
        for (point& p : x)
        {
            p = point(1.5*p.x(), p.y()/1.2, p.z()/1.25);
        }
        CHECK(buckledPart(type.surface(), x) == 0);
    }
}


TEST_CASE("buckled part: that with short waves, at any size", "[membrane]")
{
    const clumpType type(sphere("3"));
    const closedSurface& surface = type.surface();
    const scalar d = surface.edgeLength(type.centres());
    Random random(1);
    for (const scalar size : {1.0, 1e-6})
    {
        pointField x(size*type.centres());
        for (point& p : x)
        {
            if (p.x() > 0)
            {
                p *= 1 + (random.sample01<scalar>() < 0.5 ? 0.15 : -0.15)*d;
            }
        }
        const scalar part = buckledPart(surface, x);
        CHECK(part > 0.25);
        CHECK(part < 0.6);
    }
}
