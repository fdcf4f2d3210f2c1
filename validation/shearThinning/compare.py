"""Drag and velocity of spheres and a ring in liquids that thin, against meshes fitted to the
sphere, and against refinement for the ring."""

import math

from results import Results, mean, plt, read, save

LIMIT = {4: 2, 8: 1}        # [%]

# README.md gives the reason
KNOWN = {
    "mean gradient, array-0.1, power0.5 at 0.0990861 m/s, D/dx 4": 31339.3,
    "mean gradient, array-0.2, newtonian at 0.0102335 m/s, D/dx 4": 91610.4,
    "mean gradient, array-0.2, newtonian at 0.0102335 m/s, D/dx 8": 98553.1,
    "mean gradient, plates, blood at 2.26569e-05 m/s, D/dx 4": 19.5814,
    "mean gradient, plates, blood at 2.26569e-05 m/s, D/dx 8": 19.7564,
    "mean gradient, narrow, newtonian at 2.80756e-05 m/s, D/dx 4": 75.9469,
    "mean gradient, narrow, newtonian at 2.80756e-05 m/s, D/dx 8": 78.6216,
    "mean drag, narrow, newtonian at 2.80756e-05 m/s, D/dx 4": 6.34057e-11,
    "mean drag, narrow, newtonian at 2.80756e-05 m/s, D/dx 8": 6.52523e-11,
    "mean gradient, narrow, blood at 5.461e-06 m/s, D/dx 4": 18.9192,
    "mean gradient, narrow, blood at 5.461e-06 m/s, D/dx 8": 19.525,
    "mean drag, narrow, blood at 5.461e-06 m/s, D/dx 4": 1.46994e-11,
    "mean drag, narrow, blood at 5.461e-06 m/s, D/dx 8": 1.491e-11,
    "mean gradient, narrow, blood at 4.99115e-05 m/s, D/dx 4": 76.0565,
    "mean gradient, narrow, blood at 4.99115e-05 m/s, D/dx 8": 78.3743,
    "mean drag, narrow, blood at 4.99115e-05 m/s, D/dx 4": 6.07155e-11,
    "mean drag, narrow, blood at 4.99115e-05 m/s, D/dx 8": 6.20651e-11,
    "mean gradient, narrow, blood at 0.000458695 m/s, D/dx 4": 474.121,
    "mean gradient, narrow, blood at 0.000458695 m/s, D/dx 8": 489.289,
    "mean drag, narrow, blood at 0.000458695 m/s, D/dx 4": 3.88237e-10,
    "mean drag, narrow, blood at 0.000458695 m/s, D/dx 8": 3.98212e-10,
    "mean gradient, duct, newtonian at 1.24991e-05 m/s, D/dx 4": 70.0587,
    "mean gradient, duct, newtonian at 1.24991e-05 m/s, D/dx 8": 76.8362,
    "mean drag, duct, newtonian at 1.24991e-05 m/s, D/dx 4": 4.19289e-11,
    "mean drag, duct, newtonian at 1.24991e-05 m/s, D/dx 8": 4.63892e-11,
    "mean gradient, duct, blood at 1.88149e-05 m/s, D/dx 4": 71.3371,
    "mean gradient, duct, blood at 1.88149e-05 m/s, D/dx 8": 76.8904,
    "mean drag, duct, blood at 1.88149e-05 m/s, D/dx 4": 4.01542e-11,
    "mean drag, duct, blood at 1.88149e-05 m/s, D/dx 8": 4.30589e-11}

results = Results()
fitted = {(r["scene"], r["liquid"], r["velocity_m_s"]): (r["drag_N"], r["gradient_m_s2"])
          for r in read("../reference/drag.csv")}
rings = {(r["liquid"], r["velocity_m_s"]): r["drag_N"] for r in read("ring.csv")}
runs = read("data.csv")
figure, panels = plt.subplots(1, 3, figsize=(15, 4.4), sharey=True)


def chosen(*key):
    return [r for r in runs if (r["test"], r["liquid"], r["velocity_m_s"], r["D_dx"]) == key]


def over_resolutions(test, liquid, velocity, quantity, column, unit, reference, source, limit,
                     axes=None):
    """Rows for the mean over the places, and a line of their errors in the figure."""
    errors = []
    place = "" if test in ("fixed", "ring") else f"{test}, "
    for resolution in sorted({r["D_dx"] for r in runs}):
        name = f"{quantity}, {place}{liquid} at {velocity:g} m/s, D/dx {resolution:g}"
        values = [r[column] for r in chosen(test, liquid, velocity, resolution)]
        if values:
            errors.append((resolution, 100*(mean(values)/reference - 1)))
        if values and resolution in limit:
            results.add(name, mean(values), unit, reference, f"{limit[resolution]:g}%", source,
                        KNOWN.get(name))
    if axes and errors:
        axes.plot(*zip(*errors), "o-", label=f"{place}{liquid}, {velocity:.3g} m/s")


for (scene, liquid, velocity), (drag, gradient) in fitted.items():
    source = "mesh fitted to the sphere"
    if scene == "box":
        over_resolutions("fixed", liquid, velocity, "mean drag", "value", "N", drag, source,
                         {4: 2, 8: 2}, panels[0])
        continue

    # In an array the drag is the gradient times the density and the volume of a period
    over_resolutions(scene, liquid, velocity, "mean gradient", "gradient_m_s2", "m/s2", gradient,
                     source, LIMIT, panels[2])
    if not scene.startswith("array"):
        over_resolutions(scene, liquid, velocity, "mean drag", "value", "N", drag, source, LIMIT)

for (liquid, velocity), drag in rings.items():
    over_resolutions("ring", liquid, velocity, "mean drag of the ring", "value", "N", drag,
                     "D/dx 8 and 12, extrapolated", LIMIT, panels[1])
same, = chosen("ring", "power1", 1e-2, 4)
results.add("drag of the ring, power law of n = 1, D/dx 4", same["value"], "N",
            chosen("ring", "newtonian", 1e-2, 4)[0]["value"], "2%", "the Newtonian liquid")

# How good the fitted meshes are
c, U = 0.1, next(v for s, liquid, v in fitted if (s, liquid) == ("array-0.1", "newtonian"))
results.add("K of the fitted mesh, array-0.1, newtonian",
            fitted["array-0.1", "newtonian", U][0]/(6*math.pi*1e-2*2.5e-6*U), "-",
            1/(1 - 1.7601*c**(1/3) + c - 1.5593*c**2 + 3.9799*c**(8/3) - 3.0734*c**(10/3)), "0.5%",
            "Sangani and Acrivos 1982")

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

for axes, title in zip(panels, ("sphere in a box", "ring", "array, plates, duct: gradient")):
    axes.axhline(0, color="k", lw=0.5)
    axes.set_xlabel("mesh cells per diameter of a sphere")
    axes.set_title(title, fontsize=10)
    axes.legend(fontsize=7, **({} if axes is not panels[2] else
                               {"loc": "upper left", "bbox_to_anchor": (1, 1)}))
panels[0].set_ylabel("error of the drag, or of the gradient [%]")
save(figure, "shearThinning.png")
results.write()
