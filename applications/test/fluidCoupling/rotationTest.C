/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "rotationModel.H"

using namespace Foam;

namespace
{

autoPtr<rotationModel> rotationOf(const word& type)
{
    dictionary dict;
    dict.add("type", type);
    return selectModel<rotationModel>(dict);
}

}


TEST_CASE("rotation: a rigid motion is imposed exactly", "[rotation][serial]")
{
    const clumpType type("cell", cellDict());
    Random random(12);
    clumpState s(type, randomRotation(random));
    const point centre(s.centre(type));
    const vector u(1e-3, 2e-3, -1e-3);

    // The ring's axis, about which rotation is in its plane
    const vector axis(normalised((s.x[0] - centre) ^ (s.x[2] - centre)));
    const bool inPlane = GENERATE(true, false);
    const vector omega(inPlane ? 80*axis : vector(80, -30, 50));
    s.setRigidMotion(type, u, omega);

    const auto error = [&](const word& model)
    {
        const vectorField omegas(rotationOf(model)->angularVelocities(type, s));
        scalar worst = 0;
        forAll(omegas, i)
        {
            const point x(s.x[i] + type.radii()[i]*randomVector(random));
            const vector imposed(s.u[i] + (omegas[i] ^ (x - s.x[i])));
            const vector exact(u + (omega ^ (x - centre)));
            worst = max(worst, mag(imposed - exact)/mag(exact));
        }
        return worst;
    };

    CHECK(error("wholeClump") < 1e-12);

    // Eq. 13 is exact in the plane and not for tumbling
    CHECK((error("perSphere") < 1e-12) == inPlane);
}


TEST_CASE("rotation: single sphere and straight chain", "[rotation][serial]")
{
    dictionary dict(cellDict());
    dict.set
    (
        "shape",
        dictOf
        (
            GENERATE(true, false)
          ? "type chain; nSpheres 1; sphereRadius 1e-6;"
          : "type chain; nSpheres 4; spacing 1.5e-6; sphereRadius 1e-6;"
        )
    );
    const clumpType type("chain", dict);
    clumpState s(type);
    const vector omega(10, 20, 30);
    s.setRigidMotion(type, Zero, omega);

    const vectorField found(rotationOf("wholeClump")->angularVelocities(type, s));
    CHECK(max(mag(found - omega)) < 1e-10*mag(omega));
}


TEST_CASE("rotation: forces are the transpose of velocities", "[rotation][adjoint][serial]")
{
    const word model = GENERATE(word("perSphere"), word("wholeClump"));
    const clumpType type("cell", cellDict());
    const label n = type.size();
    Random random(13);

    clumpState s(type);
    disturb(type, s, 0.3, random);
    if (GENERATE(true, false))
    {
        // One sphere next to the centre
        s.x[0] = s.centre(type) + 0.01*type.radii()[0]*randomVector(random);
    }

    vectorField fluidTorques(n), f(n, Zero), t(n, Zero);
    for (vector& torque : fluidTorques)
    {
        torque = 1e-18*randomVector(random);
    }

    const autoPtr<rotationModel> rotation(rotationOf(model));
    rotation->transpose(type, s, fluidTorques, f, t);
    const vectorField omegas(rotation->angularVelocities(type, s));

    const scalar power = sum(f & s.u) + sum(t & s.w);
    const scalar expected = sum(fluidTorques & omegas);
    const scalar scale = sum(mag(fluidTorques)*mag(s.w)) + VSMALL;
    CHECK(mag(power - expected) < 1e-12*scale);

    // A couple has no net force
    CHECK(mag(sum(f)) < 1e-12*(sum(mag(f)) + VSMALL));
}


TEST_CASE("rotation: a sphere near the centre gets no more than the others", "[rotation][serial]")
{
    // Five spheres in a row, the middle one off the centre and pushed away from the line
    dictionary dict(cellDict());
    dict.set
    (
        "shape",
        dictOf("type chain; nSpheres 5; spacing 1.5e-6; sphereRadius 1e-6;")
    );
    const clumpType type("chain", dict);
    const scalar a = type.radii()[2];
    const scalar speed = 1e-3;

    const auto angular = [&](const scalar distance)
    {
        clumpState s(type);
        const point centre(s.centre(type));
        const vector along(normalised(s.x[4] - s.x[0]));
        s.x[2] = centre + distance*along;
        s.u[2] = speed*normalised(along ^ vector(1, 2, 3));
        const vector r(s.x[2] - s.centre(type));
        const vector u(s.u[2] - s.velocity(type));
        const vector found
        (
            rotationOf("perSphere")->angularVelocities(type, s)[2]
        );
        // Eq. 13 farther than its radius from the centre
        if (mag(r) > a)
        {
            CHECK(mag(found - (r ^ u)/magSqr(r)) < 1e-12*mag(found));
        }
        return mag(found);
    };

    for (scalar d = -3*a; d < 3*a; d += 0.01*a)
    {
        CHECK(a*angular(d) < 1.25*speed);

        // Smooth
        CHECK(mag(angular(d + 0.01*a) - angular(d)) < 0.05*speed/a);
    }
    CHECK(a*angular(1e-5*a) < 1e-3*speed);
}
