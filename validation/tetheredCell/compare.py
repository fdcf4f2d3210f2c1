"""Drag over velocity of the tethered cell against a reference without a mesh and against D/dx = 8;
the cell of the other tutorials, mesh, time step, the bead's share, and what the paper's own
settings cost."""

import glob
import os
import re
import sys
from results import Results, plt, read, save, write_table
from clumps import seconds_of_steps, table
sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)),
                             "../../tutorials/tetheredCell/microchannel"))
from cellDrag import reference, spheres  # noqa: E402

COLUMNS = ("D_dx deltaT_s velocity_um_s settings end_s cell_pN reference_pN bead_pN axial_um "
           "transverse_um "
           "seconds_per_step").split()


def seconds_per_step(folder):
    """Median of the steps past the first ten."""
    steps = sorted(seconds_of_steps(folder)[11:])
    return steps[len(steps)//2]


def last(folder, name, clump):
    """Last row of a table for a type of clump; none without such a clump."""
    rows = table(folder, name, type=clump)
    return rows[-1] if rows else None


def row(folder):
    """One run: what it was, forces [pN], diameters [um], reference, seconds."""
    resolution, step, velocity = re.match(r"([\d.]+)-(literal|again|[\d.]+e-\d)-(\d+)",
                                          folder).groups()
    bead, cell, shape = (last(folder, *what) for what in (
        ("clumpForce", "bead"), ("clumpForce", "healthy"), ("clumpShape", "healthy")))
    result = {
        "D_dx": float(resolution), "deltaT_s": {"literal": 1e-6, "again": 1e-3}.get(step)
        or float(step), "velocity_um_s": int(velocity),
        "settings": step if step in ("literal", "again") else "bead alone"
        if folder.endswith("bead") else "healthy" if folder.endswith("healthy") else "ours",
        "end_s": bead["time"], "bead_pN": 1e12*bead["Fx"],
        "seconds_per_step": seconds_per_step(folder),
    }
    if cell:
        result |= {"cell_pN": 1e12*cell["Fx"], "axial_um": 1e6*shape["L1"],
                   "transverse_um": 1e6*shape["L2"]}
    if result["settings"] in ("ours", "healthy"):
        x, a, clump = spheres(folder)
        result["reference_pN"] = reference(x, a, clump == 1, result["velocity_um_s"])
    return result


runs = [row(folder) for folder in sorted(glob.glob("[0-9]*-*"))]
write_table("data.csv", COLUMNS, [[run.get(c, "") for c in COLUMNS] for run in runs])


def ours(resolution=None, step=None, velocity=None, settings="ours"):
    return sorted((r for r in runs if r["settings"] == settings
                   and resolution in (None, r["D_dx"]) and step in (None, r["deltaT_s"])
                   and velocity in (None, r["velocity_um_s"])), key=lambda r: r["velocity_um_s"])


def over_u(run, key="cell_pN"):
    return run[key]/run["velocity_um_s"]


def at_finest(velocity):
    """F_D/u at D/dx = 8, linear between the velocities computed."""
    low, high = ours(8)
    part = (velocity - low["velocity_um_s"])/(high["velocity_um_s"] - low["velocity_um_s"])
    return over_u(low) + part*(over_u(high) - over_u(low))


source = "points on the surface, in the periodic slit (cellDrag.py)"
limit = "1%"

results = Results()
sweep = ours(4, 1e-3)
for run in sweep or ours(4):
    u = run["velocity_um_s"]
    results.add(f"F_D/u at {u} um/s, D/dx 4, independent reference", over_u(run), "pN s/um",
                over_u(run, "reference_pN"), limit, source)
    if ours(8):
        results.add(f"F_D/u at {u} um/s, D/dx 4, finest mesh", over_u(run), "pN s/um", at_finest(u),
                    "2%", "D/dx = 8")
for run in ours(6) + ours(8):
    results.add(
        f"F_D/u at {run['velocity_um_s']} um/s, D/dx {run['D_dx']:g}, independent reference",
        over_u(run), "pN s/um", over_u(run, "reference_pN"), limit, source)
for run in ours(settings="healthy"):
    results.add(f"F_D/u at {run['velocity_um_s']} um/s, present cell, D/dx {run['D_dx']:g}",
                over_u(run), "pN s/um", over_u(run, "reference_pN"), limit, source)
fine = ours(4, 2e-4)
for run in ours(4, velocity=980) if fine else []:
    if run is not fine[0]:
        results.add(f"F_D/u at {run['deltaT_s']:g} s", over_u(run), "pN s/um", over_u(fine[0]),
                    "0.2%", "2e-4 s")

for run in ours(4, 4e-3) if sweep else []:
    u = run["velocity_um_s"]
    results.add(f"F_D/u at {u} um/s, step 4e-3 s over 1e-3 s", over_u(run)/over_u(
        ours(4, 1e-3, u)[0]), "-", 1, "0.2%", "step 1e-3 s")

alone = [r for r in runs if r["settings"] == "bead alone"]
if alone:
    run = ours(4, 1e-3, 980)[0]
    print(f"Drag at 980 um/s: {run['cell_pN']:.2f} pN on the cell; "
          f"{run['cell_pN'] + run['bead_pN']:.2f} pN on cell and "
          f"bead less {alone[0]['bead_pN']:.2f} pN on the bead alone: "
          f"{run['cell_pN'] + run['bead_pN'] - alone[0]['bead_pN']:.2f} pN")

for literal in (r for r in runs if r["settings"] == "literal"):
    same = next(r for r in runs if r["settings"] == "again"
                and r["velocity_um_s"] == literal["velocity_um_s"])
    exact = at_finest(literal["velocity_um_s"])
    print("settings   time step   F_D/u    error against D/dx 8   seconds per simulated second")
    for name, run in ("literal", literal), ("ours", same):
        print(f"{name:10s} {run['deltaT_s']:6g} s  {over_u(run):8.4f}  "
              f"{100*(over_u(run)/exact - 1):8.1f} %"
              f"  {run['seconds_per_step']/run['deltaT_s']:18.3g}")
    ratio = (literal["seconds_per_step"]/literal["deltaT_s"]
             / (same["seconds_per_step"]/same["deltaT_s"]))
    print(f"Ours costs {ratio:.0f} times less")

if sweep:
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13, 4.2))
    speeds = [r["velocity_um_s"] for r in sweep]
    left.plot(speeds, [over_u(r) for r in sweep], "o-", label="D/dx = 4")
    for resolution, mark in (6, "^"), (8, "s"):
        if ours(resolution):
            left.plot([r["velocity_um_s"] for r in ours(resolution)],
                      [over_u(r) for r in ours(resolution)], mark,
                      mfc="none", label=f"D/dx = {resolution}")
    left.plot(speeds, [over_u(r, "reference_pN") for r in sweep], "k--",
              label="reference without a mesh")
    if os.path.exists("experiment.csv"):
        points = read("experiment.csv")
        left.errorbar([p["velocity_um_s"] for p in points],
                      [p["FD_over_u_pN_s_um"] for p in points],
                      [p["error"] for p in points], fmt="kD", label="experiment")
    left.set_xlabel("mean velocity [um/s]")
    left.set_ylabel("drag on the cell / mean velocity [pN s/um]")
    left.set_ylim(0, 1.3*max(over_u(r) for r in sweep))
    left.legend(fontsize=8)

    middle.plot(speeds, [r["axial_um"] for r in sweep], "o-", label="along the flow")
    middle.plot(speeds, [r["transverse_um"] for r in sweep], "s-", label="across")
    middle.axhline(7.82, color="k", ls="--", lw=0.8, label="at rest")
    middle.set_ylim(0, None)
    middle.set_xlabel("mean velocity [um/s]")
    middle.set_ylabel("diameter of the cell [um]")
    middle.legend(fontsize=8)

    for i, run in enumerate((sweep[0], sweep[-1])):
        x, a, clump = spheres(f"4-1e-3-{run['velocity_um_s']}")
        for centre, radius, which in zip(x, a, clump):
            right.add_patch(plt.Circle(centre[:2] + (0, -12*i), radius, alpha=0.5, lw=0,
                                       color="C3" if which else "C0"))
        right.text(13, 30 - 12*i, f"{run['velocity_um_s']} um/s", fontsize=9)
    right.set_xlim(12, 36)
    right.set_ylim(7, 32)
    right.set_aspect("equal")
    right.grid(False)
    right.set_xlabel("x [um]")
    right.set_yticks([])
    save(figure, "tetheredCell.png")

results.write()
