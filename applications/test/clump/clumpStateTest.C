/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "StringStream.H"

using namespace Foam;

TEST_CASE("state: a rigid motion is recognised", "[state][serial]")
{
    const clumpType type("cell", cellDict());
    Random random(6);
    clumpState s(type, randomRotation(random));

    const vector u(1e-3, -2e-3, 3e-3), omega(70, -20, 40);
    s.setRigidMotion(type, u, omega);

    CHECK(mag(s.velocity(type) - u) < 1e-14*mag(u));
    CHECK(mag(s.angularVelocity(type) - omega) < 1e-12*mag(omega));
}


TEST_CASE("state: what is written is read back exactly", "[state][serial]")
{
    const clumpType type("cell", cellDict("type none;"));
    Random random(7);
    clumpState s(type);
    disturb(type, s, 0.3, random);
    s.broken = scalarField({0, 1, 0});
    s.nodeForces = 1e-12*s.x;
    s.nodeForceRates = 3*s.nodeForces;

    OStringStream os;
    os.precision(17);
    os << s;
    IStringStream is(os.str());
    clumpState read;
    is >> read;

    CHECK(read.x == s.x);
    CHECK(read.u == s.u);
    CHECK(read.q == s.q);
    CHECK(read.w == s.w);
    CHECK(read.broken == s.broken);
    CHECK(read.a == s.a);
    CHECK(read.b == s.b);
    CHECK(read.nodeForces == s.nodeForces);
    CHECK(read.nodeForceRates == s.nodeForceRates);
}
