"""A red blood cell in shear over the time step and the number of outer correctors: position, angle
and drift against the converged run; the direction in which a cell beside a wall drifts."""

from math import pi

from results import Results, plt, read, save

length = 45e-6      # of the periodic box [m]
middle = 11.25e-6

results = Results()
runs = read("data.csv")


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
    """What came of a run, in um, rad and um/s."""

    def __init__(self, row):
        self.row = row
        rows = read(row["file"])
        self.t = [r["t_s"] for r in rows]
        x = steady([r["x_m"] for r in rows], length)
        self.path = 1e6*(x[-1] - length/2)
        self.y = [1e6*(r["y_m"] - middle) for r in rows]
        self.angle = steady([r["phase"] for r in rows], 2*pi)[-1]
        half = len(rows)//2
        self.drift = slope(self.t[half:], self.y[half:])

    def name(self):
        row = self.row
        text = (f"{row['settings']} settings, {row['y_um']:g} um, step {row['deltaT_s']:g} s, "
                f"{row['most_correctors']:g} corrector")
        text += "s" if row["most_correctors"] > 1 else ""
        return text + (f" at most, tolerance {row['tolerance']:g}" if row["tolerance"] else "")


everything = [Run(r) for r in runs]
reference = {r.row["y_um"]: r for r in everything if r.row["settings"] == "reference"}

print("settings, y, step, correctors: path [um], y [um], angle, drift [um/s], correctors, seconds")
for run in everything:
    row = run.row
    goal = reference[row["y_um"]]
    print(f"{row['settings']}, {row['y_um']:g} um, {row['deltaT_s']:g} s, "
          f"{row['most_correctors']:g} ({row['tolerance']:g}): {run.path:.3f} {run.y[-1]:.4f} "
          f"{run.angle:.4f} {run.drift:.2f}, {row['correctors']:.2f}, {row['seconds']:.1f}")
    if row["y_um"] > 4 and row["settings"] != "usual":
        results.add(f"drift towards the wall, {run.name()}", run.drift, "um/s", -1.5, 1.4,
                    "away from the wall")
    if run is goal:
        continue
    moved = [run.path - goal.path, run.y[-1] - goal.y[-1]]
    values = [("position: difference over the path", 100*max(map(abs, moved))/goal.path, "%", 0.5),
              ("angle: difference over the angle", 100*(run.angle/goal.angle - 1), "%", 0.5),
              ("drift: difference", run.drift - goal.drift, "um/s", 1)]
    tested = row["settings"] == "longTight"
    for what, value, unit, limit in values:
        if tested:
            results.add(f"{what}, {run.name()}", value, unit, 0, limit, "converged")
        else:
            results.report(f"{what}, {run.name()}", value, unit, "converged")

figure, both = plt.subplots(1, 2, figsize=(10, 4))
for axes, start in zip(both, sorted(reference)):
    for run in everything:
        if run.row["y_um"] == start and run.row["deltaT_s"] == 1e-3 and not run.row["tolerance"]:
            axes.plot([1e3*t for t in run.t], run.y,
                      "k--" if run is reference[start] else "-",
                      label=f"{run.row['settings']}, {run.row['most_correctors']:g}")
    axes.set_xlabel("time [ms]")
    axes.set_ylabel("distance from the middle [um]")
    axes.legend(title="settings, outer correctors", title_fontsize=8, fontsize=8)
save(figure, "timeStep.png")
results.write()
