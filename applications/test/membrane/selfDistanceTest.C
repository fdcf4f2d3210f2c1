/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "mathematicalConstants.H"
#include "selfDistance.H"

using namespace Foam;

namespace
{

struct membraneShape
{
    const clumpType type;
    const selfDistance self;

    explicit membraneShape(const string& shape)
    :
        type("test", dictOf("density 1; membrane {} shape { " + shape + " }")),
        self(type.surface(), type.centres())
    {}

    //- The cell with its thickness h + k times that at rest
    pointField thin(const scalar h, const scalar k) const
    {
        pointField x(type.centres());
        for (point& p : x)
        {
            p.z() = k*p.z() + 0.5*h*(p.z() > 0 ? 1 : -1);
        }
        return x;
    }
};

const string disc("type biconcave; diameter 2; subdivisions 2;");

}


TEST_CASE("self-distance: none of a sphere, the dimples of a cell", "[membrane][serial]")
{
    const membraneShape sphere("type icosphere; radius 1; subdivisions 2;");
    CHECK(sphere.self.thickness() > 1.5);
    CHECK(sphere.self.find(sphere.type.centres(), 0.5).empty());

    // 0.207 in the middle of a disc of the radius 1 (Evans and Fung 1972)
    const membraneShape red(disc);
    CHECK(red.self.thickness() == Approx(0.2072).epsilon(0.03));
    CHECK(red.self.find(red.type.centres(), 0.9*red.self.thickness()).empty());
}


TEST_CASE("self-distance: winding numbers", "[membrane][serial]")
{
    const membraneShape red(disc);
    const pointField& x = red.type.centres();
    CHECK(red.self.windingNumber(x, point(0.02, 0.01, 0.01)) == Approx(1));
    CHECK(mag(red.self.windingNumber(x, point(0.02, 0.01, 0.5))) < 1e-9);

    // Where the dimples have passed each other
    const pointField y(red.thin(-0.4, 1));
    CHECK(red.self.windingNumber(y, point(0.02, 0.01, 0.01)) == Approx(-1));
}


TEST_CASE("self-distance: gaps across the inside, also of dimples that have passed",
    "[membrane][serial]")
{
    const membraneShape red(disc);
    const scalar gap = GENERATE(0.05, -0.05);
    INFO(gap);
    const pointField x(red.thin(gap, 0));

    // Two parallel planes
    label n = 0;
    for (const auto& p : red.self.find(x, 0.1))
    {
        if (mag(x[p.node]) > 0.5)
        {
            continue;
        }
        ++n;
        CHECK(p.gap == Approx(gap));

        // The node moves away from what it faces: upper ones up
        const bool upper = red.type.centres()[p.node].z() > 0;
        CHECK(p.opens.z() == Approx(upper ? 1 : -1));
    }
    CHECK(n > 10);
}


TEST_CASE("self-distance: gaps across the outside", "[membrane][serial]")
{
    // A cylinder with flat ends, bent until its ends face each other
    const membraneShape sphere("type icosphere; radius 1; subdivisions 3;");
    const pointField& unit = sphere.type.centres();
    const scalar pi = constant::mathematical::pi;
    const auto bent = [&](const scalar opening)
    {
        pointField x(unit);
        for (point& p : x)
        {
            const scalar r = std::hypot(p.x(), p.y());
            const scalar k = mag(p.z()) < 0.8 ? 0.3/r : 0.5;
            const scalar angle =
                min(max(p.z()/0.8, scalar(-1)), scalar(1))*(pi - 0.5*opening);
            p = point
            (
                (1 + k*p.x())*Foam::cos(angle), k*p.y(), (1 + k*p.x())*Foam::sin(angle)
            );
        }
        return x;
    };

    // Before they meet, and after they have passed each other
    for (const scalar opening : {0.08, -0.08})
    {
        INFO(opening);
        const pointField x(bent(opening));
        label n = 0;
        for (const auto& p : sphere.self.find(x, 0.15))
        {
            if (mag(unit[p.node].z()) < 0.95)
            {
                continue;
            }
            ++n;
            CHECK(p.gap == Approx(-x[p.node].x()*opening).epsilon(0.02));

            // Each end moves back to its own half
            CHECK(sign(unit[p.node].z())*p.opens.z() > 0.99);
        }
        CHECK(n > 10);
    }
}
