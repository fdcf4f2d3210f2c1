/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "integrator.H"
#include "bondForces.H"
#include "mathematicalConstants.H"

using namespace Foam;


TEST_CASE("breakage: a bond breaks at its strength and not before", "[breakage][serial]")
{
    const string method = GENERATE
    (
        "type implicitEuler; tolerance 1e-9; maxIterations 100;",
        "type velocityVerlet; stepFraction 0.2;"
    );
    const bool breakable = GENERATE(true, false);

    // Two spheres of radius 1 um: strength 1000 Pa times pi um2 is 3.14 nN
    const bondedClump clump
    (
        "pair",
        dictOf
        (
            "shape { type chain; nSpheres 2; spacing 2e-6; sphereRadius 1e-6; }"
            "density 1000; massModel union; motion free;"
            "bondModel { type elastic; rigidities { normal 1e-7;"
            " tangential 1e-7; bending 1e-19; torsional 1e-19; }"
          + string
            (
                breakable ? "breakage { normalStress 1e3; shearStress 1e3; }" : ""
            )
          + "} dampingModel { type kelvinVoigt; timeConstant 1e-5; }"
        )
    );
    const clumpType& type = clump.type;
    const auto integrator(selectModel<Foam::integrator>(dictOf(method)));
    const scalar strength = 1e3*constant::mathematical::pi*1e-12;
    clumpState s(type);

    const auto pull = [&](const scalar force)
    {
        externalForces ext(2);
        ext.f[1].x() = force;
        ext.f[0].x() = -force;
        for (label k = 0; k < 20; ++k)
        {
            integrator->advance(clump.bonds, ext, 1e-5, s);
        }
        return mag(s.x[1] - s.x[0]);
    };

    const scalar held = pull(0.95*strength);
    CHECK(held == Approx(2e-6*(1 + 0.95*strength/1e-7)).epsilon(1e-3));
    CHECK(s.broken.empty());

    const scalar over = pull(1.1*strength);
    CHECK((over > 2*held) == breakable);

    if (breakable)
    {
        CHECK(s.broken[0] == 1);

        // For good: brought together again the spheres do not hold
        vectorField F(2), T(2);
        s.x[1] = s.x[0] + vector(1e-6, 0, 0);
        CHECK(bondForces(clump.bonds, s).explicitForces(s, F, T) == 0);
        CHECK(max(mag(F)) == 0);
    }
}
