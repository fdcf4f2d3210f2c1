"""Paths of beads in a bend, beside the flow across the duct that carries them.

Reads postProcessing/clumpForce and crossSection. Writes result.csv and result.png.
"""

import csv
import glob
from math import atan2, degrees, hypot

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumps import table

RADIUS, HALF = 160, 20          # of the middle line and half the width of the duct [um]
MEAN = 0.5                      # velocity [m/s]

# Angle [degrees], places away from the centre of curvature and above the middle [half widths]
paths = {}
for row in table(".", "clumpForce"):
    x, y, z = (1e6*row[k] for k in "xyz")
    if y > 0 and z > 0:
        paths.setdefault(int(row["clump"]), []).append(
            (degrees(atan2(y, x)), (hypot(x, y) - RADIUS)/HALF, z/HALF, 1e3*row["time"]))

# The flow through the plane x = 0, in the middle of the bend, at the end
last = max(glob.glob("postProcessing/crossSection/*/U_middle.raw"),
           key=lambda name: float(name.split("/")[-2]))
flow = [[float(word) for word in line.split()] for line in open(last) if line[0] != "#"]
points = [((1e6*y - RADIUS)/HALF, 1e6*z/HALF, v, w)
          for x, y, z, u, v, w in flow if abs(1e6*y - RADIUS) < HALF]
across = max(hypot(v, w) for _, _, v, w in points)
print("flow across the duct, in the middle of the bend: up to %.3f of the mean velocity"
      % (across/MEAN))

figure, axes = plt.subplots(figsize=(7, 6))
axes.quiver(*zip(*points), color="0.6", width=0.003)
with open("result.csv", "w", newline="") as out:
    result = csv.writer(out)
    result.writerow(["bead", "angle_degrees", "outwards", "above", "time_ms"])
    for bead, path in sorted(paths.items()):
        inBend = [place for place in path if place[0] < 175]
        for place in inBend:
            result.writerow([bead] + ["%.4g" % value for value in place])
        (begin, r0, z0, _), (end, r1, z1, _) = inBend[0], inBend[-1]
        print("bead %d, from %3.0f to %3.0f degrees: %+.2f -> %+.2f outwards, %.2f -> %.2f above"
              " the middle" % (bead, begin, end, r0, r1, z0, z1))
        line, = axes.plot([p[1] for p in inBend], [p[2] for p in inBend], label="bead %d" % bead)
        axes.plot(r0, z0, "o", color=line.get_color())
        axes.plot(r1, z1, ">", color=line.get_color())
axes.set(xlim=(-1, 1), ylim=(-1, 1), aspect="equal",
         xlabel="away from the centre of curvature [half widths]",
         ylabel="above the middle [half widths]",
         title="Arrows: flow across the duct, up to %.0f mm/s" % (1e3*across))
axes.legend(loc="lower left")
figure.tight_layout()
figure.savefig("result.png", dpi=110)
