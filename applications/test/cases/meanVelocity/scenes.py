"""Small flows that meanVelocityGradient drives.

    scenes.py write FOLDER      write a case per scene into the folder
    scenes.py judge FOLDER      compare the mean velocities and forces of the runs there
"""
import glob
import math
import os
import sys

from clumps import table

SIZE = 20e-6                    # edge of the box [m]
NU = 1e-6                       # of the Newtonian liquid [m2/s]
SPEED = 1e-4                    # most scenes [m/s]

LIQUIDS = {
    "Newtonian": "nu %g;" % NU,
    "powerLaw": "powerLawCoeffs { k [0 2 -1 0 0 0 0] 1e-4; n 0.5; nuMin 1e-9; nuMax 1e-3; }",
    "BirdCarreau": "BirdCarreauCoeffs { nu0 5.3e-5; nuInf 3.3e-6; k 3.313; n 0.3568; }",
    "CrossPowerLaw": "CrossPowerLawCoeffs { nu0 5.3e-5; nuInf 3.3e-6; m 1; n 0.9; }",
}
TYPES = """
    fixed { shape { type chain; nSpheres 1; sphereRadius 4e-6; } density 1000; motion fixed; }
    large { shape { type chain; nSpheres 1; sphereRadius 8.306e-6; } density 1000; motion fixed; }
    heavy { shape { type chain; nSpheres 1; sphereRadius 4e-6; } density 1100; }
    capsule
    {
        shape { type icosphere; radius 4e-6; subdivisions 2; }
        density 1000;
        viscosityRatio 5;
        membrane { strain { type neoHookean; shearModulus 5e-6; } }
    }"""


def drive(name, *U, frequency=0):
    velocity = "(%g %g %g)" % U
    if frequency:
        velocity = ("{ type sine; frequency %g; amplitude 1; scale %s; level (0 0 0); t0 0; }"
                    % (frequency, velocity))
    else:
        velocity += ";"
    return "%s { type meanVelocityGradient; Ubar %s }\n" % (name, velocity)


class Scene:
    """patches: in x, y and z; held: the components that are compared, with what they must be;
    frequency: of their sine, if they are not constant"""

    def __init__(self, patches="cyclic cyclic cyclic", n=10, dt=1e-4, steps=3, clump="", gravity=0,
                 liquid="Newtonian", start=0, held={0: SPEED, 1: 0, 2: 0}, sources=1, control="",
                 frequency=0):
        self.__dict__.update(locals())

    def wanted(self, d, time):
        return self.held[d]*(math.sin(2*math.pi*self.frequency*time) if self.frequency else 1)


ALONG = {0: SPEED}
CHANNEL = {0: 100*SPEED, 2: 0}
WALLS = "cyclic wall cyclic"
SCENES = {}
for liquid in "powerLaw", "BirdCarreau", "CrossPowerLaw":
    for dt in 1e-5, 1e-3:
        SCENES["%s%g" % (liquid, dt)] = Scene(WALLS, "3 16 3", dt, 4, liquid=liquid, held=CHANNEL)
SCENES["empty"] = Scene(WALLS, "3 16 3", held=CHANNEL)
# nu dt/dx^2 from 1 to 1000, from rest or not
for dt, start in (4e-6, 0), (2.5e-4, SPEED), (4e-3, 0):
    SCENES["fixed%g" % dt] = Scene(dt=dt, clump="fixed", start=start)
    SCENES["large%g" % dt] = Scene(dt=dt, clump="large")
    SCENES["settling%g" % dt] = Scene(
        dt=dt, clump="heavy", gravity=1000, held={0: 0, 1: 0, 2: 0})
SCENES["thinningAround"] = Scene(clump="fixed", liquid="BirdCarreau")
SCENES["membrane"] = Scene(WALLS, clump="capsule", held={0: SPEED, 2: 0})
SCENES["adjusted"] = Scene(
    WALLS, dt=1e-5, steps=100, clump="fixed", held={0: SPEED, 2: 0},
    control="#remove adjustTimeStep\nadjustTimeStep yes; maxCo 0.5; maxDeltaT 4e-4;")
