/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Application
    bondCost

Description
    What unattached rings of ten spheres cost in processor time, one core:

        bondCost <rings> <explicit steps> <implicit steps>

    prints "case,value": million sphere-steps per second of the explicit
    integrator without and with damping, and microseconds per clump and step of
    the implicit one, for several time steps.
\*---------------------------------------------------------------------------*/

#include "integrator.H"
#include "velocityVerlet.H"
#include "equilibrium.H"
#include "StringStream.H"
#include "Random.H"
#include "cpuTime.H"
#include <cstdio>
#include <cstdlib>

using namespace Foam;

namespace
{

dictionary cell(const string& damping)
{
    return dictionary
    (
        IStringStream
        (
            "shape { type ring; nSpheres 10; diameter 7.82e-6;"
            " volume 94e-18; }"
            "density 1098; massModel union; motion free;"
            "bondModel { type elastic; rigidities { normal 91.4e-12;"
            " tangential 68.3e-12; bending 12.9e-24; torsional 10e-24; } }"
            "dampingModel { " + damping + " }"
        )()
    );
}


List<clumpState> rings(const clumpType& type, const label n)
{
    Random random(1);
    List<clumpState> result(n, clumpState(type));
    for (clumpState& s : result)
    {
        forAll(s.u, i)
        {
            s.u[i] = 1e-3*random.globalPosition(-vector::one, vector::one);
            s.w[i] =
                s.u[i].x()/type.radii()[i]
               *random.globalPosition(-vector::one, vector::one);
        }
    }
    return result;
}


autoPtr<integrator> select(const char* text)
{
    return selectModel<integrator>(dictionary(IStringStream(text)()));
}


void explicitCost
(
    const char* name,
    const string& damping,
    const label n,
    const label steps
)
{
    const bondedClump clump("cell", cell(damping));
    const clumpType& type = clump.type;
    const auto method(select("type velocityVerlet; stepFraction 0.5;"));
    const auto& verlet = refCast<const integrators::velocityVerlet>(*method);
    const externalForces nothing(type.size());
    const scalar dt = 0.5*verlet.stableStep(clump.bonds, nothing, type.centres());
    List<clumpState> clumps(rings(type, n));

    // The sub-steps of one fluid step
    const label nSub = 100;
    cpuTime timer;
    for (label k = 0; k < steps/nSub; ++k)
    {
        for (clumpState& s : clumps)
        {
            verlet.advance(clump.bonds, nothing, nSub*dt*0.999999, s);
        }
    }
    std::printf
    (
        "%s,%.6g\n", name,
        1e-6*(steps/nSub)*nSub*n*type.size()/timer.elapsedCpuTime()
    );
}


void implicitCost(const scalar dt, const label n, const label steps)
{
    const bondedClump clump("cell", cell("type dampingRatio; beta 1500;"));
    const clumpType& type = clump.type;
    const auto euler
    (
        select("type implicitEuler; tolerance 1e-9; maxIterations 100;")
    );
    const auto ext(equilibrium::stretch(type, vector(5e-11, 0, 0)));
    List<clumpState> clumps(rings(type, n));

    cpuTime timer;
    for (label k = 0; k < steps; ++k)
    {
        for (clumpState& s : clumps)
        {
            euler->advance(clump.bonds, ext, dt, s);
        }
    }
    std::printf
    (
        "implicit step %g s,%.6g\n", dt, 1e6*timer.elapsedCpuTime()/(steps*n)
    );
}

}


int main(int argc, char* argv[])
{
    const label n = argc > 1 ? label(std::atol(argv[1])) : 1000;
    const label explicitSteps = argc > 2 ? label(std::atol(argv[2])) : 1000;
    const label implicitSteps = argc > 3 ? label(std::atol(argv[3])) : 20;

    std::printf("case,value\n");
    explicitCost("explicit undamped", "type none;", n, explicitSteps);
    explicitCost
    (
        "explicit damped", "type dampingRatio; beta 0.1;", n, explicitSteps
    );
    for (const scalar dt : {1e-6, 1e-5, 1e-4, 1e-3})
    {
        implicitCost(dt, n, implicitSteps);
    }
    return 0;
}
