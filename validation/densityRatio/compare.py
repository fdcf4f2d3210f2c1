"""Terminal velocities at a step of 1e-4 s against those at 1e-5 s, and the size of the cell in
shear, for densities of 0.1 to 1000 times that of the fluid."""

from results import Results, mean, plt, read, save

outer, thickness = 7.82e-6, 3.91e-6


def last_quarter(run):
    """Mean velocity over the last quarter of the run."""
    return mean([r["velocity_m_s"] for r in read(run["file"]) if r["t_s"] > 0.75*run["end_s"]])


results = Results()
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2))
runs = read("data.csv")
settling = [r for r in runs if r["test"] == "settling"]
fine = {r["density_ratio"]: r for r in settling if r["deltaT_s"] == 1e-5}

for run in settling:
    ratio = run["density_ratio"]
    if run["deltaT_s"] == 1e-5:
        continue
    velocity = last_quarter(run)
    if ratio == 1:
        results.add("velocity x step / D at density ratio 1", velocity*1e-4/outer, "-", 0, 1e-15,
                    "Archimedes")
    else:
        results.add(f"terminal velocity at density ratio {ratio:g}, step 1e-4, {run['outer']:g} "
                    f"outer correctors",
                    velocity, "m/s", last_quarter(fine[ratio]), "0.1%" if ratio <= 8 else "1%",
                    "step 1e-5")

for colour, ratio in enumerate(r for r in fine if r != 1):
    for run in settling:
        if run["density_ratio"] == ratio:
            small = run["deltaT_s"] == 1e-5
            rows = read(run["file"])[::1 if small else 8]
            left.plot([1e3*r["t_s"] for r in rows],
                      [1e6*r["velocity_m_s"]/(ratio - 1) for r in rows],
                      "-" if small else "o" if run["outer"] == 2 else "x", ms=4, mfc="none",
                      color=f"C{colour}",
                      label=f"density ratio {ratio:g}" if small else None)
left.plot([], [], "ko", ms=4, mfc="none", label="step 1e-4 s (lines: 1e-5 s)")
left.plot([], [], "kx", ms=4, label="4 outer correctors")
left.set_xlabel("time [ms]")
left.set_ylabel("settling velocity / (density ratio - 1) [um/s]")
left.legend(fontsize=8)

for colour, run in enumerate(r for r in runs if r["test"] == "shear"):
    rows = read(run["file"])
    # the lighter, the softer: see the README
    limit = 0.2 if run["density_ratio"] < 0.5 else 0.1
    name = f"in shear at density ratio {run['density_ratio']:g}"
    results.add(f"longest diameter / D, {name}", max(r["L1_m"] for r in rows)/outer, "-", 1, limit,
                "bounded")
    results.add(f"shortest diameter / D, {name}", min(r["L2_m"] for r in rows)/outer, "-", 1, limit,
                "bounded")
    results.add(f"thickness / rest, {name}", max(r["L3_m"] for r in rows)/thickness, "-", 1, 0.01,
                "not crumpled")
    right.plot([1e3*r["t_s"] for r in rows], [-r["rate"] for r in rows], color=f"C{colour}", lw=1,
               label=f"density ratio {run['density_ratio']:g}")
right.set_xlabel("time [ms]")
right.set_ylabel("rotation in shear of 200 1/s [1/s]")
right.legend(fontsize=8, ncol=2)
save(figure, "densityRatio.png")
results.write()
