#!/usr/bin/env python3
"""Drag of a sphere of 5 um in the middle of a box of 30 x 20 x 20 um whose walls move along it, on
a mesh that is fitted to the sphere, by simpleFoam on a quarter of the box. With 12 and 18 cells
along a quarter of a great circle, extrapolated to none with the second power of their size.

    . ../../../bin/openfoam-env; foamEnvironment; python3 drag.py > drag.csv     # 5 minutes
"""

import os
import subprocess
import sys
import tempfile

R = 2.5
BLOOD = "BirdCarreau; BirdCarreauCoeffs { nu0 5.28e-5; nuInf 3.25e-6; k 3.313; n 0.3568; }"
POWER = "powerLaw; powerLawCoeffs { k %.8g; n %g; nuMin 1e-9; nuMax 0.1; }"
CASES = [("newtonian", "Newtonian; nu 1e-5;", 1e-2)]
CASES += [(f"power{n}", POWER % (1e-5*1000**(1 - n), n), 1e-2) for n in (0.8, 0.5)]
CASES += [("blood", BLOOD, velocity) for velocity in (4e-6, 4e-5, 4e-4)]

# Corners of half a cube's upper quarter: on the sphere, then on the box
CORNERS = [(x, y, z) for x in (-1, 1) for y in (0, 1) for z in (0, 1)]
SIDES = {"inlet": [(-1, 0, 0), (-1, 0, 1), (-1, 1, 1), (-1, 1, 0)],
         "outlet": [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)],
         "sides": [(-1, 1, 0), (-1, 1, 1), (1, 1, 1), (1, 1, 0)],
         "top": [(-1, 0, 1), (1, 0, 1), (1, 1, 1), (-1, 1, 1)]}


def labels(corners, out=0):
    """The numbers of corners on the sphere, or with out = 8 on the box."""
    return [CORNERS.index(c) + out for c in corners]


def face(numbers):
    return "(" + " ".join(str(i) for i in numbers) + ")"


def block_mesh(n):
    """Four blocks between the sphere and the box, n cells along its length."""
    vertices, blocks, edges = [], [], set()
    planes = {1: [], 2: []}
    for c in CORNERS:
        length = sum(x*x for x in c)**0.5
        vertices.append("(%.12g %.12g %.12g)" % tuple(R*x/length for x in c))
    vertices += ["(%g %g %g)" % (15*x, 10*y, 10*z) for x, y, z in CORNERS]
    for side in SIDES.values():
        cells = [n if side[i][0] != side[i + 1][0] else n//2 for i in (0, 1)]
        blocks.append(f"hex {face(labels(side) + labels(side, 8))} "
                      f"({cells[0]} {cells[1]} {3*n//2}) simpleGrading (1 1 12)")
        for a, b in zip(side, side[1:] + side[:1]):
            edges.add("project %d %d (sphere)" % tuple(sorted(labels([a, b]))))
            for axis in planes:
                if a[axis] == 0 and b[axis] == 0:
                    planes[axis].append(face(labels([a, b]) + labels([b, a], 8)))
    inner = [face(labels(side)) for side in SIDES.values()]
    outer = {name: face(labels(side, 8)) for name, side in SIDES.items()}
    return f"""scale 1e-6;
geometry {{ sphere {{ type searchableSphere; centre (0 0 0); radius {R}; }} }}
vertices ({" ".join(vertices)});
blocks ({" ".join(blocks)});
edges ({" ".join(sorted(edges))});
faces ({" ".join(f"project {f} sphere" for f in inner)});
boundary
(
    sphere {{ type wall; faces ({" ".join(inner)}); }}
    box {{ type wall; faces ({" ".join(outer.values())}); }}
    y0 {{ type symmetryPlane; faces ({" ".join(planes[1])}); }}
    z0 {{ type symmetryPlane; faces ({" ".join(planes[2])}); }}
);
"""


def drag(transport, velocity, n):
    """The drag on the whole sphere [N]."""
    files = {
        "system/blockMeshDict": block_mesh(n),
        "constant/transportProperties": f"transportModel {transport}",
        "constant/turbulenceProperties": "simulationType laminar;",
        "0/U": f"""dimensions [0 1 -1 0 0 0 0]; internalField uniform ({velocity} 0 0);
boundaryField
{{
    sphere {{ type noSlip; }}
    box {{ type fixedValue; value uniform ({velocity} 0 0); }}
    "y0|z0" {{ type symmetryPlane; }}
}}""",
        "0/p": """dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField { "sphere|box" { type zeroGradient; } "y0|z0" { type symmetryPlane; } }""",
        "system/controlDict": """application simpleFoam; startFrom startTime; startTime 0;
stopAt endTime; endTime 1000; deltaT 1; writeControl timeStep; writeInterval 1000;
functions
{
    forces
    {
        type forces; libs ("libforces.so"); patches (sphere); rho rhoInf; rhoInf 1000;
        CofR (0 0 0); writeControl timeStep; writeInterval 1;
    }
}""",
        "system/fvSchemes": """ddtSchemes { default steadyState; }
gradSchemes { default Gauss linear; grad(U) leastSquares; }
divSchemes
{
    default none; div(phi,U) Gauss linear; div((nuEff*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }""",
        "system/fvSolution": """solvers
{
    p { solver GAMG; smoother GaussSeidel; tolerance 0; relTol 0.01; }
    U { solver PBiCGStab; preconditioner DILU; tolerance 0; relTol 0.01; }
}
SIMPLE
{
    consistent yes; nNonOrthogonalCorrectors 1; pRefCell 0; pRefValue 0;
    residualControl { p 1e-6; U 1e-7; }
}
relaxationFactors { equations { U 0.7; } fields { p 0.5; } }"""}
    with tempfile.TemporaryDirectory() as case:
        for name, text in files.items():
            kind = {"U": "volVectorField", "p": "volScalarField"}.get(name[2:], "dictionary")
            os.makedirs(os.path.dirname(f"{case}/{name}"), exist_ok=True)
            with open(f"{case}/{name}", "w") as file:
                file.write(f"FoamFile {{ version 2.0; format ascii; class {kind}; "
                           f"object {os.path.basename(name)}; }}\n{text}\n")
        for program in ("blockMesh", "simpleFoam"):
            subprocess.run([program], cwd=case, stdout=subprocess.DEVNULL, check=True)
        with open(f"{case}/postProcessing/forces/0/force.dat") as file:
            total = file.readlines()[-1].split("(")[1]
    return 4*float(total.split()[0])


if __name__ == "__main__":
    if sys.argv[1:]:
        sys.exit(__doc__)
    print("# " + __doc__.strip().split("\n\n")[0].replace("\n", "\n# "))
    print("liquid,velocity_m_s,drag_12_N,drag_18_N,drag_N")
    for liquid, model, speed in CASES:
        coarse, fine = (drag(model, speed, n) for n in (12, 18))
        best = fine + (fine - coarse)/(1.5**2 - 1)
        print(f"{liquid},{speed:g},{coarse:.6g},{fine:.6g},{best:.6g}", flush=True)
