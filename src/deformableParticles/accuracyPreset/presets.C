/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "accuracyPreset.H"

const char* const Foam::accuracyPreset::text = R"(
models
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
}
draft
{
    measured        "";
    scene           { spheres 8; cellsPerDiameter 2.5; }
    $models;
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
            "U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-12; relTol 0.01; }
            "p.*" { solver GAMG; smoother GaussSeidel; tolerance 1e-10; relTol 0.05; }
        }
    }
    controlDict     { maxCo 2; maxDisplacement 0.5; maxDeltaT 2e-3; }
}
standard
{
    measured        "";
    scene           { spheres 10; cellsPerDiameter 4; }
    $models;
    fvSolution
    {
        PISO
        {
            consistent          yes;
            momentumPredictor   yes;
            nOuterCorrectors    2;
            nCorrectors         1;
            nNonOrthogonalCorrectors 0;
        }
        solvers
        {
            "U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-12; relTol 0.001; }
            "p.*" { solver GAMG; smoother GaussSeidel; tolerance 1e-10; relTol 0.01; }
        }
    }
    controlDict     { maxCo 1; maxDisplacement 0.25; maxDeltaT 1e-3; }
}
fine
{
    measured        "";
    scene           { spheres 16; cellsPerDiameter 8; }
    $models;
    fvSolution
    {
        PISO
        {
            consistent          yes;
            momentumPredictor   yes;
            nOuterCorrectors    3;
            nCorrectors         1;
            nNonOrthogonalCorrectors 1;
        }
        solvers
        {
            "U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-12; relTol 0.0001; }
            "p.*" { solver GAMG; smoother GaussSeidel; tolerance 1e-10; relTol 0.001; }
        }
    }
    controlDict     { maxCo 0.5; maxDisplacement 0.1; maxDeltaT 2.5e-4; }
}
)";
