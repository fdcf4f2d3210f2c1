"""Distance of the sphere from the middle of the duct over time, and where it stays.

Reads postProcessing/clumpForce. Writes result.csv and result.png.
"""

import csv

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumpTables import table

WIDTH, SPEED = 50, 1.0                  # of the duct [um], in its middle [m/s]

rows = table(".", "clumpForce")
time = [1e3*r["time"] for r in rows]
away = [1e6*r["y"]/WIDTH - 0.5 for r in rows]
way = 1e3*(rows[-1]["x"] - rows[0]["x"])
late = [a for t, a in zip(time, away) if t > 0.8*time[-1]]
print("after %.1f mm the sphere is %.2f half widths from the middle" % (way, 2*late[-1]))
print("it moved by %.3f half widths in the last fifth of the time" % (2*(late[-1] - late[0])))

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
