"""Force at which two attracting bodies part: of beads Derjaguin's 2 pi R w0, on any mesh and at any
step; of rings and membranes what their shape makes of it. A wall holds a bead or a ring that does
not roll until the shear stress pulls it with the friction times the attraction (O'Neill 1968)."""

import math

import numpy as np
from results import Results, plt, read, save

ENERGY = 2.67e-6    # [J/m2]
SOURCE = "Derjaguin 1934; Derjaguin, Muller and Toporov 1975"

results = Results()
figure, axes = plt.subplots(figsize=(6, 3.6))
rings = {}
leaving = {}
for r in read("data.csv"):
    if r["kind"] == "hold":
        kind = r["direction"]
        columns = np.genfromtxt(r["history"], delimiter=",", names=True)
        # The friction times the attraction, which neighbouring spheres of a ring share where they
        # face the same gap, and the stress at the wall
        friction = 0.3*(2*math.pi*2e-6*1e-6 if kind == "bead" else -columns["attraction_N"][0])
        stress = 1.2e-3*1.2e-3/24e-6*columns["t_s"]/r["ramp_s"]
        name = "wall, %s, %g mesh cells, step %g s, ranks %d: " % (
            kind, r["mesh_cells"], r["step_s"], r["ranks"])
        results.add(name + "largest force", columns["Fx_N"].max()/friction, "of the law", 1, 0.02,
                    "Coulomb, Derjaguin")
        # Once it slides, its velocity is proportional to the stress beyond that
        sliding = (columns["Ux_m_s"] > 3e-6) & (columns["Ux_m_s"] < 15e-6)
        slope, rest = np.polyfit(stress[sliding], columns["Ux_m_s"][sliding], 1)
        leaves = -rest/slope
        leaving[kind, r["mesh_cells"], r["step_s"], r["ranks"]] = leaves
        if kind == "bead":
            law = friction/(1.7005*6*math.pi*4e-12)
            results.add(name + "stress at which it leaves", leaves/law, "of the law", 1, 0.05,
                        "O'Neill 1968")
        else:
            results.report(name + "stress at which it leaves", 1e3*leaves, "mPa",
                           "the drag of a ring on a wall is not known")
        continue
    columns = np.genfromtxt(r["history"], delimiter=",", names=True, dtype=None, encoding="utf-8")
    held, free = (columns[columns["type"] == t] for t in ("held", "body"))
    t = held["t_s"]
    distance = np.hypot(free["x_m"] - held["x_m"], free["y_m"] - held["y_m"])
    force = r["largest_N"]*np.maximum(t - r["rest_s"], 0)/r["ramp_s"]
    start = np.searchsorted(t, r["rest_s"] + 0.1*r["ramp_s"])
    # Membranes are stretched before they part
    way = 2e-6 if r["kind"] == "membrane" else 5e-8
    apart = np.nonzero(distance[start:] > distance.min() + way)[0]
    parting = force[start + apart[0]] if len(apart) else math.nan
    name = "%s of %d, %g mesh cells" % (r["kind"], r["n"], r["mesh_cells"])
    name += ", step %g s" % r["step_s"]
    if r["direction"] != "normal":
        name += ", sliding"
    if r["kind"] == "membrane" and r["direction"] == "sliding":
        # They turn about each other before they part
        slid = np.nonzero(abs(free["x_m"] - held["x_m"]) > 1e-6)[0]
        results.report(name + " by 1 um: force", force[slid[0]]*1e12 if len(slid) else math.nan,
                       "pN", "energy times the width of 7.8 um: 21 pN; Fedosov 2011: 1.5 to 3 pN")
    elif r["kind"] == "bead":
        law = 2*math.pi*1e-6*ENERGY
        results.add(name + ": force of parting", parting/law, "of the law", 1, 0.05, SOURCE)
    else:
        rings[r["kind"], r["n"], r["mesh_cells"], r["direction"]] = parting
        results.report(name + ": force of parting", parting*1e12, "pN",
                       "a pair of cells: 3 to 7 pN normal, 1.5 to 3 pN sliding (Fedosov 2011)")
    axes.plot(force*1e12, (distance - distance[0])*1e6, label=name)
for (kind, cells, step, ranks), leaves in leaving.items():
    for other, what in (((kind, cells, 4*step, ranks), "a quarter of the step"),
                        ((kind, cells, step, 1), "%d ranks over one" % ranks)):
        if other in leaving and other != (kind, cells, step, ranks):
            results.add("wall, %s, %g mesh cells, step %g s: %s" % (kind, cells, step, what),
                        leaves/leaving[other], "-", 1, 0.05, "no dependence on step and ranks")
coarse, fine = (rings.get(("ring", 10, n, "normal")) for n in (3, 4))
if fine:
    results.add("ring of 10: 3 mesh cells over 4", coarse/fine, "-", 1, 0.05,
                "no dependence on the mesh")
axes.set_xlabel("force [pN]")
axes.set_ylabel("way apart [um]")
axes.set_xlim(10, 150)
axes.set_ylim(-0.5, 3)
axes.legend(fontsize=6)
save(figure, "attraction.png")
results.write()
