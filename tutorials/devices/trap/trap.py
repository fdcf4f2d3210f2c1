"""Finds the red cells that the trap has caught, and draws them.

Reads postProcessing/clumpPassages (what entered and left), clumpForce (places, velocities) and
VTK/clumps (the spheres). Writes result.csv and result.png.
"""

import csv
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumps import drawSpheres, frames, table

# The trap, from constant/triSurface/trap.stl [um], and its pocket
POST = [(20, 4.5), (26, 4.5), (26, 1), (29, 1), (29, 7), (20, 7)]
POCKET = (18, 29), (-4.5, 4.5)
SLOW = 0.05             # of a caught cell, to the mean velocity of the flow
MEAN = 1e-3             # [m/s]


passages = table(".", "clumpPassages")
left = [r for r in passages if r["event"] == "left"]
entered = [r for r in passages if r["event"] == "entered"]
print("%d cells have entered, %d have left, %d are inside"
      % (len(entered), len(left), len(entered) - len(left)))

caught = {}             # number: first time in the pocket and slow
for r in table(".", "clumpForce"):
    x, y = 1e6*r["x"], 1e6*r["y"]
    speed = sum(r[c]**2 for c in ("Ux", "Uy", "Uz"))**0.5
    inside = POCKET[0][0] < x < POCKET[0][1] and POCKET[1][0] < y < POCKET[1][1]
    if inside and speed < SLOW*MEAN:
        caught.setdefault(r["clump"], r["time"])
    else:
        caught.pop(r["clump"], None)

with open("result.csv", "w", newline="") as out:
    result = csv.writer(out)
    result.writerow(["number", "caught_at_s"])
    for number, time in sorted(caught.items(), key=lambda c: c[1]):
        result.writerow([number, time])
        print("cell %d is in the trap since %.0f ms" % (number, 1e3*time))
if not caught:
    print("the trap is empty")

figure, scene = plt.subplots(figsize=(9, 6))
drawSpheres(scene, frames()[-1][1])
for sign in 1, -1:
    scene.add_patch(plt.Polygon([(a, sign*b) for a, b in POST], fc="0.6", ec="k"))
    scene.plot([0, 50], [15*sign, 15*sign], "k", lw=1.5)
scene.annotate("", (5, 0), (-2, 0), arrowprops={"arrowstyle": "->"})
scene.set_xlim(-3, 52)
scene.set_ylim(-16, 16)
scene.set_aspect("equal")
scene.set_xlabel("x [um]")
scene.set_ylabel("y [um]")
scene.set_title("%d cells entered, %d left, %d caught"
                % (len(entered), len(left), len(caught)), fontsize=10)
figure.tight_layout()
figure.savefig("result.png", dpi=110)
