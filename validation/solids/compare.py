"""Deformation of a solid sphere in shear over time, against the exact ellipsoid."""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "reference"))
from ellipsoid import course, spheroid  # noqa: E402
from results import Results, plt, read, save  # noqa: E402

# Misses of D by nodes outside, viscosity ratio and Poisson ratio, see the page
KNOWN = {(2, 5, 0.4): 0.13594}

# Misses of the relaxation time by step, nodes outside and box
RELAXATION = {(0.05, 2, 4): 0.58409, (0.025, 2, 4): 0.58453, (0.05, 2, 6): 0.53031,
              (0.05, 3, 4): 0.59437}

# Of its turn, by box
TURN = {6: -0.591}

SOURCE = "exact ellipsoid in unbounded shear (reference/ellipsoid.py)"

runs = {}
for r in read("data.csv"):
    key = (int(r["D_dx"]), r["step"], int(r["subdivisions"]), r["ratio"], r["Ca"], r["poisson"],
           r["box"])
    runs.setdefault(key, []).append(r)

results = Results()

# The reference itself: at rest in an extensional flow, against another solution
results.add("reference, stretch in an extensional flow, capillary number 0.1",
            course("extension", 0.1, 1, 3)[-1][3], "-", spheroid(0.1), "0.05%",
            "stresslet of a prolate spheroid, Kim and Karrila 1991")

# The Poisson ratio of the tetrahedra is not that of the solid
usual = runs.get((10, 0.05, 2, 1, 0.2, 0.4, 8))
other = runs.get((10, 0.05, 2, 1, 0.2, 0.2, 8))
if usual and other:
    results.add("D with a Poisson ratio of 0.2 over that with 0.4", other[-1]["D"]/usual[-1]["D"],
                "-", 1, 0.01, "no dependence")

# Extrapolated over the mesh in the second order; what is left is the box
coarse = {r["t"]: r["D"] for r in runs.get((10, 0.05, 3, 1, 0.2, 0.4, 8), [])}
for r in runs.get((13, 0.05, 3, 1, 0.2, 0.4, 8), [])[-1:]:
    D = r["D"] + (r["D"] - coarse[r["t"]])/((13/10)**2 - 1)
    results.add(f"D at t = {r['t']:g} extrapolated from 10 and 13 cells, 642 nodes outside", D,
                "-", course("shear", 0.2, 1, r["t"])[-1][1], "2%", SOURCE)

figure, axes = plt.subplots()
exact = {}
for key, rows in runs.items():
    cells, step, subdivisions, ratio, Ca, poisson, box = key
    end = rows[-1]["t"]
    name = (f"Ca {Ca:g}, {cells} cells, step {step:g}, {10*4**subdivisions + 2} nodes outside, "
            f"box of {box:g} R")
    if ratio != 1:
        name += f", viscosity ratio {ratio:g}"
    if poisson != 0.4:
        name += f", Poisson ratio {poisson:g}"

    last = rows[-1]
    results.add(f"volume, {name}", max((r["volume"] for r in rows), key=lambda v: abs(v - 1)), "-",
                1, 1e-6, "volume at rest")
    results.report(f"outer correctors, {name}", last["correctors"], "-", "mean of the steps")
    if end > 20:
        # A long run in a narrow box: it has no reference but itself
        early, late = ([r["D"] for r in rows if t <= r["t"] < t + 10] for t in (10, end - 10))
        results.add(f"mean D of the last ten shear times, {name}", sum(late)/len(late), "-",
                    sum(early)/len(early), "0.5%", "mean from 10 to 20")
        results.add(f"smallest over largest D of the last ten, {name}", min(late)/max(late), "-",
                    1, 0.02, "steady")
        continue
    known = (ratio, Ca)
    if known not in exact or exact[known][-1][0] < end:
        exact[known] = course("shear", Ca, ratio, end)

    def at(t, column):
        return min(exact[known], key=lambda r: abs(r[0] - t))[column]

    results.add(f"D at t = {end:g}, {name}", last["D"], "-", at(end, 1), "5%", SOURCE,
                KNOWN.get((subdivisions, ratio, poisson)))
    results.add(f"angle at t = {end:g}, {name}", last["angle_deg"], "degrees", at(end, 2), 1.5,
                SOURCE)
    axes.plot([r["t"] for r in rows], [r["D"] for r in rows], ".", ms=4, label=name)
for (ratio, Ca), rows in exact.items():
    axes.plot([r[0] for r in rows], [r[1] for r in rows], "k", lw=0.8)

# Released after one shear time: the creep back does not depend on the deformation at its beginning
releases = {}
for r in read("release.csv"):
    releases.setdefault((r["step"], int(r["subdivisions"]), r["box"]), []).append(r)


def relaxation(found):
    """Time in which D falls by a factor of e, from t = 1.2 to 2.2"""
    first, last = (next(D for t, D in found if abs(t - when) < 1e-6) for when in (1.2, 2.2))
    return 1/math.log(first/last)


reference = course("shear", 0.2, 1, 2.4, until=1)
exactTime = relaxation([r[:2] for r in reference])
times = {key: relaxation([(r["t"], r["D"]) for r in rows]) for key, rows in releases.items()}
for (step, subdivisions, box), rows in releases.items():
    name = (f"released, {10*4**subdivisions + 2} nodes outside, box of {box:g} R, "
            f"step {step:g}")
    results.add(f"relaxation time, {name}", times[step, subdivisions, box], "shear times",
                exactTime, "5%", SOURCE, RELAXATION.get((step, subdivisions, box)))
    if box > 4:
        # Between closer walls it turns
        turned = [r["angle_deg"] for r in rows if 1.2 <= r["t"] <= 2.2]
        results.add(f"turn from t = 1.2 to 2.2, {name}", turned[-1] - turned[0], "degrees", 0,
                    0.5, "none: no torque acts on it", TURN.get(box))
    results.add(f"largest deviation of the volume, {name}",
                max((r["volume"] for r in rows), key=lambda v: abs(v - 1)), "-", 1, 1e-6,
                "volume at rest")
    axes.plot([r["t"] for r in rows], [r["D"] for r in rows], "x", ms=4, label=name)
axes.plot([r[0] for r in reference], [r[1] for r in reference], "k--", lw=0.8)

# Walls and images act with the third power of the radius over their distance
boxes = [box for box in (4, 6, 8) if (0.05, 2, box) in times]
if len(boxes) == 3:
    a, b, c = (times[0.05, 2, box] for box in boxes)
    without = c - (b - c)*8**-3/(6**-3 - 8**-3)
    results.add("relaxation time with 162 nodes outside, box of 4 R, from those of 6 and 8 R", a,
                "shear times", without + (c - without)*(8/4)**3, "2%", "third power of the box")
    results.add("relaxation time with 162 nodes outside, extrapolated over the box", without,
                "shear times", exactTime, "5%", SOURCE)
if (0.025, 2, 4) in times:
    results.add("relaxation time with half the step over that with the whole",
                times[0.025, 2, 4]/times[0.05, 2, 4], "-", 1, 0.01, "no dependence")
axes.set(xlabel="time x shear rate", ylabel="Taylor deformation")
axes.legend(fontsize=7)
save(figure, "solids.png")
results.write()
