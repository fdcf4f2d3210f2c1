"""What each device of the coupled step buys: difference from the converged run of the same step,
number of outer correctors, largest residual."""

from results import Results, plt, read, save

PERIODS = {"shear": 45e-6, "crowd": 45e-6, "refined": 45e-6, "tube": 40e-6,
           "longTube": 90e-6, "stack": 18.6e-6}
# Misses that the README explains: scene, sliding
KNOWN = {("crowd", "off"): 1.5739, ("crowd", "auto"): 1.57497}
SOURCE = "the converged run of the same step"

results = Results()
rows = read("data.csv")


def paths(row):
    """Of every clump, its places without the jumps by a period."""
    table = read(row["file"])
    found = {}
    for entry in table:
        found.setdefault(entry["clump"], []).append([entry[c] for c in ("x_m", "y_m", "z_m")])
    period = PERIODS.get(row["scene"])
    for places in found.values():
        for before, after in zip(places, places[1:]):
            if period:
                after[0] -= period*round((after[0] - before[0])/period)
    return found


def distance(a, b):
    return sum((x - y)**2 for x, y in zip(a, b))**0.5


def miss(row, goal):
    """Largest difference at the end over the mean path, in percent."""
    mine, its = paths(row), paths(goal)
    path = sum(distance(p[0], p[-1]) for p in its.values())/len(its)
    return 100*max(distance(mine[clump][-1], its[clump][-1]) for clump in its)/path


reference = {row["scene"]: row for row in rows if row["settings"] == "reference"}
print("scene, settings, sliding: off by % of the path, outer correctors, worst residual, seconds")
points = {}
for row in rows:
    if row["settings"] == "reference":
        continue
    off = miss(row, reference[row["scene"]])
    name = f"{row['scene']}, {row['settings']}" + ", sliding mesh"*(row["sliding"] == "auto")
    print(f"{name}: {off:.3f}, {row['correctors']:.2f}, {row['worst_residual']:.3g}, "
          f"{row['seconds']:.1f}")
    if row["settings"] == "all":
        results.add(f"{name}: difference over the path", off, "%", 0, 0.5, SOURCE,
                    KNOWN.get((row["scene"], row["sliding"])))
    else:
        results.report(f"{name}: difference over the path", off, "%", SOURCE)
    results.report(f"{name}: outer correctors", row["correctors"], "-", "mean of the steps")
    points.setdefault(row["settings"], []).append((row["correctors"], off))

figure, axes = plt.subplots()
for (settings, values), marker in zip(points.items(), "os^v<>DPX*hdp8+x"):
    axes.semilogy(*zip(*values), marker, label=settings)
axes.set_xlabel("outer correctors in a step")
axes.set_ylabel("difference from the converged run [% of the path]")
axes.legend(fontsize="small")
save(figure, "ablation.png")
results.write()
