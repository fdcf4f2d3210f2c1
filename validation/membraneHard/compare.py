"""Whether every case ran to its end with all its steps converged, the volume kept and nothing
folded through itself."""
import clumps
import numpy as np
from matplotlib.collections import PolyCollection
from results import Results, plt, read, save

rows = read("data.csv")
results = Results()
for row in rows:
    name = row["case"]
    results.add(f"{name}: ran to its end", float(row["ended"] == "yes"), "-", 1, "0",
                "stable, or stopped with the reason")
    results.add(f"{name}: steps that missed the tolerance", row["missed"], "-", 0, "0", "converged")
    results.add(f"{name}: change of the volume", row["volume"], "-", 0, "1e-6", "exact")
    results.add(f"{name}: largest angle between neighbouring triangles", row["fold_deg"], "degrees",
                0, "150", "180 where a surface is folded on itself")
    if name == "fifty shear times":
        for column in ("area", "length"):
            results.add(f"{name}: largest {column} in the second half over the first",
                        row[f"later_{column}"], "-", 1, 0.002, "a steady capsule")
    results.report(f"{name}: outer correctors", row["correctors"], "-", "this code")
    repeated = f"{name}: repeated of {row['steps']:.0f} steps"
    if name == "steps of half a shear time":
        results.add(repeated, row["repeated"], "-", 0, 2, "but from rest, they have a solution")
    else:
        results.report(repeated, row["repeated"], "-", "this code")

figure, axes = plt.subplots(2, (len(rows) + 1)//2, figsize=(8, 3.8), squeeze=False)
for axis in axes.flat:
    axis.axis("off")
for number, (row, axis) in enumerate(zip(rows, axes.flat), 1):
    membrane = clumps.membranes(clumps.frames(f"case{number}")[-1][1])
    x = 1e6*membrane["x"]
    seen = np.argsort(x[membrane["triangles"]][:, :, 2].mean(axis=1))
    axis.add_collection(PolyCollection(x[membrane["triangles"][seen]][:, :, :2], facecolor="C3",
                                       edgecolor="k", linewidth=0.1))
    axis.set_title(row["case"], fontsize=7)
    axis.autoscale()
    axis.set_aspect("equal")
figure.tight_layout()
save(figure, "membraneHard.png")
results.write()
