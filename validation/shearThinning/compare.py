"""Drag and velocity of spheres and a ring in liquids that thin, against meshes fitted to the
sphere, and against refinement for the ring."""

from results import Results, mean, plt, read, save

LIMIT = {4: 2, 8: 1}        # [%]

results = Results()
fitted = {(r["scene"], r["liquid"], r["velocity_m_s"]): (r["drag_N"], r["gradient_m_s2"])
          for r in read("../reference/drag.csv")}
rings = {(r["liquid"], r["velocity_m_s"]): r["drag_N"] for r in read("ring.csv")}
runs = read("data.csv")
figure, panels = plt.subplots(1, 3, figsize=(13, 4.4), sharey=True)


def chosen(*key):
    return [r for r in runs if (r["test"], r["liquid"], r["velocity_m_s"], r["D_dx"]) == key]


def over_resolutions(test, liquid, velocity, quantity, column, unit, reference, source, limit,
                     axes=None):
    """Rows for the mean over the places, and a line of their errors in the figure."""
    errors = []
    place = "" if test in ("fixed", "ring") else f"{test}, "
    for resolution in sorted({r["D_dx"] for r in runs}):
        values = [r[column] for r in chosen(test, liquid, velocity, resolution)]
        if values:
            errors.append((resolution, 100*(mean(values)/reference - 1)))
        if values and resolution in limit:
            results.add(f"{quantity}, {place}{liquid} at {velocity:g} m/s, D/dx {resolution:g}",
                        mean(values), unit, reference, f"{limit[resolution]:g}%", source)
    if axes and errors:
        axes.plot(*zip(*errors), "o-", label=f"{place}{liquid}, {velocity:.3g} m/s")


for (scene, liquid, velocity), (drag, gradient) in fitted.items():
    test = "fixed" if scene == "box" else scene
    over_resolutions(test, liquid, velocity, "mean drag", "value", "N", drag,
                     "mesh fitted to the sphere", {4: 2, 8: 2} if scene == "box" else LIMIT,
                     panels[0 if scene == "box" else 1])
    if scene in ("plates", "duct"):
        over_resolutions(test, liquid, velocity, "mean gradient", "gradient_m_s2", "m/s2", gradient,
                         "mesh fitted to the sphere", LIMIT)

for (liquid, velocity), drag in rings.items():
    over_resolutions("ring", liquid, velocity, "mean drag of the ring", "value", "N", drag,
                     "D/dx 8 and 12, extrapolated", LIMIT, panels[2])
same, = chosen("ring", "power1", 1e-2, 4)
results.add("drag of the ring, power law of n = 1, D/dx 4", same["value"], "N",
            chosen("ring", "newtonian", 1e-2, 4)[0]["value"], "0.01%", "the Newtonian liquid")

for run in runs:
    if run["test"] in ("pulled", "pulledRing"):
        ring = " of the ring" if run["test"] == "pulledRing" else ""
        name = (f"velocity{ring} in the {run['position']} step, {run['liquid']}, "
                f"D/dx {run['D_dx']:g}")
        if run["position"] == "last":
            results.add(name, run["value"], "m/s", run["velocity_m_s"], "3%",
                        "D/dx 8 and 12, extrapolated" if ring else "mesh fitted to the sphere")
        else:
            results.report(name, run["value"], "m/s", "on the way from rest")

for axes, title in zip(panels, ("sphere in a box", "array, plates, duct", "ring")):
    axes.axhline(0, color="k", lw=0.5)
    axes.set_xlabel("mesh cells per diameter of a sphere")
    axes.set_title(title, fontsize=10)
    axes.legend(fontsize=7)
panels[0].set_ylabel("error of the drag [%]")
save(figure, "shearThinning.png")
results.write()
