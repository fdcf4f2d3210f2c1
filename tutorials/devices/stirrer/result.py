"""Torque and power that turn the rod, and where the red cells go.

Reads postProcessing/constraintForce and clumpForce, and the spheres in VTK/clumps. Writes
result.csv and result.png.
"""

import csv
import math

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumps import drawSpheres, read, table

RATE = 251.3                            # of the rod [rad/s]
FROM = 0.005                            # [s], when the flow no longer feels the start

rows = table(".", "constraintForce")
late = [r for r in rows if r["time"] > FROM]


def mean(column):
    return sum(r[column] for r in late)/len(late)


turned = sum(r["wz"]*(b["time"] - r["time"]) for r, b in zip(rows, rows[1:]))
print("the rod has made %.2f turns; its centre is %.1e m from where it was"
      % (turned/(2*math.pi), math.hypot(rows[-1]["x"] - rows[0]["x"],
                                        rows[-1]["y"] - rows[0]["y"])))
torques = [1e18*r["Tz"] for r in late]
print("torque  %.0f pN um, between %.0f and %.0f" % (1e18*mean("Tz"), min(torques), max(torques)))
print("force across the axis  %.1f pN at most"
      % max(1e12*math.hypot(r["Fx"], r["Fy"]) for r in late))
print("power   %.0f fW, torque times rate %.0f fW"
      % (1e15*mean("power"), 1e15*RATE*mean("Tz")))

paths = {}
for r in table(".", "clumpForce"):
    if r["type"] == "healthy":
        paths.setdefault(r["clump"], []).append((1e6*r["x"], 1e6*r["y"]))
ways = [sum(math.dist(a, b) for a, b in zip(p, p[1:])) for p in paths.values()]
print("%d red cells have gone %.0f um each, between %.0f and %.0f"
      % (len(ways), sum(ways)/len(ways), min(ways), max(ways)))

with open("result.csv", "w", newline="") as out:
    result = csv.writer(out)
    result.writerow(["time_ms", "torque_pN_um", "power_fW"])
    result.writerows(["%.4g" % (1e3*r["time"]), "%.2f" % (1e18*r["Tz"]),
                      "%.3f" % (1e15*r["power"])] for r in rows)

figure, (scene, curve) = plt.subplots(1, 2, figsize=(10, 4.5))
drawSpheres(scene, read(".").at())
for p in paths.values():
    scene.plot(*zip(*p), lw=0.8, color="0.4")
scene.set_xlim(-16, 16)
scene.set_ylim(-16, 16)
scene.set_aspect("equal")
scene.set_xlabel("x [um]")
scene.set_ylabel("y [um]")
curve.plot([1e3*r["time"] for r in late], torques)
curve.set_ylim(bottom=0)
curve.set_xlabel("time [ms]")
curve.set_ylabel("torque [pN um]")
figure.tight_layout()
figure.savefig("result.png", dpi=110)
