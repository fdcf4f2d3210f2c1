"""Diffusivity of arrays, emptying spheres, Sherwood numbers and the content against references."""

import csv
import math

import numpy as np
from results import Results, plt, read, save

results = Results()

# Flow, Peclet number, D/dx: see README
KNOWN = {("extension", 100, 8): 1.09862}


def rayleigh(phi):
    """Effective over free diffusivity of a cubic array of impermeable spheres."""
    return 1 - 3*phi/(2 + phi - 0.98*phi**(10/3))


def crank(biot, times):
    """Content of a sphere over that at the start, times over a^2/D (Crank, eq. 6.45)."""
    total = np.zeros_like(times)
    for n in range(200):
        # b cot b = 1 - Bi has one solution between n pi and (n + 1) pi
        low, high = n*math.pi + 1e-9, (n + 1)*math.pi - 1e-9
        for _ in range(200):
            b = (low + high)/2
            if b*math.cos(b)/math.sin(b) > 1 - biot:
                low = b
            else:
                high = b
        total += 6*biot**2*np.exp(-b*b*times)/(b*b*(b*b + biot*(biot - 1)))
    return total


with open("../sherwood_sphere.csv") as file:
    names = {"uni": "uniform", "ext": "extension", "shear": "shear"}
    sherwood = {(names[r["flow"]], float(r["Pe"])): float(r["Sh"])
                for r in csv.DictReader(line for line in file if not line.startswith("#"))
                if r["conf"] == "C"}

def weakShear(peclet):
    """Sherwood number of a free sphere in shear at small Peclet numbers (doc/theory.md)."""
    return 1/(1 - 0.2568*math.sqrt(peclet))


figure, axes = plt.subplots(figsize=(6, 3.6))
inShear = {}
for r in read("data.csv"):
    if r["kind"] == "array":
        name = ("array at %g, D/dx %.3g, place %g: effective diffusivity"
                % (r["number"], r["D_dx"], r["place"]))
        value = r["value"]/rayleigh(r["number"])
        gap = r["D_dx"]*((math.pi/6/r["number"])**(1/3) - 1)
        if gap < 1.5:
            results.report(name, value, "of the reference",
                           "Rayleigh 1892; gap of %.2g mesh cells" % gap)
        else:
            results.add(name, value, "of the reference", 1, 0.02, "Rayleigh 1892")
    elif r["kind"] in names.values():
        name = "%s, Pe %g, D/dx %g" % (r["kind"], r["number"], r["D_dx"])
        if r["kind"] == "shear":
            name += ", %g radii" % r["width"]
            inShear[r["number"], r["D_dx"], r["width"]] = r["value"]
        results.add(name + ": Sherwood number",
                    r["value"]/sherwood[r["kind"], r["number"]], "of the reference", 1,
                    0.02 if r["D_dx"] > 8 else 0.05, "exact Stokes flow, spherical harmonics",
                    KNOWN.get((r["kind"], r["number"], r["D_dx"])))
    elif r["kind"] == "content":
        rows = np.genfromtxt("history-%s.csv" % r["history"], delimiter=",", names=True)
        name = "%s, %g steps: " % (r["history"].replace("-", ", "), r["number"])
        total = rows["outside"] + rows["inside"]
        results.add(name + "largest change of the content", np.abs(total/total[0] - 1).max(),
                    "of the content", 0, 1e-12, "no source")
        beyond = max(0, -rows["lowest"].min(), rows["highest"].max() - 1)
        results.add(name + "largest new extreme", beyond, "of the largest concentration", 0, 1e-8,
                    "upwind")
        if r["history"].endswith("-impermeable"):
            results.add(name + "largest change inside",
                        np.abs(rows["inside"]/rows["inside"][0] - 1).max(), "of the content", 0,
                        1e-9, "nothing passes")
    else:
        rows = np.genfromtxt("history-%s.csv" % r["history"], delimiter=",", names=True)
        times = rows["t_s"]/0.16
        exact = crank(r["number"], times)
        start = 4/3*math.pi*64e-18
        content = rows["inside"]/start
        error = np.abs(content - exact)[times > 0.02].max()
        name = "%s, Bi %g, D/dx %g, step %g a2/D" % (r["kind"], r["number"], r["D_dx"], r["place"])
        results.add(name + ": largest error of the content", error, "of that at the start", 0, 0.02,
                    "Crank 1975, eq. 6.45")
        axes.plot(times, content, label=name)
        axes.plot(times, exact, "k:")
for (peclet, resolution, width), value in inShear.items():
    if peclet == 0.1 and (0.01, resolution, width) in inShear:
        # The mesh changes the diffusion from the surface, and not this
        growth = value/inShear[0.01, resolution, width] - 1
        results.add("shear, Pe 0.01 to 0.1, D/dx %g, %g radii: growth of the Sherwood number"
                    % (resolution, width), growth/(weakShear(0.1)/weakShear(0.01) - 1),
                    "of the reference", 1, 0.1, "Frankel and Acrivos 1968")
    if width == 12 and (peclet, resolution, 8) in inShear:
        results.add("shear, Pe %g, D/dx %g: Sherwood number in a box of 8 radii"
                    % (peclet, resolution), inShear[peclet, resolution, 8]/value,
                    "of that in 12 radii", 1, 0.005, "the same sphere")
axes.set_xlabel("time over a$^2$/D")
axes.set_ylabel("content")
axes.legend(fontsize=6)
save(figure, "solutes.png")
results.write()
