"""The features of the scenes, what they write into a case, and what excludes what.

FEATURES has a factor a line group, with the function that writes each level into a Scene. A new
level or a new factor is one line there; what it cannot be combined with is one line in FORBIDDEN.

The scene: clumps of spheres of 4 um in 20 x 16 x 16 um, close to each other and to the wall below,
or across the periodic boundaries. Forces that add up to zero pull the bodies apart.
"""

from math import pi, tan, radians

import solutes

LENGTHS = (20, 16, 16)                  # um
SPEED = 2e-3                            # m/s, of walls and streams
PULL = 2e-11                            # N
GRAVITY = (300, -1000, 200)             # m/s2, of a centrifuge
RHO, NU = 1000, 1e-6                    # of the fluid
RADIUS = 2e-6                           # of the spheres
END = 2e-3                              # s, 20 steps of 1e-4 s, written four times
SHIFT = (9.3, 5.1, 9.1)                 # um, of the bodies where the boundaries are periodic

# Bodies that bounce fly in a thin gas, whose drag takes up 2 % of their speed in a step, and 8 %
# of that of the light ones
GAS = 0.2                              # kg/m3
FLIGHT = 0.02                           # m/s, a radius in a step
OFFSET = 0.5                            # um, of two spheres that meet

EACH = "writeControl timeStep; writeInterval 1;"
FIELD = 'libs ("libfieldFunctionObjects.so"); log no; writeFields no; ' + EACH


class Scene:
    """Files of a case as texts; what is added later overrides what stands before."""

    def __init__(self, row, nudge=0, withSolutes=True):
        self.row = row
        self.nudge = nudge*RADIUS*1e6   # of all clumps, along (1 1 1) [um]
        self.files = {}
        self.utilities = ["blockMesh"]  # in this order
        self.patches = {}               # of each side, x0 to z1: "wall", "cyclic", "cyclicAMI",
                                        # "patch" or "symmetryPlane"
        self.shear = 0                  # x per y of the mesh
        self.density = float(row["density"])
        self.rho = RHO                  # of the fluid
        self.gravity = GRAVITY          # where it is on
        self.pull = PULL
        self.starts = []                # type and velocity with which each clump begins
        self.types = []
        self.common()
        for factor, levels in FEATURES.items():
            levels[row[factor]](self)
        if withSolutes and solutes.possible(self):
            solutes.add(self)

    def add(self, name, text):
        self.files[name] = self.files.get(name, "") + text + "\n"

    def drag(self):
        """Of a sphere [N s/m]"""
        return 6*pi*NU*self.rho*RADIUS

    def periodic(self, direction):
        return self.patches["xyz"[direction] + "0"].startswith("cyclic")

    def common(self):
        for name in ("constant/clumpProperties", "system/fvSolution", "system/controlDict"):
            self.add(name, '#include "$WM_PROJECT_USER_DIR/etc/accuracy/standard/%s"'
                     % name.split("/")[1])
        self.add("constant/transportProperties",
                 f"transportModel Newtonian; nu nu [0 2 -1 0 0 0 0] {NU}; "
                 f"rho rho [1 -3 0 0 0 0 0] {RHO};")
        self.add("constant/turbulenceProperties", "simulationType laminar;")
        self.add("constant/clumpProperties", """
            integrator { type implicitEuler; tolerance 1e-9; maxIterations 100; }
            contactModel { type hertz; reducedModulus 1000; restitution 0.5; }
            wallContactModel { type hertz; reducedModulus 1000; restitution 0.5; }
            openPatches { fadeLength 3e-6; }""")
        # Only round-off and the outer correctors shall tell numbers of ranks apart
        self.add("system/fvSolution", """
            solvers
            {
                "p.*" { solver PCG; preconditioner DIC; tolerance 1e-11; relTol 0; maxIter 3000; }
                "U.*" { tolerance 1e-12; relTol 0; maxIter 3000; }
            }
            PISO { pRefCell 0; pRefValue 0; }""")
        self.add("system/fvSchemes", """
            ddtSchemes { default Euler; }
            gradSchemes { default Gauss linear; grad(U) leastSquares; }
            divSchemes
            {
                default none; div(phi,U) Gauss linear;
                div((nuEff*dev2(T(grad(U))))) Gauss linear;
            }
            laplacianSchemes { default Gauss linear corrected; }
            interpolationSchemes { default linear; }
            snGradSchemes { default corrected; }""")
        tables = "".join('%s { type %s; libs ("libdeformableParticles.so"); %s }\n'
                         % (name, name, EACH)
                         for name in ("clumpForce", "clumpShape", "momentumBalance"))
        self.add("system/controlDict", f"""
            application rbcIbFoam; startFrom latestTime; startTime 0; stopAt endTime;
            endTime {END}; deltaT 1e-4; writeControl adjustableRunTime; writeInterval {END/4};
            writeFormat binary; writePrecision 12; timePrecision 10;
            libs ("libdeformableParticles.so" "libpaperModels.so");
            functions
            {{
                {tables}
                mean {{ type volFieldValue; {FIELD} regionType all; operation volAverage;
                    fields (U); }}
                peak {{ type fieldMinMax; {FIELD} mode magnitude; fields (U); }}
            }}""")
        self.add("system/decomposeParDict", "method hierarchical;")
        self.add("0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);")
        self.add("0/p", "dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;")


