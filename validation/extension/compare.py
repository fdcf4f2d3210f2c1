"""Deformation and strain of a red cell in extension and shear, one cell beside eight."""

import math
import os

import numpy as np
from results import Results, plt, read, save

results = Results()

# Elongation index of healthy red cells by laser diffraction, from memory (LORRCA, 37 C): no limits
DIFFRACTION = {1: 0.18, 3: 0.34, 10: 0.49}


def table(name):
    return np.genfromtxt("history-%s.csv" % name, delimiter=",", names=True, dtype=None,
                         encoding=None)


figure, (shapes, strains) = plt.subplots(1, 2, figsize=(9, 3.6))
index, areal = {}, {}
for r in read("data.csv"):
    rows, damage = table(r["history"]), table(r["history"] + "-damage")
    key = r["flow"], r["type"], r["stress_Pa"], r["cells_per_um"]
    seen = (rows["Lx"] - rows["Lz"])/(rows["Lx"] + rows["Lz"])
    last = rows["time"] > 2/3*rows["time"][-1]
    index[key], areal[key] = seen[last].mean(), damage["strain"][last].mean()
    name = "%s, %s, %g Pa, %g mesh cells per um" % key
    results.report(name + ": elongation index", index[key], "-",
                   "laser diffraction in shear: %g, from memory" % DIFFRACTION[r["stress_Pa"]]
                   if r["flow"] == "shear" else "mean of the last third")
    if r["type"] == "membrane":
        results.report(name + ": largest areal strain", areal[key], "-", "mean of the last third")
        results.add(name + ": largest change of the volume",
                    np.abs(rows["volume"]/rows["volume"][0] - 1).max(), "of the volume", 0, 1e-9,
                    "no source")
    shapes.plot(rows["time"]/rows["time"][-1], seen, "-" if r["type"] == "membrane" else "--",
                label=name.rsplit(",", 1)[0])

three = [index.get(("shear", "membrane", stress, 1.0)) for stress in (1, 3, 10)]
if None not in three:
    line = three[0] + (three[2] - three[0])*math.log(3)/math.log(10)
    results.add("membrane in shear: elongation index at 3 Pa less that on the line over"
                " log(stress) from 1 to 10 Pa", three[1] - line, "-", 0, 0.05,
                "linear in log(stress), pubmed 1298449")
for stress in 1, 3, 10:
    pair = [areal.get((flow, "membrane", stress, 1.0)) for flow in ("extension", "shear")]
    if None not in pair:
        results.report("membrane, %g Pa: largest areal strain in extension" % stress,
                       pair[0]/pair[1], "of that in shear", "the same stress")
for flow in "extension", "shear":
    fine = (flow, "membrane", 3, 1.5)
    if fine in index:
        results.add("%s, membrane, 3 Pa: elongation index with 162 nodes less that with 642" % flow,
                    index[flow, "membrane", 3, 1.0] - index[fine], "-", 0, 0.03, "a finer mesh",
                    0.0436066 if flow == "extension" else None)     # see README

if os.path.exists("crowds.csv"):
    peaks, means, seconds = {}, {}, {}
    for r in read("crowds.csv"):
        rows = table(r["name"])
        late = rows["time"] > rows["time"][-1]/3
        clumps = [rows["strain"][late & (rows["clump"] == c)] for c in set(rows["clump"])]
        kind = r["name"].split("-")[0]
        peaks.setdefault(kind, []).extend(c.max() for c in clumps)
        means.setdefault(kind, []).extend(c.mean() for c in clumps)
        seconds[kind] = r["seconds"]
        for c in set(rows["clump"]):
            one = rows["clump"] == c
            strains.plot(1e3*rows["time"][one], rows["strain"][one],
                         "C0" if kind == "eight" else "C1")
    for name, values in ("peak", peaks), ("mean", means):
        one, eight = np.mean(values["one"]), np.mean(values["eight"])
        results.report("eight cells: %s areal strain, mean over the cells" % name, eight, "-",
                       "standard error %.2g" % (np.std(values["eight"])/math.sqrt(8)))
        if name == "peak":
            # See README
            results.add("one cell at the viscosity of eight: peak areal strain", one/eight,
                        "of that of eight", 1, 0.05, "arXiv 2309.11644: 3.7 %", known=0.638666)
            results.add("eight cells: peak areal strain", eight/one, "of that of one", 1.75, 0.25,
                        "Valtchanov et al. 2025: 1.5 to 2 by collisions")
        else:
            results.report("one cell at the viscosity of eight: mean areal strain", one/eight,
                           "of that of eight", "arXiv 2309.11644: 13 %")
    results.report("eight cells: processor time", seconds["eight"]/seconds["one"],
                   "of that of one", "this machine")

shapes.set_xlabel("time over that of the run")
shapes.set_ylabel("elongation index")
shapes.set_xlim(right=1.9)
shapes.legend(fontsize=6, loc="right")
strains.set_xlabel("time [ms]")
strains.set_ylabel("largest areal strain: eight cells, one cell")
figure.tight_layout()
save(figure, "extension.png")
results.write()
