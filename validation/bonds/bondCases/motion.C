/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondCases.H"
#include "implicitEuler.H"
#include "velocityVerlet.H"
#include "Random.H"

using namespace Foam;

namespace
{

autoPtr<integrator> select(const char* text)
{
    return selectModel<integrator>(dictionary(IStringStream(text)()));
}


scalar energyOf(const bondedClump& clump, const clumpState& s)
{
    vectorField F(s.x.size()), T(s.x.size());
    return
        s.kineticEnergy(clump.type)
      + bondForces(clump.bonds, s).stepForces(s, 0, F, T);
}


dictionary cell(const string& damping)
{
    lineProperties l;
    l.EA = 91.4e-12;
    l.GA = 68.3e-12;    // in series with the bending of a bond
    l.EI = 12.9e-24;
    l.GJ = 10e-24;
    l.radius = 1.4756e-6;
    l.density = 1098;
    l.damping = damping;
    return ringOf(10, 2.4344e-6, l);
}


//- Give every sphere a velocity and an angular velocity of its own, without
//  moving the clump as a whole: positions are relative to it, as in the solver
void excite(const clumpType& type, clumpState& s, const scalar speed)
{
    Random random(5);
    forAll(s.u, i)
    {
        s.u[i] = speed*random.globalPosition(-vector::one, vector::one);
        s.w[i] =
            speed/type.radii()[i]
           *random.globalPosition(-vector::one, vector::one);
    }
    s.u -= s.velocity(type);
}

}


void Foam::motion(const label nSteps)
{
    // Undamped free flight with explicit steps
    {
        const bondedClump clump("cell", cell("type none;"));
        const clumpType& type = clump.type;
        const auto method(select("type velocityVerlet; stepFraction 1;"));
        const externalForces nothing(type.size());
        const auto& verlet = refCast<const integrators::velocityVerlet>(*method);
        const scalar dt =
            0.05*verlet.stableStep(clump.bonds, nothing, type.centres());

        clumpState s(type);
        excite(type, s, 0.01);
        const vector P(s.velocity(type)*type.mass());
        const vector L(s.angularMomentum(type));
        const scalar pScale = type.mass()*max(mag(s.u));
        const scalar first = energyOf(clump, s);

        // Means over the first and the last tenth: fluctuations cancel
        const label block = nSteps/10/100;
        scalar begin = 0, end = 0, worst = 0;
        for (label k = 0; k < nSteps/100; ++k)
        {
            for (label j = 0; j < 100; ++j)
            {
                verlet.advance(clump.bonds, nothing, dt, s);
            }
            const scalar E = energyOf(clump, s);
            worst = max(worst, mag(E/first - 1));
            begin += (k < block ? E/block : 0);
            end += (k >= nSteps/100 - block ? E/block : 0);
        }
        print("energy drift", nSteps, 10, (end - begin)/first);
        print("energy fluctuation", nSteps, 10, worst);
        print
        (
            "momentum drift", nSteps, 10,
            mag(s.velocity(type)*type.mass() - P)/pScale
        );
        print
        (
            "angular momentum drift", nSteps, 10,
            mag(s.angularMomentum(type) - L)/(pScale*type.reach())
        );
    }

    // Implicit steps of any size: energy never rises, momentum stays
    const auto euler
    (
        select("type implicitEuler; tolerance 1e-9; maxIterations 100;")
    );
    for (const scalar dt : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3})
    {
        const bondedClump clump("cell", cell("type dampingRatio; beta 1500;"));
        const clumpType& type = clump.type;
        const externalForces nothing(type.size());
        clumpState s(type);
        excite(type, s, 1e-3);
        for (point& x : s.x)
        {
            x.x() *= 1.3;
        }
        const vector L(s.angularMomentum(type));
        const scalar first = energyOf(clump, s);
        const scalar lScale = type.mass()*max(mag(s.u))*type.reach();
        scalar before = first, rise = 0;
        for (label k = 0; k < 300; ++k)
        {
            euler->advance(clump.bonds, nothing, dt, s);
            const scalar now = energyOf(clump, s);
            rise = max(rise, (now - before)/first);
            before = now;
        }
        print("implicit energy rise", dt, 300, rise);
        print
        (
            "implicit angular momentum drift", dt, 300,
            mag(s.angularMomentum(type) - L)/lScale
        );

        // Steps until the equilibrium under 100 pN is reached. The time constant is
        // ten steps, but at least about that of critical damping of the slowest
        // oscillation
        OStringStream damping;
        damping << "type kelvinVoigt; timeConstant " << max(10*dt, 1.5e-4) << ';';
        const bondedClump quick("cell", cell(damping.str()));
        const auto ext(equilibrium::stretch(quick.type, vector(1e-10, 0, 0)));
        clumpState still(quick.type), moving(quick.type);
        if (!equilibrium().find(quick.bonds, ext, still))
        {
            FatalErrorInFunction << "No equilibrium" << exit(FatalError);
        }
        for (label k = 0; k < 300000; ++k)
        {
            euler->advance(quick.bonds, ext, dt, moving);
            if (max(mag(moving.u))*dt < 1e-12*min(1.0, dt/1e-5)*quick.type.reach())
            {
                break;
            }
        }
        const auto diameter = [](const clumpState& c)
        {
            return mag(c.x[0] - c.x[5]);
        };
        print
        (
            "implicit equilibrium", dt, 10, diameter(moving)/diameter(still) - 1
        );
    }
}
