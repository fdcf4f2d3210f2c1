"""A red blood cell in shear over the time step and the number of outer correctors: position, angle
and drift against the converged run; the direction in which a cell beside a wall drifts."""

from math import log, pi

from results import Results, at_one_speed, plt, read, save

# Length of the domain [m]
periods = {scene: 45e-6 for scene in
           ("shear", "order", "shear for 0.1 s", "fast shear", "refined mesh", "32 cells")}
periods["tube"] = 40e-6
middle = 11.25e-6

results = Results()
runs = read("data.csv")
at_one_speed(runs, "seconds")


def steady(values, period):
    """Without the jumps by a period."""
    result, shift = values[:1], 0
    for last, value in zip(values, values[1:]):
        shift -= period*round((value - last)/period)
        result.append(value + shift)
    return result


def slope(x, y):
    """Of the line through points, least squares."""
    mx, my = sum(x)/len(x), sum(y)/len(y)
    return sum((a - mx)*(b - my) for a, b in zip(x, y))/sum((a - mx)**2 for a in x)


class Run:
    """What came of a run, in um, rad and um/s: of every clump the last place, its displacement
    along the flow and its angle; of the first one y over time and the drift away from the middle.
    """

    def __init__(self, row):
        self.row = row
        rows = read(row["file"])
        self.t = sorted({r["t_s"] for r in rows})
        clumps = sorted({r["clump"] for r in rows})
        self.last, self.angles, paths = [], [], []
        for clump in clumps:
            own = [r for r in rows if r["clump"] == clump]
            x = steady([r["x_m"] for r in own], periods[row["scene"]])
            self.last.append((1e6*x[-1], 1e6*own[-1]["y_m"], 1e6*own[-1]["z_m"]))
            self.angles.append(steady([r["phase"] for r in own], 2*pi)[-1])
            paths.append(1e6*abs(x[-1] - x[0]))
        self.path = sum(paths)/len(paths)
        centre = 0 if row["scene"] == "tube" else middle
        self.y = [1e6*(r["y_m"] - centre) for r in rows if r["clump"] == clumps[0]]
        half = len(self.t)//2
        self.drift = slope(self.t[half:], self.y[half:])

    def key(self):
        """What its reference shares with it."""
        return self.row["scene"], self.row["y_um"]

    def name(self):
        row = self.row
        start = f", {row['y_um']:g} um" if row["y_um"] else ""
        text = (f"{row['scene']}{start}, {row['settings']} settings, step {row['deltaT_s']:g} s, "
                f"{row['most_correctors']:g} corrector")
        text += "s" if row["most_correctors"] > 1 else ""
        return text + (f" at most, tolerance {row['tolerance']:g}" if row["tolerance"] else "")

    def misses(self, goal):
        """In percent of the path, percent of the angle, um/s."""
        far = max(abs(a - b) for mine, its in zip(self.last, goal.last) for a, b in zip(mine, its))
        turned = max(abs(a - b) for a, b in zip(self.angles, goal.angles))
        return (100*far/goal.path, 100*turned/max(map(abs, goal.angles)), self.drift - goal.drift)


def limits(row):
    """In position, angle and drift, of the runs that have some."""
    if row["scene"] == "shear" and row["settings"] == "long" and row["deltaT_s"] == 1e-3 \
            and row["most_correctors"] == 2:
        return 0.5, 0.5, 1
    right = row["settings"] in ("long", "absolute")
    if row["scene"] == "shear for 0.1 s" and right \
            or row["scene"] == "refined mesh" and right \
            and row["deltaT_s"] == 1e-3 and row["most_correctors"] == 3 \
            or row["scene"] == "32 cells" and row["tolerance"] == 0.005:
        return 0.5, 0.5, 0.3
    return None


# The recorded miss, explained in README.md: position and drift of the shear for 0.1 s, by settings,
# step and most correctors
known = {("long", 1e-3, 1): (4.15992, None)}

# Shown for comparison, without limits
shown = "usual", "loose", "looseP"


def order(converged):
    """Differences to the finest step, and the order of convergence from one step to the next."""
    if not converged:
        return
    converged = sorted(converged, key=lambda run: -run.row["deltaT_s"])
    finest, last = converged[-1], None
    for run in converged[:-1]:
        off = run.misses(finest)[:2]
        step = run.row["deltaT_s"]
        text = f"converged, step {step:g} s against {finest.row['deltaT_s']:g} s"
        for what, value in zip(("position over the path", "angle"), off):
            results.report(f"{text}: {what}", value, "%", "finest step")
        if last:
            for what, mine, its in zip(("position", "angle"), off, last[1]):
                # The finest step has an error, too, which raises the order of the last steps
                results.report(f"{text}: order of the {what}", log(its/mine)/log(last[0]/step), "",
                               "1 is first order")
        last = step, off


everything = [Run(r) for r in runs]
order([run for run in everything if run.row["scene"] == "order"])
everything = [run for run in everything if run.row["scene"] != "order"]
reference = {r.key(): r for r in everything if r.row["settings"] == "reference"}

print("path [um], y [um], angle, drift [um/s]; off by % of the path, % of the angle, um/s; "
      "correctors, seconds")
for run in everything:
    row = run.row
    goal = reference[run.key()]
    off = run.misses(goal)
    print(f"{run.name()}: {run.path:.3f} {run.y[-1]:.4f} {run.angles[0]:.4f} {run.drift:.2f}; "
          f"{off[0]:.3f} {off[1]:.3f} {off[2]:.2f}; {row['correctors']:.2f}, {row['seconds']:.1f}")
    if row["y_um"] > 4 and row["settings"] not in shown:
        results.add(f"drift towards the wall, {run.name()}", run.drift, "um/s", -1.5, 1.4,
                    "away from the wall")
    if row["scene"] == "tube" and row["settings"] not in shown:
        results.add(f"drift towards the wall, {run.name()}", run.drift, "um/s", -1.5, 1.4,
                    "towards the axis")
    if run is goal:
        continue
    if row["end_s"] == 0.1:
        results.report(f"time, {run.name()}", row["seconds"]/row["unit_s"], "-",
                       "times one corrector of the usual settings, 1e-3 s, for 30 ms")
    allowed = limits(row)
    names = "position: difference over the path", "angle: difference over the angle", \
        "drift: difference"
    for i, (what, value, unit) in enumerate(zip(names, off, ("%", "%", "um/s"))):
        if allowed:
            missed = (None, None)
            if row["scene"] == "shear for 0.1 s":
                missed = known.get(
                    (row["settings"], row["deltaT_s"], row["most_correctors"]), missed)
            results.add(f"{what}, {run.name()}", value, unit, 0, allowed[i], "converged",
                        known=(missed[0], None, missed[1])[i])
        else:
            results.report(f"{what}, {run.name()}", value, unit, "converged")

figure, both = plt.subplots(1, 2, figsize=(10, 4))
for axes, start in zip(both, (("shear", 3), ("shear", 6.25))):
    for run in everything:
        if run.key() == start and run.row["deltaT_s"] == 1e-3 and not run.row["tolerance"]:
            axes.plot([1e3*t for t in run.t], run.y,
                      "k--" if run is reference[start] else "-",
                      label=f"{run.row['settings']}, {run.row['most_correctors']:g}")
    axes.set_xlabel("time [ms]")
    axes.set_ylabel("distance from the middle [um]")
    axes.legend(title="settings, outer correctors", title_fontsize=8, fontsize=8)
save(figure, "timeStep.png")
results.write()
