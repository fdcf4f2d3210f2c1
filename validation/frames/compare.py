"""A red blood cell and a crowd in shear, seen from several frames: path and angle against those of
the first frame, after the frame's transformation."""

import numpy as np

from frame import matrices, speed
from results import Results, plt, read, save

length, width = 45e-6, 22.5e-6
box = 20e-6                     # of the crowd
# The mesh elsewhere is another discretisation, everything else the same one
otherMesh = ("moving", "by half a mesh cell elsewhere")


class Cell:
    """Path along the flow, along the gradient and along the vorticity [um], angle [rad]; sign is
    that of the flow and of the turn"""

    def __init__(self, row):
        self.name = row["frame"]
        rows = read(row["file"])
        self.t = [r["t_s"] for r in rows]
        flow, gradient, vorticity = "zxy" if self.name == "other axes" else "xyz"
        mirror = -1 if self.name == "mirrored" else 1
        turn = -1 if self.name.startswith("turned") else 1

        x = [r[flow + "_m"] for r in rows]
        for i in range(1, len(x)):
            x[i] -= length*round((x[i] - x[i - 1])/length)
        drift = speed if self.name == "moving" else 0
        first = self.t[0]
        self.x = [1e6*(mirror*turn*(v - x[0]) + drift*(t - first)) for t, v in zip(self.t, x)]
        self.y = [1e6*turn*(r[gradient + "_m"] - width/2) for r in rows]
        start = rows[0][vorticity + "_m"]
        self.z = [1e6*(r[vorticity + "_m"] - start) for r in rows]
        self.angle, last = [0], first
        for r in rows[1:]:
            self.angle.append(self.angle[-1] + mirror*r["omega" + vorticity]*(r["t_s"] - last))
            last = r["t_s"]


class Crowd:
    """Displacements [um] and angles [rad] of all clumps, in the axes of the first frame"""

    def __init__(self, row):
        self.name = row["frame"]
        frame = matrices.get(self.name, np.eye(3))
        rows = read(row["file"])
        times = sorted({r["t_s"] for r in rows})

        def over_time(*names):
            return np.array([[[r[n] for n in names] for r in rows if r["t_s"] == t]
                             for t in times]) @ frame

        steps = np.diff(over_time("x_m", "y_m", "z_m"), axis=0)
        steps -= box*np.round(steps/box)
        if self.name == "moving":
            steps += np.diff(times)[:, None, None]*np.array((speed, 0, 0))
        self.moved = 1e6*np.cumsum(steps, axis=0)
        turned = np.diff(times)[:, None, None]*over_time("omegax", "omegay", "omegaz")[1:]
        self.angle = np.linalg.det(frame)*np.cumsum(turned, axis=0)


results = Results()
rows = read("data.csv")
runs = [Cell(row) for row in rows if row["scene"] == "cell"]
base = runs[0]
path = abs(base.x[-1])
print(f"path {path:.3f} um, angle {base.angle[-1]:.4f}, y {base.y[-1]:.4f} um")
for run in runs[1:]:
    limit = 0.5 if run.name in otherMesh else 0.05
    off = max(abs(getattr(run, c)[-1] - getattr(base, c)[-1]) for c in "xyz")
    turned = abs(run.angle[-1] - base.angle[-1])/abs(base.angle[-1])
    results.add(f"position, {run.name}: difference over the path", 100*off/path, "%", 0, limit,
                "the first frame")
    results.add(f"angle, {run.name}: difference over the angle", 100*turned, "%", 0, limit,
                "the first frame")

# The clump that is furthest off, over the mean of all clumps
crowds = [Crowd(row) for row in rows if row["scene"] == "crowd"]
for run in crowds[1:]:
    for what, mine, its in (("position", run.moved[-1], crowds[0].moved[-1]),
                            ("angle", run.angle[-1], crowds[0].angle[-1])):
        off = np.linalg.norm(mine - its, axis=1).max()
        if what == "angle" and run.name in otherMesh:
            # What the limit of 0.5 % allows the cell alone, whose angle differs by the jitter of
            # the mesh, too, but is ten times as large
            results.add(f"angle, crowd, {run.name}: difference", off, "rad", 0,
                        0.005*abs(base.angle[-1]), "the first frame")
        else:
            results.add(f"{what}, crowd, {run.name}: difference over the mean",
                        100*off/np.linalg.norm(its, axis=1).mean(), "%", 0,
                        0.5 if run.name in otherMesh else 0.05, "the first frame")
if crowds:
    balances = [row for run in crowds
                for row in read(f"history-balance-{run.name.replace(' ', '-')}.csv")]
    for name, what, limit in (("thirdLaw", "third law", 1e-14),
                              ("total", "balance of momentum", 1e-3)):
        results.add(f"{what}, crowd in all frames: largest error over the sum of the forces",
                    max(row[name] for row in balances), "-", 0, limit, "identity")

figure, axes = plt.subplots(figsize=(6, 4))
for run in runs:
    axes.plot([1e3*t for t in run.t], run.y, "k--" if run is base else "-", label=run.name)
axes.set_xlabel("time [ms]")
axes.set_ylabel("distance from the middle [um]")
axes.legend(fontsize=8)
save(figure, "frames.png")
results.write()
