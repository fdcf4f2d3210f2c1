"""Capsules under tension in weak shear against linear theory, and in a channel over mesh, nodes and
time step."""

from results import Results, plt, read, save

THEORY = "linear theory, doc/theory.md"


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

figure, axes = plt.subplots(figsize=(5, 3.6))
for r in rows:
    axes.plot(1e12*r["area_m2"], r["deformation"], "o",
              label="%g mesh cells, %g subdivisions, %g us" % (
                  r["cells"], r["subdivisions"], 1e6*r["step_s"]))
axes.set_xlabel("area [um$^2$]")
axes.set_ylabel("deformation")
axes.legend(fontsize=6)
save(figure, "cytometry.png")
results.write()
