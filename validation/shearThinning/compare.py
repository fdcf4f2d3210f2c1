"""Drag and velocity of a sphere in liquids that thin against meshes fitted to it."""

from results import Results, mean, plt, read, save

results = Results()
fitted = {(r["liquid"], r["velocity_m_s"]): r["drag_N"] for r in read("../reference/drag.csv")}
runs = read("data.csv")
keys = sorted({(r["liquid"], r["velocity_m_s"]) for r in runs if r["test"] == "fixed"},
              key=lambda k: list(fitted).index(k))
figure, axes = plt.subplots(figsize=(6.4, 4.4))

for colour, (liquid, velocity) in enumerate(keys):
    errors = []
    for resolution in sorted({r["D_dx"] for r in runs}):
        drags = [r["value"] for r in runs if r["test"] == "fixed" and r["liquid"] == liquid
                 and r["velocity_m_s"] == velocity and r["D_dx"] == resolution]
        reference = fitted[liquid, velocity]
        results.add(f"mean drag, {liquid} at {velocity:g} m/s, D/dx {resolution:g}", mean(drags),
                    "N", reference, "2%", "mesh fitted to the sphere")
        errors.append((resolution, 100*(mean(drags)/reference - 1)))
    axes.plot(*zip(*errors), "o-", color=f"C{colour}", label=f"{liquid}, {velocity:g} m/s")

for run in runs:
    if run["test"] == "pulled":
        name = (f"velocity in the {run['position']} step, {run['liquid']}, "
                f"D/dx {run['D_dx']:g}")
        if run["position"] == "last":
            results.add(name, run["value"], "m/s", run["velocity_m_s"], "3%",
                        "mesh fitted to the sphere")
        else:
            results.report(name, run["value"], "m/s", "on the way from rest")

axes.axhline(0, color="k", lw=0.5)
axes.set_xlabel("mesh cells per diameter")
axes.set_ylabel("error of the drag [%]")
axes.legend(fontsize=8)
save(figure, "shearThinning.png")
results.write()
