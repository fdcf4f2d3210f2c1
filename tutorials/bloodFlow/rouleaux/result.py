"""How many red cells a cluster has, and the viscosity, over time."""

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumps import table

clusters, viscosity = table(".", "clumpClusters"), table(".", "apparentViscosity")


def mean(rows, column, first, last):
    values = [row[column] for row in rows if first <= row["time"] <= last]
    return sum(values)/len(values)


for name, first, last in (("at 5 1/s", 1.5, 2), ("at 200 1/s", 2.1, 2.16)):
    print("%s: clusters of %.1f red cells, single ones %.0f %%, relative viscosity %.2f" % (
        name, mean(clusters, "mean", first, last), 100*mean(clusters, "n1", first, last),
        mean(viscosity, "muRel", first, last)))

figure, axes = plt.subplots(2, sharex=True, figsize=(6, 4.5))
for a, rows, column, label in ((axes[0], clusters, "mean", "red cells of a cluster"),
                               (axes[1], viscosity, "muRel", "relative viscosity")):
    a.plot([row["time"] for row in rows], [row[column] for row in rows], color="firebrick", lw=1)
    a.set_ylabel(label)
    a.set_ylim(bottom=0)
    a.grid(alpha=0.3)
axes[1].set_xlabel("time [s]")
figure.tight_layout()
figure.savefig("clusters.png", dpi=120)
