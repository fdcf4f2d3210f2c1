/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondCases.H"
#include "bondFrame.H"

using namespace Foam;

namespace
{

//- Equilibrium under loads that grow in steps
clumpState equilibriumOf
(
    const bondedClump& clump,
    const externalForces& ext,
    const label nSteps = 10
)
{
    clumpState s(clump.type);
    for (label k = 1; k <= nSteps; ++k)
    {
        externalForces part(ext);
        part.f *= scalar(k)/nSteps;
        part.t *= scalar(k)/nSteps;
        if (!equilibrium().find(clump.bonds, part, s))
        {
            FatalErrorInFunction
                << "No equilibrium at load step " << k << " of " << nSteps
                << exit(FatalError);
        }
    }
    return s;
}


//- Two cantilevers of length 1 back to back: deflection of the tips over the
//  middle under forces P at the tips
scalar cantilever(const label n, const scalar P, const string& bond)
{
    lineProperties l;
    l.EA = l.GA = 1e6;
    l.bond = bond;
    const bondedClump clump("line", chainOf(2*n + 1, 2, l));
    externalForces ext(clump.type.size());
    ext.f[0].y() = ext.f[2*n].y() = P;
    ext.f[n].y() = -2*P;
    const clumpState s(equilibriumOf(clump, ext));
    return s.x[0].y() - s.x[n].y();
}

}


void Foam::statics()
{
    for (const label n : {4, 8, 16, 32, 64})
    {
        for (const scalar a : {0.25, 1.0, 3.0, 10.0})
        {
            print("elastica elastic", a, n, cantilever(n, a, "elastic"));
            print("elastica timoshenko", a, n, cantilever(n, a, "timoshenko"));
        }
    }

    // Small load: growth of the loaded and shrink of the other diameter
    for (const label n : {8, 12, 16, 20, 24, 32, 64})
    {
        lineProperties l;
        l.EA = l.GA = 1e6;
        l.bond = "timoshenko";
        const bondedClump clump("line", ringOf(n, 1, l));
        const scalar P = 1e-3;
        const auto ext(equilibrium::stretch(clump.type, vector(P, 0, 0)));
        const clumpState s(equilibriumOf(clump, ext, 1));
        print("ring loaded", P, n, (mag(s.x[n/2] - s.x[0]) - 2)/P);
        if (n % 4 == 0)
        {
            print("ring other", P, n, (2 - mag(s.x[n/4] - s.x[3*n/4]))/P);
        }
    }

    // End torques: twist
    for (const label n : {8, 16, 32})
    {
        lineProperties l;
        l.EA = l.GA = 1e6;
        l.GJ = 0.5;
        const bondedClump clump("line", chainOf(n + 1, 1, l));
        externalForces ext(clump.type.size());
        ext.t[0].x() = -0.25;
        ext.t[n].x() = 0.25;
        const clumpState s(equilibriumOf(clump, ext, 1));
        print
        (
            "torsion", 0.25, n,
            mag(rotationVector(conjugate(s.q[0])*s.q[n]))
        );
    }

    // Straight beams: tip load, shear included, and tension
    for (const label n : {1, 4, 32})
    {
        lineProperties l;
        l.EA = 50;
        l.GA = 20;
        l.bond = "timoshenko";
        const bondedClump clump("line", chainOf(2*n + 1, 2, l));
        const scalar P = 1e-4;
        externalForces ext(clump.type.size());
        ext.f[0].y() = ext.f[2*n].y() = P;
        ext.f[n].y() = -2*P;
        const clumpState s(equilibriumOf(clump, ext, 1));
        print("timoshenko beam", P, n, (s.x[0].y() - s.x[n].y())/P);
    }
}
