#!/usr/bin/env python3
"""Drag of a sphere of 5 um and mean velocity of the flow past it, on a mesh that is fitted to the
sphere, by simpleFoam on a quarter of the flow. With 12 and 18 cells along a quarter of a great
circle, extrapolated to none with the second power of their size.

    box           in the middle of 30 x 20 x 20 um, whose walls move along it
    array-0.1     of a periodic simple cubic array of this solid fraction; likewise array-0.2
    plates        in the middle between plates, 15 um apart, of an array of 20 x 15 um
    narrow        likewise, plates 10 um apart, and an array of 20 x 10 um
    duct          in the middle of a duct of 10 x 10 um, every 20 um

A pressure gradient drives the flow in all but the box. It is given, and velocity_m_s is the mean
over liquid and sphere. The drag contains the force of this gradient on the sphere's volume.

    . ../../../bin/openfoam-env; foamEnvironment; python3 drag.py > drag.csv     # 15 minutes
    python3 drag.py plates      # the rows of one scene
"""

import math
import os
import subprocess
import sys
import tempfile

R = 2.5
BLOOD = "BirdCarreau; BirdCarreauCoeffs { nu0 5.28e-5; nuInf 3.25e-6; k 3.313; n 0.3568; }"
POWER = "powerLaw; powerLawCoeffs { k %.8g; n %g; nuMin 1e-9; nuMax 0.1; }"
NEWTONIAN = ("newtonian", "Newtonian; nu 1e-5;")
POWERS = [(f"power{n}", POWER % (1e-5*1000**(1 - n), n)) for n in (0.8, 0.5)]


class Scene:
    """Half the lengths of the box around the sphere and the length of a straight piece at both ends
    of it [um], the patches of the sides, for each run the liquid, its model and the velocity of the
    walls [m/s] or the gradient [m/s2], and the relaxation factors of U and p."""

    def __init__(self, half, ends, sides, runs, radial=1, grading=3, relaxation=(0.98, 0.9)):
        self.half, self.ends, self.sides, self.runs = half, ends, sides, runs
        self.radial, self.grading, self.relaxation = radial, grading, relaxation

    @property
    def driven(self):
        return "moving" not in self.sides.values()


def array(fraction, gradient, *models):
    half = R*(math.pi/6/fraction)**(1/3)
    sides = {"inlet": "cyclic", "outlet": "cyclic", "sides": "mirror", "top": "mirror"}
    return Scene([half]*3, 0, sides, [(*model, gradient) for model in models])


def channel(half, top, *runs):
    sides = {"inlet": "cyclic", "outlet": "cyclic", "sides": "noSlip", "top": top}
    return Scene([half, half, half], 10 - half, sides, list(runs))


def in_blood(gradient):
    return "blood", BLOOD, gradient


SCENES = {
    "box": Scene([15, 10, 10], 0, dict.fromkeys(["inlet", "outlet", "sides", "top"], "moving"),
                 [(*model, 1e-2) for model in (NEWTONIAN, *POWERS)]
                 + [("blood", BLOOD, velocity) for velocity in (4e-6, 4e-5, 4e-4)],
                 1.5, 12, (0.7, 0.5)),
    "array-0.1": array(0.1, 3e4, NEWTONIAN, *POWERS),
    "array-0.2": array(0.2, 1e5, NEWTONIAN, POWERS[1]),
    "plates": channel(7.5, "mirror", (*NEWTONIAN, 40), in_blood(20)),
    "narrow": channel(5, "mirror", (*NEWTONIAN, 80), in_blood(20), in_blood(80), in_blood(500)),
    "duct": channel(5, "noSlip", (*NEWTONIAN, 80), in_blood(80))}

# Corners of half a cube's upper quarter: on the sphere, then on the box and at its ends
CORNERS = [(x, y, z) for x in (-1, 1) for y in (0, 1) for z in (0, 1)]
SIDES = {"inlet": [(-1, 0, 0), (-1, 0, 1), (-1, 1, 1), (-1, 1, 0)],
         "outlet": [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)],
         "sides": [(-1, 1, 0), (-1, 1, 1), (1, 1, 1), (1, 1, 0)],
         "top": [(-1, 0, 1), (1, 0, 1), (1, 1, 1), (-1, 1, 1)]}


def labels(corners, out=0):
    """The numbers of corners on the sphere, with out = 8 on the box, with 16 at its ends."""
    return [CORNERS.index(c) + out for c in corners]


def face(numbers):
    return "(" + " ".join(str(i) for i in numbers) + ")"