def adds(name, text=""):
    """A level that adds a text to a file."""
    return lambda scene: scene.add(name, text) if text else None


def nothing(scene):
    pass


# Meshes

def blocks(scene, cells, grading="1 1 1", shear=0):
    scene.shear = shear
    x, y, z = LENGTHS
    s = shear*y
    scene.add("system/blockMeshDict", f"""
        scale 1e-6;
        vertices
        (
            (0 0 0) ({x} 0 0) ({x + s} {y} 0) ({s} {y} 0)
            (0 0 {z}) ({x} 0 {z}) ({x + s} {y} {z}) ({s} {y} {z})
        );
        blocks ( hex (0 1 2 3 4 5 6 7) ({cells}) simpleGrading ({grading}) );""")


def sheared(scene):
    blocks(scene, "16 13 13", shear=tan(radians(20)))
    scene.add("system/fvSolution", "PISO { nNonOrthogonalCorrectors 1; }")


def split(scene):
    """Polyhedra where mesh cells in the middle, and at the wall below, are split."""
    blocks(scene, "14 11 11")
    scene.add("system/topoSetDict", "actions ( { name fine; type cellSet; action new; "
              "source boxToCell; box (5e-6 3e-6 3e-6) (13e-6 11e-6 12e-6); } );")
    scene.add("system/fvSolution", "PISO { nNonOrthogonalCorrectors 1; }")
    scene.utilities += ["topoSet", "refineHexMesh -overwrite fine"]


def refined(scene):
    blocks(scene, "12 10 10")
    scene.add("constant/dynamicMeshDict", """
        dynamicFvMesh clumpRefineFvMesh; refineInterval 1; field clumpCloseness;
        lowerRefineLevel 0.25; upperRefineLevel 1e9; unrefineLevel 0.1; nBufferLayers 0;
        maxRefinement 1; maxCells 100000; correctFluxes ((phi none) (phi_0 none) (sameLevel none));
        dumpLevel true;""")
    scene.add("system/decomposeParDict",
              "constraints { siblings { type refinementHistory; } }")


def moving(scene):
    """Points inside, and those along periodic directions, go to and fro by a third of the width of
    a mesh cell; the layers around them are stretched."""
    blocks(scene, "16 13 13")
    scene.add("system/fvSolution", "PISO { nNonOrthogonalCorrectors 1; }")
    scene.utilities += ["topoSet"]
    scene.add("constant/dynamicMeshDict", """
        dynamicFvMesh dynamicMotionSolverFvMesh; motionSolverLibs ("libfvMotionSolvers.so");
        motionSolver solidBody;
        solidBodyCoeffs
        {
            cellZone inner; solidBodyMotionFunction oscillatingLinearMotion;
            oscillatingLinearMotionCoeffs { amplitude (3e-7 2.5e-7 2e-7); omega 4000; }
        }""")


