"""Counts the red cells that pass the stenosis, and draws them with their lengths.

Reads postProcessing/clumpPassages (what entered and left), clumpForce (places, velocities),
clumpShape (lengths) and VTK/clumps (the spheres). Writes result.csv and result.png.
"""

import csv
import math
import re
import sys
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumps import drawSpheres, frames, table

VOLUME = 94             # of a red cell [um3]
DEPTH = 10              # of the channel [um]
# name: from and to in x [um]
SECTIONS = {"before": (6, 18), "throat": (27, 33), "behind": (42, 54)}


with open("system/blockMeshDict") as file:
    found = re.search(r"^throat\s+([\d.]+);", file.read(), re.M)
if not found:
    sys.exit("system/blockMeshDict has no line 'throat ...;'. This script knows the channel of the"
             " tutorial: adapt SECTIONS, DEPTH and halfHeight to another one")
THROAT = float(found.group(1))


def halfHeight(x):
    """Of the channel [um], as in system/blockMeshDict."""
    near = min(max(1 - abs(x - 30)/12, 0), 1)
    return 8 - (8 - THROAT)*(1 - math.cos(math.pi*near))/2


passages = table(".", "clumpPassages")
left = [r["time"] for r in passages if r["event"] == "left"]
entered = [r["time"] for r in passages if r["event"] == "entered"]
print("%d cells have entered, %d have left, %d are inside"
      % (len(entered), len(left), len(entered) - len(left)))

begin = min(left, default=0)
length = {(r["time"], r["clump"]): 1e6*r["L1"] for r in table(".", "clumpShape")}
present = [r for r in table(".", "clumpForce") if r["time"] >= begin]
cells = [(1e6*r["x"], 1e3*r["Ux"], length[r["time"], r["clump"]]) for r in present]
nTimes = len({r["time"] for r in present})

with open("result.csv", "w", newline="") as out:
    result = csv.writer(out)
    result.writerow(["section", "mean_speed_mm_s", "mean_length_um", "tube_haematocrit"])
    for name, (low, high) in SECTIONS.items():
        here = [c for c in cells if low < c[0] < high]
        n = max(len(here), 1)
        space = 2*DEPTH*sum(halfHeight(low + (k + 0.5)/100*(high - low)) for k in range(100)) \
            * (high - low)/100
        row = [name, "%.2f" % (sum(c[1] for c in here)/n), "%.2f" % (sum(c[2] for c in here)/n),
               "%.3f" % (len(here)/max(nTimes, 1)*VOLUME/space)]
        result.writerow(row)
        print("%-7s mean speed of the cells %s mm/s, length %s um, tube haematocrit %s"
              % tuple(row))

figure, (scene, plot) = plt.subplots(2, 1, figsize=(8, 6.5), sharex=True)
drawSpheres(scene, frames()[-1][1])
at = [60*k/200 for k in range(201)]
for sign in -1, 1:
    scene.plot(at, [sign*halfHeight(v) for v in at], "k", lw=1.5)
scene.set_xlim(-2, 62)
scene.set_ylim(-9, 9)
scene.set_aspect("equal")
scene.set_ylabel("y [um]")
scene.set_title("%d cells entered, %d left" % (len(entered), len(left)), fontsize=10)
dots = plot.scatter([c[0] for c in cells], [c[2] for c in cells], 4, [c[1] for c in cells])
figure.colorbar(dots, ax=plot, orientation="horizontal", pad=0.25, fraction=0.08,
                label="speed of the cell [mm/s]")
plot.set_xlabel("x [um]")
plot.set_ylabel("length of the cell [um]")
figure.tight_layout()
figure.savefig("result.png", dpi=110)
