/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "accuracyPreset.H"

const char* const Foam::accuracyPreset::text = R"(
common
{
    clumpProperties
    {
        rotation        { type wholeClump; }
        couplingScheme  { type robin; coefficient 1; }
        immersedBoundary
        {
            solidFraction   { type signedDistance; }
            forcing         { type sharp; }
            hydrodynamicForce { type momentumExchange; }
            interiorDilation yes;
        }
    }
    fvSolution
    {
        PISO
        {
            consistent          yes;
            momentumPredictor   yes;
            nOuterCorrectors    1;
            nCorrectors         1;
            nNonOrthogonalCorrectors 0;
        }
        solvers
        {
            "U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-12; relTol 0.001; }
            "p.*" { solver GAMG; smoother GaussSeidel; tolerance 1e-10; relTol 0.01; }
        }
    }
}
draft
{
    measured        "tethered cell: drag 0.5 % off, 14 s per simulated second; free cell: rotation 4.8 %, 5 s";
    scene           { spheres 8; cellsPerDiameter 3; }
    $common;
    fvSolution
    {
        solvers { "U.*" { relTol 0.01; } "p.*" { relTol 0.05; } }
    }
    controlDict     { maxCo 5; maxDisplacement 0.25; maxDeltaT 4e-3; }
}
standard
{
    measured        "tethered cell: drag 0.2 % off, 50 s per simulated second; free cell: rotation 1.8 %, 25 s";
    scene           { spheres 10; cellsPerDiameter 4; }
    $common;
    controlDict     { maxCo 5; maxDisplacement 0.1; maxDeltaT 4e-3; }
}
fine
{
    measured        "tethered cell: drag 0.1 % off, 430 s per simulated second; free cell: rotation 0.7 %, 190 s";
    scene           { spheres 10; cellsPerDiameter 6; }
    $common;
    controlDict     { maxCo 5; maxDisplacement 0.05; maxDeltaT 2e-3; }
}
)";