def block_mesh(scene, n):
    """Four blocks between the sphere and the box, n cells along its length, and its ends."""
    vertices, blocks, edges = [], [], set()
    patches = {name: [] for name in ("sphere", "y0", "z0", *SIDES)}
    for c in CORNERS:
        length = sum(x*x for x in c)**0.5
        vertices.append("(%.12g %.12g %.12g)" % tuple(R*x/length for x in c))
    for out in 0, scene.ends:
        vertices += ["(%.12g %.12g %.12g)" % (
            c[0]*(scene.half[0] + out), c[1]*scene.half[1], c[2]*scene.half[2]) for c in CORNERS]
    for name, side in SIDES.items():
        cells = [n if side[i][0] != side[i + 1][0] else n//2 for i in (0, 1)]
        blocks.append(f"hex {face(labels(side) + labels(side, 8))} ({cells[0]} {cells[1]} "
                      f"{int(scene.radial*n)}) simpleGrading (1 1 {scene.grading})")
        extended = scene.ends > 0 and name in ("inlet", "outlet")
        if extended:
            blocks.append(f"hex {face(labels(side, 8) + labels(side, 16))} ({cells[0]} {cells[1]} "
                          f"{round(n/2*scene.ends/scene.half[1])}) simpleGrading (1 1 1)")
        patches["sphere"].append(face(labels(side)))
        patches[name].append(face(labels(side, 16 if extended else 8)))
        for a, b in zip(side, side[1:] + side[:1]):
            edges.add("project %d %d (sphere)" % tuple(sorted(labels([a, b]))))
            for axis, planes in (1, ("y0", "sides")), (2, ("z0", "top")):
                if a[axis] == b[axis]:
                    if a[axis] == 0:
                        patches[planes[0]].append(face(labels([a, b]) + labels([b, a], 8)))
                    if extended:
                        patches[planes[a[axis]]].append(
                            face(labels([a, b], 8) + labels([b, a], 16)))
    kinds = {"mirror": "type symmetryPlane", "cyclic": "type cyclic; neighbourPatch "}
    boundary = ""
    for name, faces in patches.items():
        kind = kinds.get("mirror" if name in ("y0", "z0") else scene.sides.get(name), "type wall")
        if "cyclic" in kind:
            kind += "outlet" if name == "inlet" else "inlet"
        boundary += f"    {name} {{ {kind}; faces ({' '.join(faces)}); }}\n"
    return f"""scale 1e-6;
geometry {{ sphere {{ type searchableSphere; centre (0 0 0); radius {R}; }} }}
vertices ({" ".join(vertices)});
blocks ({" ".join(blocks)});
edges ({" ".join(sorted(edges))});
faces ({" ".join(f"project {f} sphere" for f in patches["sphere"])});
boundary
(
{boundary});
"""


def boundaries(scene, kinds):
    """The entries of a field for the sides of the box."""
    return " ".join(f"{name} {{ {kinds.get(side, 'type ' + side + ';')} }}"
                    for name, side in scene.sides.items())


def solve(scene, transport, drive, n):
    """The mean velocity [m/s] and the drag on the whole sphere [N]."""
    gradient, velocity = (drive, 0) if scene.driven else (0, drive)
    files = {
        "system/blockMeshDict": block_mesh(scene, n),
        "constant/transportProperties": f"transportModel {transport}",
        "constant/turbulenceProperties": "simulationType laminar;",
        "0/U": f"""dimensions [0 1 -1 0 0 0 0]; internalField uniform ({velocity} 0 0);
boundaryField
{{
    sphere {{ type noSlip; }}
    {boundaries(scene, {"moving": f"type fixedValue; value uniform ({velocity} 0 0);",
                        "mirror": "type symmetryPlane;"})}
    "y0|z0" {{ type symmetryPlane; }}
}}""",
        "0/p": f"""dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField
{{
    sphere {{ type zeroGradient; }}
    {boundaries(scene, {"moving": "type zeroGradient;", "noSlip": "type zeroGradient;",
                        "mirror": "type symmetryPlane;"})}
    "y0|z0" {{ type symmetryPlane; }}
}}""",
        "constant/fvOptions": f"""drive
{{
    type vectorSemiImplicitSource; selectionMode all; volumeMode specific;
    injectionRateSuSp {{ U (({gradient} 0 0) 0); }}
}}""",
        "system/controlDict": """application simpleFoam; startFrom startTime; startTime 0;
stopAt endTime; endTime 3000; deltaT 1; writeControl timeStep; writeInterval 3000;
functions
{
    forces
    {
        type forces; libs ("libforces.so"); patches (sphere); rho rhoInf; rhoInf 1000;
        CofR (0 0 0); writeControl timeStep; writeInterval 1;
    }
    flow
    {
        type volFieldValue; libs ("libfieldFunctionObjects.so"); regionType all;
        operation volIntegrate; fields (U); writeFields no;
        writeControl timeStep; writeInterval 1;
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
"""
        "relaxationFactors { equations { U %g; } fields { p %g; } }" % scene.relaxation}
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
            force = 4*float(file.readlines()[-1].split("(")[1].split()[0])
        with open(f"{case}/postProcessing/flow/0/volFieldValue.dat") as file:
            flow = float(file.readlines()[-1].split("(")[1].split()[0])
    if scene.driven:
        velocity = flow/(2e-18*scene.half[1]*scene.half[2]*(scene.half[0] + scene.ends))
    return velocity, force + 1000*gradient*4/3*math.pi*(1e-6*R)**3


def extrapolated(coarse, fine):
    return fine + (fine - coarse)/(1.5**2 - 1)


if __name__ == "__main__":
    if not set(sys.argv[1:]) <= set(SCENES):
        sys.exit(__doc__)
    for line in __doc__.strip().split("\n\n    .")[0].split("\n"):
        print(f"# {line}".rstrip())
    print("scene,liquid,gradient_m_s2,velocity_12_m_s,velocity_18_m_s,velocity_m_s,"
          "drag_12_N,drag_18_N,drag_N")
    for name in sys.argv[1:] or SCENES:
        for liquid, model, drive in SCENES[name].runs:
            pairs = list(zip(*(solve(SCENES[name], model, drive, n) for n in (12, 18))))
            row = [f"{v:.6g}" for pair in pairs for v in (*pair, extrapolated(*pair))]
            gradient = f"{drive:g}" if SCENES[name].driven else "0"
            print(",".join([name, liquid, gradient, *row]), flush=True)
