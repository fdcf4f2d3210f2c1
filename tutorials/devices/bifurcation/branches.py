"""Counts the red cells that leave through each branch and draws them.

Reads postProcessing/clumpPassages (what entered and left), flowRight and flowLeft (volume flow
through the branches) and VTK/clumps (the spheres). Writes result.csv and result.png. The law of
Pries and Secomb (Microvascular blood viscosity and the endothelial surface layer, Am. J. Physiol.
289, H2657, 2005) is drawn for comparison.
"""

import csv
import math
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumpSpheres import drawSpheres, frames
from clumpTables import table

BRANCHES = "right", "left"
VOLUME = 94e-18         # of a red cell [m3]
FEED = 0.2              # discharge haematocrit of the feed
DIAMETER = 10           # of the channels [um]


def priesSecomb(flow, feed=FEED, diameter=DIAMETER):
    """Fraction of the cells over the fraction of the flow; branches of equal diameters [um]"""
    x0 = 0.964*(1 - feed)/diameter
    b = 1 + 6.98*(1 - feed)/diameter
    if not x0 < flow < 1 - x0:
        return 0.0 if flow <= x0 else 1.0
    s = (flow - x0)/(1 - 2*x0)
    return 1/(1 + math.exp(-b*math.log(s/(1 - s))))


passages = table(".", "clumpPassages")
left = {b: [r["time"] for r in passages if r["event"] == "left" and r["patch"] == b]
        for b in BRANCHES}
entered = [r["time"] for r in passages if r["event"] == "entered"]
# The tables of OpenFOAM have the time and one value
flow = {b: [tuple(r.values()) for r in table(".", "flow" + b.capitalize())] for b in BRANCHES}
end = max(t for t, _ in flow["left"])

# From the time on at which the first cell leaves
begin = min((t for times in left.values() for t in times), default=0)
volume = {b: sum(q for t, q in flow[b] if t > begin)*(end - begin)
          / max(sum(1 for t, _ in flow[b] if t > begin), 1) for b in BRANCHES}
cells = {b: sum(1 for t in left[b] if t > begin) for b in BRANCHES}
allCells, allVolume = max(sum(cells.values()), 1), sum(volume.values())

print("%d cells have entered, %d have left, %d are inside"
      % (len(entered), sum(map(len, left.values())),
         len(entered) - sum(map(len, left.values()))))
with open("result.csv", "w", newline="") as out:
    result = csv.writer(out)
    result.writerow(["branch", "cells", "fraction_of_flow", "fraction_of_cells",
                    "Pries_Secomb", "discharge_haematocrit"])
    for b in BRANCHES:
        share = volume[b]/allVolume
        row = [b, cells[b], "%.3f" % share, "%.3f" % (cells[b]/allCells),
               "%.3f" % priesSecomb(share), "%.3f" % (cells[b]*VOLUME/volume[b])]
        result.writerow(row)
        print("%-6s %3s cells, %s of the flow, %s of the cells (Pries and Secomb %s), "
              "haematocrit %s" % tuple(row))

figure, (scene, law) = plt.subplots(1, 2, figsize=(10, 5))
drawSpheres(scene, frames()[-1][1])
for corner in ((-25, 5), (0, 5), (0, 30)), ((-25, -5), (0, -5), (0, -30)), ((10, -30), (10, 30)):
    scene.plot(*zip(*corner), "k", lw=1.5)
scene.annotate("", (-19, 0), (-26, 0), arrowprops={"arrowstyle": "->"})
scene.text(11, 27, "left, %d cells" % cells["left"], fontsize=9)
scene.text(11, -28, "right, %d cells" % cells["right"], fontsize=9)
scene.set_xlim(-27, 33)
scene.set_aspect("equal")
scene.set_xlabel("x [um]")
scene.set_ylabel("y [um]")
scene.set_title("%.0f ms" % (1e3*end), fontsize=10)

at = [k/200 for k in range(201)]
law.plot(at, at, "k:", lw=0.8, label="as the flow")
law.plot(at, [priesSecomb(f) for f in at], "k", lw=1, label="Pries and Secomb, D 10 um")
for b, colour in zip(BRANCHES, ("C3", "C0")):
    share = cells[b]/allCells
    error = math.sqrt(max(share*(1 - share), 1/allCells)/allCells)
    law.errorbar([volume[b]/allVolume], [share], [error], fmt="o", color=colour, capsize=3,
                 label="%s, haematocrit %.2f" % (b, cells[b]*VOLUME/volume[b]))
law.set_xlim(0, 1)
law.set_ylim(0, 1)
law.set_xlabel("fraction of the flow")
law.set_ylabel("fraction of the cells")
law.legend(fontsize=8)
figure.tight_layout()
figure.savefig("result.png", dpi=110)