def zone(scene):
    """Of the points that move: across y there are layers that do not in every scene."""
    edges = [-1 if scene.periodic(i) and i != 1 else 2.9 for i in range(3)]
    box = "box (%ge-6 %ge-6 %ge-6) (%ge-6 %ge-6 %ge-6);" % (
        *edges, *(length - edge for length, edge in zip(LENGTHS, edges)))
    scene.add("system/topoSetDict", f"""
        actions
        (
            {{ name inner; type cellSet; action new; source boxToCell; {box} }}
            {{ name inner; type cellZoneSet; action new; source setToCellZone; set inner; }}
        );""")


# Boundaries: in x, y and z

def sides(x, y, z):
    """The kinds of both sides along each direction, or of the first and of the second one"""
    def write(scene):
        faces = ("0 4 7 3", "1 2 6 5", "0 1 5 4", "3 7 6 2", "0 3 2 1", "4 5 6 7")
        U = {"wall": "type noSlip;", "patch": "type zeroGradient;"}
        p = {"wall": "type zeroGradient;", "patch": "type fixedValue; value uniform 0;"}
        for conditions in (U, p):
            for same in ("cyclic", "cyclicAMI", "symmetryPlane"):
                conditions[same] = f"type {same};"
        boundary = ""
        for i, face in enumerate(faces):
            kind, side, other = (x, y, z)[i//2], "xyz"[i//2] + "%d" % (i % 2), (i + 1) % 2
            kind = kind.split()[i % 2] if " " in kind else kind
            scene.patches[side] = kind
            pair = f"neighbourPatch {side[0]}{other};" if scene.periodic(i//2) else ""
            if kind == "cyclicAMI":
                way = [(1 - 2*(i % 2))*LENGTHS[i//2]*1e-6*(j == i//2) for j in range(3)]
                pair += "transform translational; separationVector (%g %g %g);" % tuple(way)
            boundary += f"{side} {{ type {kind}; {pair} faces (({face})); }}\n"
            scene.add("0/U", f"boundaryField {{ {side} {{ {U[kind]} }} }}")
            scene.add("0/p", f"boundaryField {{ {side} {{ {p[kind]} }} }}")
            if kind == "patch":
                scene.add("system/controlDict", f"functions {{ flux_{side} {{ type "
                          f"surfaceFieldValue; {FIELD} regionType patch; name {side}; "
                          "fields (phi); operation sum; } }")
        scene.add("system/blockMeshDict", f"boundary ( {boundary} );")
        pairs = " ".join(side for side, kind in scene.patches.items() if kind == "cyclic")
        if scene.row["mesh"] == "refined" and pairs:
            scene.add("system/decomposeParDict",
                      f"constraints {{ pairs {{ type preservePatches; patches ({pairs}); }} }}")
        if scene.row["mesh"] == "moving":
            zone(scene)
        if x == "cyclicAMI":
            onOneProcessor(scene, "x0 x1")
    return write


def onOneProcessor(scene, patches):
    """Patches across which OpenFOAM follows no particle to another processor"""
    scene.add("system/jointDict", "actions ( { name joint; type faceSet; action new; "
              f"source patchToFace; patches ({patches}); }} );")
    scene.utilities += ["topoSet -dict system/jointDict"]
    scene.add("system/decomposeParDict",
              "constraints { joint { type singleProcessorFaceSets; sets ((joint -1)); } }")


# What drives the flow

def inlet(scene):
    scene.add("0/U", f"internalField uniform ({SPEED} 0 0); boundaryField "
              f"{{ x0 {{ type fixedValue; value uniform ({SPEED} 0 0); }} }}")
    scene.add("0/p", "boundaryField { x0 { type zeroGradient; } }")


def gradient(mean):
    """Of the pressure, which holds a mean velocity, or keeps the fluid from sinking with bodies"""
    def write(scene):
        scene.add("0/U", f"internalField uniform ({mean} 0 0);")
        scene.add("constant/fvOptions", "drive { type meanVelocityGradient; selectionMode all; "
                  f"fields (U); Ubar ({mean} 0 0); }}")
    return write


# Attraction, and bonds of long molecules, between bodies and at walls

BELL = "bell; density 1e13; reach 8e-7; onRate 1000; offRate 500; compliance 4e-10; stiffness 1e-4"


def attracts(law):
    def write(scene):
        walls = " ".join(side for side, kind in scene.patches.items() if kind == "wall")
        for name, patches in (("cells", ""), ("walls", f"patches ({walls});")):
            if patches != "patches ();":
                scene.add("constant/clumpProperties", "effects { contact on; } surfaceForces { "
                          f"{name} {{ type {law}; {patches} }} }}")
    return write


# Bodies: shape, half the height, and the places of two clumps [um]; spheres that are pulled; model
# that conserves

BODIES = {
    "sphere": ("type chain; nSpheres 1;", 2, (), (), ""),
    "dumbbell": ("type chain; nSpheres 2; spacing 5e-6;", 2.4, (1,), (0,),
                 "unionVolume; volumeModulus 1e4;"),
    "fibre": ("type chain; nSpheres 5; spacing 2.5e-6;", 2.9, (4,), (0,),
              "unionVolume; volumeModulus 1e4;"),
    "ring": ("type ring; nSpheres 8; ringRadius 3e-6;", 5, (0,), (4,),
             "enclosedArea; areaModulus 1e-3;"),
    "shell": ("type shell; nSpheres 12; shellRadius 2.4e-6;", 4.4, (11,), (8,),
              "unionVolume; volumeModulus 1e4;"),
    "rod": ("type chain; nSpheres 2; spacing 5e-6;", 2.4, (), (),
            "unionVolume; volumeModulus 1e4;"),
    "capsule": ("type icosphere; radius 2.4e-6; subdivisions 2;", 2.4, (), (), ""),
    "solid": ("type filled; surface { type icosphere; radius 2.4e-6; subdivisions 2; }", 2.4,
              (), (), ""),
}

# Stiff enough to stay close to their shape under what drives the scenes
SOLID = """
    membrane { solid { type neoHookeanSolid; shearModulus 50; } }
    viscosityRatio 3;"""
MEMBRANE = """
    membrane
    {
        strain { type neoHookean; shearModulus 2e-5; }
        bending { type helfrich; bendingStiffness 2e-18; }
    }
    viscosityRatio 3;"""


BONDS = """
    type elastic;
    rigidities { normal 70e-12; tangential 20e-12; bending 8e-24; torsional 10e-24; }"""
STIFF = """
    type elastic; youngModulus 5e5; shearModulus 2e5;
    multipliers { normal 1; tangential 1; bending 1; torsional 1; }"""


def clumpType(scene, name, body):
    shape, _, plus, minus, _ = BODIES[body]
    scene.types.append((name, body))
    if body in ("capsule", "solid"):
        scene.add("constant/clumpProperties", f"types {{ {name} {{ shape {{ {shape} }} "
                  f"density {scene.density}; {MEMBRANE if body == 'capsule' else SOLID} }} }}")
        return
    bonds = "" if body == "sphere" else (
        f"bondModel {{ {STIFF if body == 'rod' else BONDS} }} "
        "dampingModel { type dampingRatio; beta 1; }")
    scene.add("constant/clumpProperties", f"types {{ {name} {{ shape {{ {shape} sphereRadius "
              f"{RADIUS}; }} density {scene.density}; massModel union; motion free; {bonds} }} }}")
    if plus:
        scene.add("constant/clumpProperties", f"loads {{ {name} {{ type oppositeForces; "
                  f"clumpType {name}; direction (1 0 0); plus ({plus[0]}); minus ({minus[0]}); "
                  f"force {PULL}; }} }}")


def place(scene, *clumps):
    """Type, the place in um: x, y above the least height of the body, z, and a velocity."""
    text = ""
    for name, x, above, z, *velocity in clumps:
        at = [x, above + BODIES[dict(scene.types)[name]][1] + 0.6, z]
        for i in range(3):
            if scene.periodic(i):
                at[i] = (at[i] + SHIFT[i]) % LENGTHS[i]
        at[0] += scene.shear*at[1]
        scene.starts.append((name, *(velocity or [(0, 0, 0)])))
        start = "velocity (%g %g %g);" % velocity[0] if velocity else ""
        at = [float("%.4g" % x) + scene.nudge for x in at]
        text += "{ type %s; position (%.14ge-6 %.14ge-6 %.14ge-6); axis (0 0 1); angle 8; %s }\n" \
            % (name, *at, start)
    scene.add("constant/clumpProperties", f"placement {{ type list; clumps ( {text} ); }}")


def pairOf(body, second):
    def write(scene):
        clumpType(scene, body, body)
        first = (5.2, 0, 8) if body == "shell" else (8.5, 0, 5.8)
        place(scene, (body, *first), (body, *second))
    return write


def spheres(scene):
    """Two that are pulled apart, and one on its way to the end of the domain."""
    for name, sign in (("plus", 1), ("minus", -1), ("bead", 0)):
        clumpType(scene, name, "sphere")
        if sign:
            scene.add("constant/clumpProperties", f"loads {{ {name} {{ type pointForces; clumpType "
                      f"{name}; spheres (0); forces (({sign*PULL} 0 0)); torques ((0 0 0)); "
                      "factor 1; } }")
    place(scene, ("minus", 7, 0, 6), ("plus", 10, 1.5, 8.9), ("bead", 16.5, 6.4, 9))


def several(scene):
    for name, body in (("bead", "sphere"), ("dumbbell", "dumbbell"), ("ring", "ring")):
        clumpType(scene, name, body)
    place(scene, ("dumbbell", 8, 0, 5.6), ("ring", 9, 0, 10.1), ("bead", 15.5, 7, 4.5))


def moved(scene):
    """A sphere that is taken along, with a turn, towards a ring, and a bead beside them."""
    for name, body in (("mover", "sphere"), ("ring", "ring"), ("bead", "sphere")):
        clumpType(scene, name, body)
    place(scene, ("mover", 5, 0, 9.5), ("ring", 12, 0.4, 10.1), ("bead", 9, 5, 5))
    scene.add("constant/clumpProperties", "loads { along { type move; clumpType mover; "
              f"velocity ({SPEED/2} 0 0); angularVelocity 200; axis (0 0 1); }} }}")


def capsuleAndRing(scene):
    """And a bead: all kinds of clumps in one scene."""
    for name, body in (("bead", "sphere"), ("capsule", "capsule"), ("ring", "ring")):
        clumpType(scene, name, body)
    place(scene, ("capsule", 8, 0, 5.2), ("ring", 9, 0, 10.1), ("bead", 15.5, 7, 4.5))


def bouncing(scene):
    """Two spheres that meet, nearly along x, and a rod that hits the wall with an end; in a gas."""
    scene.rho, scene.pull, scene.gravity = GAS, 0, tuple(0.01*g for g in GRAVITY)
    scene.add("constant/transportProperties", f"rho rho [1 -3 0 0 0 0 0] {GAS};")
    if scene.row["gravity"] == "on":
        scene.add("constant/g", "value (%g %g %g);" % scene.gravity)
    for name, body in (("left", "sphere"), ("right", "sphere"), ("rod", "rod")):
        clumpType(scene, name, body)
    place(scene, ("left", 5, 3, 4.5, (FLIGHT, 0, 0)),
          ("right", 10.5, 3 + OFFSET, 4.5, (-FLIGHT, 0, 0)), ("rod", 9, 0, 11.5, (0, -FLIGHT, 0)))


# Of bonds that break within the run, over the stress of PULL in one of them; the fluid and other
# bonds carry the rest
STRENGTHS = {"dumbbell": 0.1, "fibre": 0.3, "ring": 0.3, "shell": 0.15, "rod": 0.3}


def breaks(scene):
    for name, body in scene.types:
        if body in STRENGTHS:
            strength = STRENGTHS[body]*PULL/(pi*RADIUS**2)
            scene.add("constant/clumpProperties", f"types {{ {name} {{ bondModel {{ breakage {{ "
                      f"normalStress {strength}; shearStress {strength}; }} }} }} }}")


def conserves(scene):
    for name, body in scene.types:
        if BODIES[body][4]:
            scene.add("constant/clumpProperties", f"types {{ {name} {{ conservationModel {{ type "
                      f"{BODIES[body][4]} }} }} }}")


def injects(patches):
    """Small beads through those of the patches where fluid comes in."""
    def write(scene):
        small = RADIUS*0.85
        scene.add("constant/clumpProperties", "types { small { shape { type chain; nSpheres 1; "
                  f"sphereRadius {small}; }} density {scene.density}; massModel union; "
                  "motion free; } }")
        scene.add("constant/clumpProperties", "injection { more { type rate; rate 2000; "
                  f"patches ({patches}); clumpType small; seed 1; }} }}")
    return write


# NOTE: a new feature needs a line here, and one in FORBIDDEN for what it can not be combined with
FEATURES = {
    "mesh": {
        "box": lambda scene: blocks(scene, "16 13 13"),
        "graded": lambda scene: blocks(scene, "18 15 14", "1.5 ((0.5 0.5 1.6) (0.5 0.5 0.6)) 1.3"),
        "sheared": sheared,
        "split": split,
        "refined": refined,
        "moving": moving,
    },
    "ranks": {
        str(n): adds("system/decomposeParDict",
                     f"numberOfSubdomains {n}; coeffs {{ n ({n} 1 1); }}")
        for n in (1, 2, 3)
    },
    "boundaries": {
        "closed": sides("wall", "wall", "wall"),
        "periodic": sides("cyclic", "cyclic", "cyclic"),
        "periodicWalls": sides("cyclic", "wall", "cyclic"),
        "open": sides("patch", "wall", "wall"),
        "mixed": sides("patch", "wall", "cyclic"),
        "half": sides("cyclic", "symmetryPlane wall", "cyclic"),
        "nonMatching": sides("cyclicAMI", "wall", "cyclic"),
    },
    # Blood, of the viscosity NU at the shear rates of these scenes
    "viscosity": {
        "Newtonian": nothing,
        "blood": adds("constant/transportProperties", "transportModel BirdCarreau; "
                      f"BirdCarreauCoeffs {{ nu0 {16*NU}; nuInf {NU}; k 3.313; n 0.3568; }}"),
        "powerLaw": adds("constant/transportProperties", "transportModel powerLaw; "
                         f"powerLawCoeffs {{ k {30*NU}; n 0.5; nuMin {NU/2}; nuMax {30*NU}; }}"),
    },
    "density": {        # of the clumps [kg/m3]
        "1100": nothing,
        "300": nothing,
    },
    "walls": {
        "auto": nothing,
        "off": adds("constant/clumpProperties", "effects { walls off; }"),
    },
    "contact": {
        "off": adds("constant/clumpProperties", "effects { contact off; }"),
        "on": adds("constant/clumpProperties", "effects { contact on; }"),
        "lubricated": adds("constant/clumpProperties", "effects { contact on; } "
                           "lubrication { type squeezeFilm; roughness 5e-8; }"),
        "rough": adds("constant/clumpProperties", "effects { contact on; } "
                      "contactModel { friction 0.5; rollingFriction 0.05; } "
                      "wallContactModel { friction 0.5; rollingFriction 0.05; }"),
        "attracted": attracts("depletion; energy 1e-5"),
        "bonded": attracts(BELL),
    },
    "gravity": {
        "off": nothing,
        "on": adds("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (%g %g %g);" % GRAVITY),
    },
    "convection": {
        "auto": nothing,
        "on": adds("constant/clumpProperties", "effects { convection on; }"),
    },
    "driving": {
        "none": nothing,
        "gradient": gradient(SPEED),
        "noMean": gradient(0),
        "movingWall": adds("0/U", "boundaryField { y1 { type fixedValue; "
                           f"value uniform ({SPEED} 0 0); }} }}"),
        "inlet": inlet,
    },
    "step": {
        "fixed": nothing,
        "adjustable": adds("system/controlDict", "adjustTimeStep yes; deltaT 6e-5; "
                           "maxDeltaT 1.3e-4;"),
    },
    "outer": {
        "tolerance": nothing,
        "1": adds("system/fvSolution", "PISO { nOuterCorrectors 1; couplingTolerance 0; }"),
        "3": adds("system/fvSolution", "PISO { nOuterCorrectors 3; couplingTolerance 0; }"),
    },
    "dilation": {
        "yes": nothing,
        "no": adds("constant/clumpProperties", "immersedBoundary { interiorDilation no; }"),
    },
    "rotation": {
        "wholeClump": nothing,
        "off": adds("constant/clumpProperties", "effects { rotation off; }"),
        "perSphere": adds("constant/clumpProperties", "rotation { type perSphere; }"),
    },
    "bodies": {
        "spheres": spheres,
        "dumbbell": pairOf("dumbbell", (10, 0.3, 10.2)),
        "ring": pairOf("ring", (9.5, 0.4, 10.2)),
        "fibre": pairOf("fibre", (10, 0.5, 10.2)),
        "shell": pairOf("shell", (14.4, 0.2, 8.4)),
        "several": several,
        "capsules": pairOf("capsule", (11.5, 0.3, 9.9)),
        "capsuleAndRing": capsuleAndRing,
        "bouncing": bouncing,
        "solids": pairOf("solid", (11.5, 0.3, 9.9)),
        "moved": moved,
    },
    "bonds": {
        "whole": nothing,
        "brittle": breaks,
    },
    "conservation": {
        "none": nothing,
        "one": conserves,
    },
    "injection": {
        "no": nothing,
        "inlet": injects("x0"),
        "bothEnds": injects("x0 x1"),
        "again": adds("constant/clumpProperties", "injection { again { type recirculation; "
                      "from (x1); patches (x0); seed 1; } }"),
    },
    "disturbance": {        # see runPairs.py
        "none": nothing,
        "kill": nothing,
        "restart": nothing,
        "otherRanks": nothing,
    },
}

FORBIDDEN = [
    ({"driving": ["gradient", "noMean"], "boundaries": ["closed", "open", "mixed"]},
     "only a flow that is periodic along x has a mean velocity to be held"),
    ({"driving": ["movingWall"], "boundaries": ["periodic"]}, "there is no wall"),
    ({"driving": ["inlet"], "boundaries": ["closed", "periodic", "periodicWalls", "half",
                                           "nonMatching"]},
     "there is no inlet"),
    ({"injection": ["inlet", "bothEnds", "again"],
      "driving": ["none", "gradient", "noMean", "movingWall"]},
     "there is no inlet"),
    ({"conservation": ["one"], "bodies": ["spheres", "capsules", "solids"]},
     "a sphere has no shape to conserve, and a capsule keeps its volume"),
    ({"bonds": ["brittle"], "bodies": ["spheres", "capsules", "solids"]}, "there are no bonds"),
    ({"bodies": ["bouncing"], "walls": ["off"],
      "boundaries": ["closed", "periodicWalls", "open", "mixed", "half", "nonMatching"]},
     "nothing keeps them inside"),
    ({"boundaries": ["half"], "contact": ["off"]}, "nothing keeps them off the plane of symmetry"),
    ({"boundaries": ["nonMatching"], "mesh": ["refined"]},
     "the mesh is refined by faces that match"),
    ({"boundaries": ["nonMatching"], "viscosity": ["blood", "powerLaw"]},
     "gradients across faces that do not match are not those of the rate of strain"),
    ({"boundaries": ["half"], "contact": ["bonded"]}, "no bonds form with mirror images"),
    ({"contact": ["bonded"], "bodies": ["capsules", "capsuleAndRing", "solids"]},
     "only clumps of spheres have bonds"),
    ({"contact": ["attracted", "bonded"], "walls": ["off"]}, "attraction needs contact with walls"),
    ({"outer": ["1"], "bodies": ["capsules", "capsuleAndRing", "solids"],
      "contact": ["on", "lubricated", "rough", "attracted"]},
     "membranes that may touch are refused with one outer corrector"),
]
