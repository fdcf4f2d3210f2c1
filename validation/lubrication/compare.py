"""Approach of a sphere to a wall and of two spheres: Brenner 1961, bispherical coordinates.

held.csv: normal drag over 6 pi mu a U without lubrication. What lacks below the cut-off is what the
model adds: (1 - sqrt(e/e_c))/e for a wall, half of it for two spheres, e being the gap over a.
pressed.csv: the gap under a constant force; dg/dt = -F/(6 pi mu a lambda), twice that for a
pair."""

from math import acosh, cosh, log, sinh

from results import Results, plt, read, save

SOURCE = "Brenner 1961"
CUT_OFF = {"wall": 1.3, "pair": 0.85}   # mesh cells, in squeezeFilm
PLACE = "0.37 0.21 0.11"    # of most spheres, from a corner of a mesh cell, in mesh cells
FROM, TO = 0.5, 0.05        # gaps over a between which a sphere is timed


def exact(scene, gap):
    """Drag over 6 pi mu a U of a sphere moving to a wall, or to another one that meets it."""
    solid = scene == "wall"
    a = acosh(1 + gap*(1 if solid else 0.5))
    total, n = 0, 1
    while (2*n + 1)*a < 600:
        k, b = n*(n + 1)/((2*n - 1)*(2*n + 3)), (2*n + 1)*a
        if solid:
            term = (2*sinh(b) + (2*n + 1)*sinh(2*a))/(
                4*sinh(b/2)**2 - ((2*n + 1)*sinh(a))**2)
        else:
            term = (4*cosh(b/2)**2 + ((2*n + 1)*sinh(a))**2)/(
                2*sinh(b) - (2*n + 1)*sinh(2*a))
        total += k*(term - 1)
        if abs(term - 1) < 1e-12:
            break
        n += 1
    return 4/3*sinh(a)*total


def added(scene, gap, resolution):
    """What the model adds to the drag, in the same unit."""
    cut = CUT_OFF[scene]*2/resolution
    return max((1 - (gap/cut)**0.5)/gap*(1 if scene == "wall" else 0.5), 0)


def time(scene, low, high):
    """From one gap to the other under 6 pi mu a 1e-3 m/s [s]."""
    n, total = 400, 0
    for k in range(n):
        gap = low*(high/low)**((k + 0.5)/n)
        total += exact(scene, gap)*gap*log(high/low)/n
    return total*2e-6/1e-3/(1 if scene == "wall" else 2)


def crossing(points, level):
    """Time at which the gap falls to a level; None if it does not."""
    for (t0, g0), (t1, g1) in zip(points, points[1:]):
        if g0 >= level > g1:
            return t0 + (t1 - t0)*(log(g0) - log(level))/(log(g0) - log(max(g1, 1e-9)))
    return None


results = Results()
errors = {"wall": [], "pair": []}
figure, axes = plt.subplots(1, 2, figsize=(9, 4))
for colour, scene in enumerate(("wall", "pair")):
    gaps = [0.04*1.06**k for k in range(60)]
    axes[0].plot(gaps, [exact(scene, g) for g in gaps], color=f"C{colour}",
                 label=f"{scene}, exact")
for row in read("held.csv"):
    scene, gap, resolution = row["scene"], row["gap"], row["D_dx"]
    total = row["lambda"] + added(scene, gap, resolution)
    name = f"{scene} gap/a {gap:g} D/dx {resolution:g}"
    if row["place_cells"] != PLACE:
        name += f" at ({row['place_cells']})"
    errors[scene].append(total/exact(scene, gap) - 1)
    results.report(f"drag without lubrication, {name}", row["lambda"], "6 pi mu a U",
                   f"exact {exact(scene, gap):.4g}")
    results.add(f"drag with it, {name}", total, "6 pi mu a U", exact(scene, gap), "17%", SOURCE)
    colour = 0 if scene == "wall" else 1
    axes[0].plot(gap, row["lambda"], "x", color=f"C{colour}")
    axes[0].plot(gap, total, "o" if resolution == 4 else "s", mfc="none", color=f"C{colour}")
for scene, all_errors in errors.items():
    results.report(f"error of the drag with it, {scene}, root mean square",
                   100*(sum(e*e for e in all_errors)/len(all_errors))**0.5, "%",
                   f"of {len(all_errors)} spheres")
axes[0].set_xscale("log")
axes[0].set_yscale("log")
axes[0].set_xlabel("gap/a")
axes[0].set_ylabel("drag/(6 pi mu a U): mesh alone (x), with the film")
axes[0].legend()

runs = {}
for row in read("pressed.csv"):
    key = row["body"], row["scene"], row["film"]
    runs.setdefault(key, []).append((row["time"], row["gap"]))
for (body, scene, film), points in runs.items():
    start, end = crossing(points, FROM), crossing(points, TO)
    name = f"time from gap/a {FROM:g} to {TO:g}, {body}, {scene}"
    spent = end - start if start and end else float("nan")
    if film == "on":
        results.add(name, spent, "s", time(scene, TO, FROM), "10%", SOURCE)
    else:
        results.report(f"{name}, without the film", spent, "s",
                       f"exact {time(scene, TO, FROM):.3g}")
    drawn = [(1e3*t, g) for t, g in points if g > 0.01]
    axes[1].plot([t for t, _ in drawn], [g for _, g in drawn],
                 {"sphere": "-", "capsule": "--"}[body] if film == "on" else ":",
                 color=f"C{0 if scene == 'wall' else 1}",
                 label=f"{body}, {scene}" + ("" if film == "on" else ", no film"))
axes[1].set_yscale("log")
axes[1].set_xlabel("time [ms]")
axes[1].set_ylabel("gap/a")
axes[1].set_title("under a constant force")
axes[1].legend(fontsize=8, loc="upper right")
save(figure, "lubrication.png")
results.write()
