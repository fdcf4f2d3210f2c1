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
        rotation        { type clump; }
        exchange        { type robin; margin 1; }
        immersedBoundary
        {
            solidFraction   { type tetClipping; }
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
    measured        "drag on the tethered cell 0.4 % off, shape 1.5 %; 25 processor seconds per simulated second";
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
    measured        "drag on the tethered cell 0.3 % off; 266 processor seconds per simulated second";
    scene           { spheres 10; cellsPerDiameter 4; }
    $common;
    controlDict     { maxCo 5; maxDisplacement 0.1; maxDeltaT 4e-3; }
}
fine
{
    measured        "drag on the tethered cell 0.0 % off; 1560 processor seconds per simulated second";
    scene           { spheres 10; cellsPerDiameter 6; }
    $common;
    controlDict     { maxCo 5; maxDisplacement 0.05; maxDeltaT 2e-3; }
}
)";
