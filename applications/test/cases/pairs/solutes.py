"""Two solutes in every scene: a uniform one, and one of which clumps bring more.

The uniform one must stay uniform, whatever moves through it. What the other one has outside and
inside changes only by what goes through the patches, and by what comes and goes with clumps.
"""

import re

from clumps import table

CONDITIONS = {"wall": "zeroGradient;", "cyclic": "cyclic;", "cyclicAMI": "cyclicAMI;",
              "symmetryPlane": "symmetryPlane;",
              "patch": "inletOutlet; inletValue uniform 1; value uniform 1;"}


def possible(scene):
    """Fluxes of a solute need faces that match"""
    return "cyclicAMI" not in scene.patches.values()


def add(scene):
    types = sorted(set(re.findall(r"types \{ (\w+) \{", scene.files["constant/clumpProperties"])))
    inside = {"evenSolute": "permeability 1e-3; diffusivity 1e-9;",
              "loadedSolute": "permeability 1e-3; diffusivity 1e-9; initial 2;"}
    for name, entries in inside.items():
        # Every second type is impermeable
        permeable = " ".join("%s { %s }" % (type_, entries) for type_ in types[::2])
        scene.add("system/controlDict", """
            functions
            {
                %s
                {
                    type clumpSolute; libs ("libclumpSolutes.so"); field %s; diffusivity 2e-9;
                    types { %s } writePrecision 15;
                }
            }""" % (name, name, permeable))
        scene.add("system/fvSchemes", """
            divSchemes { div(phi,%s) Gauss limitedLinear 1; }
            laplacianSchemes { laplacian(D,%s) Gauss linear corrected; }""" % (name, name))
        scene.add("system/fvSolution", """
            solvers
            {
                "%s(Inside)?" { solver PBiCGStab; preconditioner DILU; tolerance 1e-10; relTol 0; }
            }""" % name)
        scene.add("0/" + name, "dimensions [0 -3 0 0 1 0 0]; internalField uniform 1;\n"
                  + "".join("boundaryField { %s { type %s } }\n" % (side, CONDITIONS[kind])
                            for side, kind in scene.patches.items()))


def judge(check, case):
    rows = table(case, "evenSolute")
    check("uniform concentration changes by", max(
        abs(row[name] - 1) for row in rows for name in ("lowest", "highest")), 1e-6)

    def content(row):
        return row["outside"] + row["inside"] - row["entered"]

    rows = table(case, "loadedSolute")
    worst, left = 0, 0
    for before, row in zip(rows, rows[1:]):
        step = row["time"] - before["time"]
        left += step*sum(value for name, value in row.items() if name.startswith("out_"))
        worst = max(worst, abs(content(row) + left - content(rows[0])))
    check("content lost, over the content", worst/content(rows[0]), 1e-9)
