"""Distance of the sphere from the middle of the duct over time, and where it stays.

Reads postProcessing/clumpMigration. Writes result.csv and result.png.
"""

import csv

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumps import table

WIDTH = 50                              # of the duct [um]

rows = table(".", "clumpMigration")
time = [1e3*r["time"] for r in rows]
away = [1e6*r["across"]/WIDTH - 0.5 for r in rows]
early = min(rows, key=lambda r: abs(r["time"] - 1e-3))
print("its path is inclined by %.2f degrees to the stream in the first millisecond"
      % early["angle"])
print("after %.1f mm the sphere is %.2f half widths from the middle, and inclined by %.1f degrees"
      % (1e3*(rows[-1]["along"] - rows[0]["along"]), 2*away[-1], abs(rows[-1]["angle"])))

with open("result.csv", "w", newline="") as out:
    result = csv.writer(out)
    result.writerow(["time_ms", "half_widths"])
    result.writerows([round(t, 4), round(2*a, 4)] for t, a in zip(time, away))

figure, axes = plt.subplots(figsize=(7, 4))
axes.axhspan(0.5, 0.6, color="0.85", label="Di Carlo 2009")
axes.plot(time, [2*a for a in away])
axes.set_ylim(0, 1)
axes.set_xlabel("time [ms]")
axes.set_ylabel("distance from the middle [half widths]")
axes.legend()
figure.tight_layout()
figure.savefig("result.png", dpi=110)