SCENES["outlet"] = Scene("cyclic outlet cyclic", clump="fixed", held=ALONG)
SCENES["two"] = Scene(clump="fixed", held={0: SPEED, 2: SPEED/3}, sources=2)
# Forth and back, with a step at the end of which the mean velocity is zero
SCENES["pulsatingEmpty"] = Scene(WALLS, "3 16 3", 2.5e-3, 8, held={0: SPEED, 2: 0}, frequency=100)
SCENES["pulsatingOutlet"] = Scene("cyclic outlet cyclic", dt=2.5e-3, steps=5, clump="fixed",
                                  held=ALONG, frequency=100)
SCENES["pulsatingTwo"] = Scene(dt=2.5e-3, steps=5, clump="large", held={0: SPEED, 2: SPEED/3},
                               sources=2, frequency=100)
SCENES["pulsatingAdjusted"] = Scene(
    WALLS, dt=1e-4, steps=100, clump="heavy", held={0: SPEED, 2: 0}, frequency=100,
    control=SCENES["adjusted"].control)


def file(path, cls, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w") as out:
        out.write("FoamFile { version 2.0; format ascii; class %s; object %s; }\n%s\n"
                  % (cls, os.path.basename(path), text))


def write(case, scene):
    """system/fvSchemes and the like are those of the test box, which is there"""
    kinds = []
    for d, kind in enumerate(scene.patches.split()):
        pair = "xyz"[d] + "Low", "xyz"[d] + "High"
        kinds += zip(pair, reversed(pair), ["wall", "patch"] if kind == "outlet" else [kind]*2)
    faces = "0473", "1265", "0154", "3762", "0321", "4567"
    file(case + "/system/blockMeshDict", "dictionary", """
        scale 20e-6;
        vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));
        blocks (hex (0 1 2 3 4 5 6 7) (%s) simpleGrading (1 1 1));
        boundary (%s);""" % (
            "%d %d %d" % ((scene.n,)*3) if scene.n == 10 else scene.n,
            "\n".join("%s { type %s; %s faces ((%s)); }" % (
                name, kind, "neighbourPatch %s;" % other if kind == "cyclic" else "",
                " ".join(face)) for (name, other, kind), face in zip(kinds, faces))))
    U = {"cyclic": "type cyclic;", "wall": "type noSlip;", "patch": "type zeroGradient;"}
    p = {"cyclic": "type cyclic;", "wall": "type zeroGradient;",
         "patch": "type fixedValue; value uniform 0;"}
    for name, cls, dimensions, value, on in (
            ("U", "volVectorField", "[0 1 -1 0 0 0 0]", "(%g 0 0)" % scene.start, U),
            ("p", "volScalarField", "[0 2 -2 0 0 0 0]", "0", p)):
        file("%s/0/%s" % (case, name), cls, "dimensions %s; internalField uniform %s;\n"
             "boundaryField { %s }" % (dimensions, value, "\n".join(
                 "%s { %s }" % (patch, on[kind]) for patch, other, kind in kinds)))
    file(case + "/constant/transportProperties", "dictionary", "transportModel %s; rho 1000; %s"
         % (scene.liquid, LIQUIDS[scene.liquid]))
    file(case + "/constant/clumpProperties", "dictionary", "types { %s }\nplacement "
         "{ type list; clumps (%s); }" % (TYPES, scene.clump and (
             "{ type %s; position (10.1e-6 9.05e-6 9.93e-6); }" % scene.clump)))
    if scene.gravity:
        file(case + "/constant/g", "uniformDimensionedVectorField",
             "dimensions [0 1 -2 0 0 0 0]; value (%g 0 0);" % scene.gravity)
    file(case + "/constant/fvOptions", "dictionary",
         drive("a", scene.held[0], 0, 0, frequency=scene.frequency)
         + (drive("b", 0, 0, scene.held[2], frequency=scene.frequency)
            if scene.sources > 1 else ""))
    file(case + "/system/fvSolution", "dictionary", """
        solvers
        {
            "(p|pFinal)" { solver PCG; preconditioner DIC; tolerance 1e-12; relTol 1e-3; }
            "(U|UFinal)"
            { solver PBiCGStab; preconditioner DILU; tolerance 1e-12; relTol 1e-4; }
        }
        PISO { pRefCell 0; pRefValue 0; }""")
    each = "writeControl timeStep; writeInterval 1;"
    file(case + "/system/controlDict", "dictionary", """
        application rbcIbFoam; startFrom latestTime; startTime 0; stopAt endTime;
        endTime %.10g; deltaT %g; writeControl timeStep; writeInterval 1000;
        writePrecision 14; timePrecision 10; adjustTimeStep no; %s
        functions
        {
            clumpForce { type clumpForce; libs ("libdeformableParticles.so"); %s }
            drivingGradient { type drivingGradient; libs ("libdeformableParticles.so"); %s }
            mean
            {
                type volFieldValue; libs ("libfieldFunctionObjects.so"); regionType all;
                fields (U); operation volAverage; writeFields no; log no; %s
            }
        }""" % (scene.dt*scene.steps, scene.dt, scene.control, each, each, each))


def means(case):
    """Time and mean velocity of every step"""
    path, = glob.glob(case + "/postProcessing/mean/0/volFieldValue.dat")
    with open(path) as file_:
        rows = [line.replace("(", " ").replace(")", " ").split()
                for line in file_ if line[0] != "#"]
    return [(float(row[0]), [float(u) for u in row[1:]]) for row in rows]


def check(name, value, least, most, unit):
    good = least <= value <= most
    print("%-24s %.6g %s%s" % (name, value, unit, "" if good else
                               ", not between %g and %g" % (least, most)))
    return good


def judge(folder):
    good = True
    for name, scene in SCENES.items():
        case = os.path.join(folder, name)
        rows = means(case)
        # Where nothing is to move, of the velocity of a sphere that settles alone
        size = max(map(abs, scene.held.values())) or 3*SPEED
        worst = max(abs(row[d] - scene.wanted(d, time)) for time, row in rows for d in scene.held)
        good &= check(name, worst/size, 0, 1e-6, "of Ubar missed in %d steps" % len(rows))
        history = table(case, "drivingGradient")
        good &= len(history) == len(rows) > 2
        for row, (time, mean) in zip(history, rows):
            good &= all(abs(row["U" + "xyz"[d]] - mean[d]) < 1e-9*size for d in range(3))

    # Hasimoto (1959), J. Fluid Mech. 5, 317
    phi = 4/3*math.pi*4e-6**3/SIZE**3
    alone = 6*math.pi*1e-3*4e-6
    K = 1/(1 - 1.7601*phi**(1/3) + phi - 1.5593*phi**2)
    fixed = table(os.path.join(folder, "fixed0.004"), "clumpForce")
    for row in fixed[:2]:
        good &= check("drag in %g s" % row["time"], row["Fx"]/(alone*K*SPEED), 0.95, 1.05,
                      "of Hasimoto's")
    weight = 4/3*math.pi*4e-6**3*100*1000
    for row in table(os.path.join(folder, "settling0.004"), "clumpForce")[:2]:
        good &= check("velocity in %g s" % row["time"], row["Ux"]*alone*K/weight, 0.95, 1.05,
                      "of Hasimoto's")
    # The gradient balances the force on the sphere
    last = table(os.path.join(folder, "fixed0.004"), "drivingGradient")[-1]
    good &= check("gradient", 1000*last["Gx"]*SIZE**3/fixed[-1]["Fx"], 0.99, 1.01,
                  "of the force on the sphere")
    return good


if sys.argv[1] == "write":
    for name, scene in SCENES.items():
        write(os.path.join(sys.argv[2], name), scene)
        print(name)
else:
    sys.exit(0 if judge(sys.argv[2]) else 1)
