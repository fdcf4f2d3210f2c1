"""Flow that a wave of the walls drives through a channel, and the paths of beads in it.

Reads postProcessing/flow and clumpForce. Writes result.csv and result.png.

Walls at y = +-h, h = a (1 + phi cos(k (x - c t))), with a wave that is long beside a, in a fluid
without inertia, carry the mean flow
    Q = 2 a c 3 phi^2/(2 + phi^2)                           [m2/s]
per depth where the pressure is the same one wave ahead (A. H. Shapiro, M. Y. Jaffrin and
S. L. Weinberg, J. Fluid Mech. 37, 799, 1969).
"""

import csv
import glob

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumps import table

A = 12e-6                               # half the mean width of the channel [m]
PHI = 0.4                               # amplitude of the wave over this
WAVE = 192e-6                           # its length [m]
DEPTH = 12e-6                           # of the mesh [m]
FREQUENCY = 100                         # [Hz]

c = WAVE*FREQUENCY
shapiro = 2*A*c*3*PHI**2/(2 + PHI**2)

times, flows = [], []
for name in sorted(glob.glob("postProcessing/flow/*/volFieldValue.dat")):
    for line in open(name):
        if not line.startswith("#"):
            words = line.replace("(", " ").replace(")", " ").split()
            times.append(float(words[0]))
            flows.append(float(words[1])/WAVE/DEPTH)
last = [q for t, q in zip(times, flows) if t > times[-1] - 0.9999/FREQUENCY]
mean = sum(last)/len(last)
print("flow           %.4f of Shapiro's, between %.4f and %.4f"
      % (mean/shapiro, min(last)/shapiro, max(last)/shapiro))

paths = {}
for row in table(".", "clumpForce"):
    paths.setdefault(int(row["clump"]), []).append(row)
before = {}
for clump, rows in sorted(paths.items()):
    way = 0
    previous = 0
    for row in rows:
        way += row["Ux"]*(row["time"] - previous)
        previous = row["time"]
    print("bead %d         goes %.1f um in %.0f ms, %.2f of the wave's way"
          % (clump, 1e6*way, 1e3*previous, way/(c*previous)))

with open("result.csv", "w", newline="") as out:
    result = csv.writer(out)
    result.writerow(["time_ms", "flow_of_Shapiro"])
    for t, q in zip(times, flows):
        result.writerow(["%.4g" % (1e3*t), "%.5f" % (q/shapiro)])

figure, (above, below) = plt.subplots(2, 1, figsize=(7, 6), sharex=True)
ms = [1e3*t for t in times]
above.plot(ms, [q/shapiro for q in flows])
above.axhline(1, color="black", linestyle="--", linewidth=0.8)
above.set_ylabel("flow over that of Shapiro et al.")
above.set_ylim(0, 1.5)
for clump, rows in sorted(paths.items()):
    below.plot([1e3*r["time"] for r in rows], [1e3*r["Ux"] for r in rows],
               label="bead %d" % clump)
below.axhline(1e3*c, color="black", linestyle="--", linewidth=0.8, label="wave")
below.set_ylabel("velocity along x [mm/s]")
below.set_xlabel("time [ms]")
below.legend()
figure.tight_layout()
figure.savefig("result.png", dpi=110)
