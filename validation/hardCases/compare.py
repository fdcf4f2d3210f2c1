"""Every hard case against what it should do, and the map of stability over time step and damping,
time step and
resolution."""

from results import QUICK, Results, plt, read, save

diameter = 7.82e-6
runs = read("data.csv")


def outcome(run):
    """held: to the end, in one piece, bounded; stopped: by the solver itself, with an error;
    crashed: otherwise."""
    if run["status"] == 0:
        inside = 0 if run["left"] == run["placed"] else run["clumps"]
        whole = inside + run["left"] == run["placed"] and not run["nan"]
        whole = whole and (run["placed"] > 0 or run["name"] == "no clumps")
        # A force of 1000 pN stretches as far as the bonds let it: the shape after the release
        # counts
        bounded = run["longest_m"] < (5 if "release" in run["name"]
                                      else 2.5)*diameter and run["continuity"] < 0.1
        return "held" if whole and bounded else "crashed"
    return "stopped" if run["status"] == 1 else "crashed"


wanted = {"hold": "held", "stop": "stopped", "refuse": "stopped"}
results = Results()
for run in runs:
    found = outcome(run)
    name = f"{run['name']}, D/dx {run['D_dx']:g}, dt {run['deltaT_s']:g} s, {run['steps']:g} steps"
    results.add(name, float(found == wanted[run["should"]]), "-", 1, 0,
                f"should: {wanted[run['should']]}")
    print(f"{name:75s} {found:8s} longest {run['longest_m']/diameter:6.2f} D, last "
          f"{run['last_m']/diameter:6.2f} D, "
          f"{run['seconds']} s")
    if run["name"].startswith("45 per cent") and found == "held":
        results.add(f"{run['name']}: change of the mean volume of the cells",
                    100*(run["volume"] - 1), "%", 0, 1, "first time of the table", known=2.02)
    if "release" in run["name"] and found == "held" and not QUICK:
        results.add(f"{run['name']}: longest diameter long after the release / D",
                    run["last_m"]/diameter, "-", 1, 0.03,
                    "recovers its shape")

groups = [("damping ratio beta",
           [r for r in runs if r["name"].startswith("beta") or r["name"] == "explicit coupling"],
           lambda r: r["name"].replace("beta ", "").replace(" coupling", "\ncoupling")),
          ("D/dx", [r for r in runs if r["name"].startswith("D/dx")], lambda r: f"{r['D_dx']:g}")]
figure, panels = plt.subplots(1, 2, figsize=(11, 4))
for axes, (label, rows, key) in zip(panels, groups):
    keys = list(dict.fromkeys(key(r) for r in rows))
    for r in rows:
        held = outcome(r) == "held"
        axes.plot(keys.index(key(r)), r["deltaT_s"], "o" if held else "x", color="C2" if held
                  else "C3", ms=11, mew=3)
    axes.set_yscale("log")
    axes.set_xticks(range(len(keys)), keys)
    axes.set_xlabel(label)
    axes.set_ylabel("time step [s]")
panels[0].set_title("green: holds, red: lost and stopped", fontsize=9)
save(figure, "hardCases.png")
results.write()
