"""Paths of spheres among the posts, and whether the posts displace them.

    python3 result.py <diameter> ...        # folders with the runs, in um

Prints the mode of each sphere and how far it has come, and writes result.csv and result.png.
"""

import csv
import math
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumps import table

PERIOD, RADIUS, TANGENT = 20, 5, 0.1        # of the array [um], of the flow
GAP = PERIOD - 2*RADIUS
MODES = {"displaced": "displaced", "withFlow": "with the flow", "between": "between the modes",
         "undecided": "undecided"}

figure, axes = plt.subplots(figsize=(9, 4))
highest, longest = 0, 0
rows = []
for diameter in sorted(sys.argv[1:], key=float):
    run = table(diameter, "clumpMigration")
    mode = MODES[run[-1]["mode"]]
    # From the axes of the flow to those of the rows of posts
    turn = 1e6*(1 + 1j*TANGENT)/abs(1 + 1j*TANGENT)
    path = [(z.real, z.imag) for z in (turn*(r["along"] + 1j*r["across"]) for r in run)]
    way = path[-1][0] - path[0][0]
    rows.append((diameter, mode, round(run[-1]["periods"], 1), round(way, 2),
                 round(path[-1][1] - path[0][1], 2), round(run[-1]["displacement"], 2)))
    print("%s um: %s after %.1f posts, %.0f um along the rows"
          % (diameter, mode, run[-1]["periods"], way))
    axes.plot(*zip(*path), label="%s um" % diameter)
    longest = max(longest, path[-1][0])
    highest = max(highest, max(y for _, y in path))
print("the smallest that Davis (2008) expects to be displaced: %.1f um" % (1.4*GAP*TANGENT**0.48))

with open("result.csv", "w", newline="") as out:
    result = csv.writer(out)
    result.writerow(["diameter_um", "mode", "posts", "along_um", "across_um", "displacement"])
    result.writerows(rows)

for i in range(math.ceil(longest/PERIOD) + 1):
    for j in range(-1, math.ceil(highest/PERIOD) + 1):
        axes.add_patch(plt.Circle((i*PERIOD, j*PERIOD), RADIUS, fc="0.7", ec="k"))
axes.set_aspect("equal")
axes.set_xlim(-6, longest + 6)
axes.set_ylim(-16, highest + 12)
axes.set_xlabel("x [um]")
axes.set_ylabel("y [um]")
axes.legend(loc="upper right", framealpha=1)
figure.tight_layout()
figure.savefig("result.png", dpi=110, bbox_inches="tight")
