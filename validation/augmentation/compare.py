"""Effective diffusivities across a suspension at rest and in shear."""

import math
import os

import numpy as np
from results import Results, plt, read, save

results = Results()

QUICK = os.environ.get("quick") == "true"
LENGTH, AREA = 16e-6, 15e-6**2      # between the walls [m], of a wall [m2]
FREE = {"oxygen": 2.2e-9, "protein": 6e-11}
# Volume of the spheres of twelve rings (60 um3 each) and of six beads over that of the box
SPHERES, BEADS = 12*60/3600, 6*5.2/3600
# Of a bead, after Stokes and Einstein, at 310 K in 1.2 mPa s [m2/s]
BROWNIAN = 1.380649e-23*310/(6*math.pi*1.2e-3*1.075e-6)


def table(name):
    return np.genfromtxt("history-%s.csv" % name, delimiter=",", names=True, dtype=None,
                         encoding=None)


figure, axes = plt.subplots(figsize=(5, 3.6))
effective = {}
for r in read("data.csv"):
    rate = r["rate_per_s"]
    for solute, free in FREE.items():
        rows = table("%s-%s" % (r["history"], solute))
        late = rows["time"] > 0.5*rows["time"][-1]
        both = LENGTH/AREA*np.array([rows["bottom"], -rows["top"]])
        effective[solute, rate] = both[:, late].mean()
        if rate:
            results.report("%s, %g 1/s: effective diffusivity" % (solute, rate),
                           effective[solute, rate]/free, "of that in plasma",
                           "at the walls %.3g, %.3g" % tuple(both[:, late].mean(axis=1)/free))
        axes.plot(rows["time"]/rows["time"][-1], both.mean(axis=0)/free,
                  label="%s, %g 1/s" % (solute, rate))
    if rate:
        rows = table(r["history"] + "-D")
        last = rows[(rows["time"] == rows["time"][-1]) & (rows["type"] == "bead")]
        effective["bead"] = last["D"][0]

added = {solute: effective[solute, 200]/effective[solute, 0] - 1 for solute in FREE}
if not QUICK:
    added["bead"] = effective["bead"]/BROWNIAN
    results.add("oxygen: added by shear", added["oxygen"], "of that at rest", 0, 0.1,
                "none: Ahuja, Hendee and Carson 1978")
    results.report("protein: added by shear", added["protein"], "of that at rest",
                   "measurable but small: the same")
    results.report("beads as platelets: added by shear", added["bead"], "of that at rest",
                   "60 to 300, of which about 5 hydrodynamic: the same")
    ranks = [added[name] for name in ("oxygen", "protein", "bead")]
    results.add("pairs of oxygen, protein and beads that are not in their order",
                sum(a >= b for a, b in zip(ranks, ranks[1:])), "-", 0, 0.5, "the same")


def maxwell(ratio):
    """Of spheres with this ratio of diffusivities, and the beads, which nothing enters."""
    change = SPHERES*(ratio - 1)
    return (2 + ratio + 2*change)/(2 + ratio - change) - 1.5*BEADS


results.add("oxygen, at rest: effective diffusivity", effective["oxygen", 0]/FREE["oxygen"],
            "of that in plasma", maxwell(0.95/2.2), 0.03, "Maxwell 1873, as spheres")
results.report("protein, at rest: effective diffusivity", effective["protein", 0]/FREE["protein"],
               "of that in plasma", "Maxwell 1873, as spheres: %.2f" % maxwell(0))
axes.set_xlabel("time over that of the run")
axes.set_ylabel("effective diffusivity over that in plasma")
axes.legend(fontsize=7)
figure.tight_layout()
save(figure, "augmentation.png")
results.write()
