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


COLOURS = {1: "C0", 3: "C1", 10: "C3"}
figure, (extension, shear, strains) = plt.subplots(1, 3, figsize=(12, 3.8))
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
    fine = r["cells_per_um"] > 1
    line = ":" if fine else "-" if r["type"] == "membrane" else "--"
    (shear if r["flow"] == "shear" else extension).plot(
        rows["time"]/rows["time"][-1], seen, line,
        color=COLOURS[r["stress_Pa"]],
        label="%s%s, %g Pa" % (r["type"], " of 642 nodes" if fine else "", r["stress_Pa"]))

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
                         color="C0" if kind == "eight" else "C1",
                         label={"eight": "one of eight cells", "one": "one cell"}[kind])
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

for axes, title in (extension, "in extension"), (shear, "in shear"):
    axes.set_xlabel("time over that of the run")
    axes.set_ylabel("elongation index")
    axes.set_title(title)
extension.legend(fontsize=6, loc="lower right")
strains.set_title("eight cells, and one in three positions")
strains.set_xlabel("time [ms]")
strains.set_ylabel("largest areal strain")
if strains.lines:
    names = dict(zip(*strains.get_legend_handles_labels()[::-1]))
    strains.legend(names.values(), names.keys(), fontsize=6)
figure.tight_layout()
save(figure, "extension.png")
results.write()
