"""Capsules under tension in weak shear against linear theory, and in a channel over mesh, nodes and
time step; elastic spheres there against tables."""

import math

from results import Results, plt, read, save

THEORY = "linear theory, doc/theory.md"

# Misses of elastic spheres by table, modulus, area and mesh cells, see the page
KNOWN = {
    ("LE-2D-FEM-19", 6.59, 80, 20): 1.14282, ("LE-2D-FEM-19", 2.79, 120, 30): 1.09813,
    ("HE-3D-FEM-22", 0.79, 80, 30): 0.864024, ("HE-3D-FEM-22", 0.93, 80, 30): 0.842351,
    ("HE-3D-FEM-22", 1.1, 80, 30): 0.82689, ("HE-3D-FEM-22", 1.6, 80, 30): 0.801364,
    ("HE-3D-FEM-22", 1.1, 120, 30): 0.898998, ("HE-3D-FEM-22", 1.31, 120, 30): 0.867882,
    ("HE-3D-FEM-22", 1.6, 120, 30): 0.849249, ("HE-3D-FEM-22", 1.1, 160, 30): 1.0664,
}


def linear(name, Ca):
    """Deformation of a neo-Hookean capsule (Gs = 1) in weak shear: the law at the stretch l, with a
    constant tension of Gs or none"""
    l, constant = (1.05, 0) if name == "inflated" else (1, 1)
    T = 1 - l**-6
    K = 3*l**-6
    G = l**-6 + T
    w = 5*(1 + 3*K/G)/(4*(T + constant)*(1 + 1.5*K/G) + 4*K)
    return 0.5*w*Ca


results = Results()
for r in read("shear.csv"):
    results.add("%s, Ca %g, %g mesh cells: deformation" % (r["capsule"], r["Ca"], r["D_dx"]),
                r["D"]/linear(r["capsule"], r["Ca"]), "of the theory", 1, 0.05, THEORY)

rows = read("data.csv")
base = rows[0]
for r in rows:
    name = "channel: %g mesh cells, %g subdivisions, step %g us" % (
        r["cells"], r["subdivisions"], 1e6*r["step_s"])
    results.report(name + ": deformation", r["deformation"], "-",
                   "area %.1f um2, velocity %.3f m/s, %.1f outer correctors, %.0f s" % (
                       1e12*r["area_m2"], r["velocity_m_s"], r["correctors"], r["seconds"]))


def change(what, tolerance, known=None, **of):
    """The deformation of a run against that of the base run"""
    for r in rows:
        if all(r[k] == of.get(k, base[k]) for k in ("cells", "subdivisions", "step_s")):
            results.add("channel: deformation, " + what, r["deformation"]/base["deformation"], "-",
                        1, tolerance, "no dependence", known)


change("half the step", 0.02, step_s=2.5e-6)

# There the nodes are closer than 1.2 mesh cells, and a ridge grows at the rear edge
change("20 mesh cells", 0.05, known=1.16, cells=20)
change("28 mesh cells", 0.05, cells=28)

# Elastic spheres: the deformation beyond that of the triangles at rest
tables = {}
for row in read("reference/isoelastics.csv"):
    tables.setdefault((row["table"], row["E_kPa"]), []).append(
        (row["area_um2"], row["deformation"]))


def tabulated(table, E, area):
    """The deformation at an area [um2]: of its logarithm over that of the area, by a polynomial
    through the four nearest points"""
    points = sorted(tables[table, E], key=lambda p: abs(math.log(p[0]/area)))[:4]
    result = 0
    for i, (a, d) in enumerate(points):
        weight = 1
        for j, (b, _) in enumerate(points):
            if i != j:
                weight *= math.log(area/b)/math.log(a/b)
        result += weight*math.log(d)
    return math.exp(result)


def unbounded(E, area):
    """The deformation of a small linear elastic sphere in the middle of the channel, whose flow has
    the Laplacian of -4 kappa there: see doc/theory.md"""
    kappa = 28.454*0.1/(20e-6)**2/4                     # Q/L^2 = 0.1 m/s
    strain = 2.625*15e-3*kappa*math.sqrt(1e-12*area/math.pi)/(1e3*E)
    return 25/32*strain**2


spheres = read("elastic.csv")
still = [r for r in spheres if r["flow"] == "still"][0]["deformation"]
coarse, fine = ([r for r in spheres if r["table"] == "none" and r["cells"] == cells]
                for cells in (28, 40))
spheres = [r for r in spheres if r["flow"] != "still" and r["table"] != "none"]
for r in spheres:
    name = "%s, E %g kPa, sphere of %g um2, %g mesh cells" % (
        r["table"], r["E_kPa"], r["sphere_um2"], r["cells"])
    r["beyond"] = r["deformation"] - still
    known = KNOWN.get((r["table"], r["E_kPa"], r["sphere_um2"], r["cells"]))
    if r["table"] == "linear":
        results.add(name + ": deformation", r["beyond"]/unbounded(r["E_kPa"], r["sphere_um2"]),
                    "of the theory", 1, 0.05, "small sphere, doc/theory.md", known)
    else:
        results.add(name + ": deformation",
                    r["beyond"]/tabulated(r["table"], r["E_kPa"], 1e12*r["area_m2"]),
                    "of the table", 1, 0.05, "reference/isoelastics.csv", known)
    results.report(name + ": processor time", r["seconds"], "s", "deformation %.4f, area %.1f um2, "
                   "%.1f outer correctors" % (r["beyond"], 1e12*r["area_m2"], r["correctors"]))

if coarse and fine:
    course = read("history-steady.csv")
    name = "E 3 kPa, sphere of 12 um, 28 mesh cells: "
    at = [r for r in course if abs(r["time"] - 2.5e-4) < 1e-6][0]
    results.add(name + "deformation at 0.25 ms, over that with 40",
                (at["deformation"] - still)/(fine[0]["deformation"] - still), "-", 1, 0.02,
                "no dependence")
    results.add(name + "deformation at 0.9 over that at 0.25 ms",
                (course[-1]["deformation"] - still)/(at["deformation"] - still), "-", 1, 0.02,
                "steady")
    results.add(name + "largest area of the convex outline over that of the outline",
                max(r["hullArea"]/r["area"] for r in course), "-", 1, 0.001, "no ridge")

figure, axes = plt.subplots(figsize=(5, 3.6))
for (table, E), points in tables.items():
    if any((r["table"], r["E_kPa"]) == (table, E) for r in spheres):
        axes.plot(*zip(*points), "-" if table.startswith("HE") else "--", lw=0.8, color="0.4")
for r in spheres:
    axes.plot(1e12*r["area_m2"], r["beyond"], "kx" if r["table"].startswith("HE") else "k+")
for r in rows:
    axes.plot(1e12*r["area_m2"], r["deformation"], "o",
              label="%g mesh cells, %g subdivisions, %g us" % (
                  r["cells"], r["subdivisions"], 1e6*r["step_s"]))
axes.set_xlabel("area [um$^2$]")
axes.set_ylabel("deformation")
axes.legend(fontsize=6)
save(figure, "cytometry.png")
results.write()
