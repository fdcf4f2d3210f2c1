"""Red cells, flow and haematocrit of the branches, and a picture.

A notebook as a script: editors that know cells (# %%) run it cell by cell, python3 as a whole. It
reads the table branchFlow (what has flowed through each patch, and the clumps with it) and the
spheres in VTK/clumps, and writes result.csv and result.png.
"""

# %% [markdown]
# # Blood that parts into two branches
# `read` gives the run in the present folder.

# %%
import csv
import numpy as np
import matplotlib.pyplot as plt
from clumps import drawSpheres, read

BRANCHES = "right", "left"
FEED = 0.2              # discharge haematocrit of the feed
DIAMETER = 10           # of the channels [um]

run = read(".")

# %% [markdown]
# ## What has left where
# `branchFlow` has a row for every patch that clumps can cross, and one for `all` of them. Its
# numbers are totals; outwards is positive.

# %%
flows = run["branchFlow"]
rows = {p: flows["patch"] == p for p in BRANCHES + ("inlet", "all")}
time = flows["time"][rows["all"]]


def total(patch, column, at=-1):
    """Of a patch, at the end or in another row"""
    return flows[column][rows[patch]][at]


print("%d cells have entered, %d have left, %d are inside"
      % tuple(total("all", column) for column in ("entered", "left", "inside")))

# %% [markdown]
# ## Fractions of the cells and of the flow
# From the first row on in which a cell has left: until then, plasma flows out. The law is that of
# Pries and Secomb (Microvascular blood viscosity and the endothelial surface layer, Am. J. Physiol.
# 289, H2657, 2005) for branches of equal diameters.
# The haematocrit of a branch over that of the feed is the skimming ratio.


# %%
def priesSecomb(flow, feed=FEED, diameter=DIAMETER):
    """Fraction of the cells over the fraction of the flow; diameter in um"""
    x0 = 0.964*(1 - feed)/diameter
    b = 1 + 6.98*(1 - feed)/diameter
    if not x0 < flow < 1 - x0:
        return 0.0 if flow <= x0 else 1.0
    s = (flow - x0)/(1 - 2*x0)
    return 1/(1 + (s/(1 - s))**-b)


end = time[-1]
some = np.flatnonzero(flows["left"][rows["all"]])
begin = some[0] if len(some) else 0


def since(patch, column):
    """What has flowed from that row on"""
    return total(patch, column) - total(patch, column, begin)


cells = {b: int(since(b, "left")) for b in BRANCHES}
volume = {b: since(b, "V") for b in BRANCHES}
haematocrit = {b: since(b, "Vc")/volume[b] for b in BRANCHES}
allCells, allVolume = max(sum(cells.values()), 1), sum(volume.values())
feed = total("inlet", "Hd")
print("feed: haematocrit %.3f" % feed)

with open("result.csv", "w", newline="") as out:
    result = csv.writer(out)
    result.writerow(["branch", "cells", "fraction_of_flow", "fraction_of_cells",
                    "Pries_Secomb", "discharge_haematocrit", "skimming_ratio"])
    for b in BRANCHES:
        share = volume[b]/allVolume
        row = [b, cells[b], "%.3f" % share, "%.3f" % (cells[b]/allCells),
               "%.3f" % priesSecomb(share), "%.3f" % haematocrit[b],
               "%.2f" % (haematocrit[b]/feed)]
        result.writerow(row)
        print("%-6s %3s cells, %s of the flow, %s of the cells (Pries and Secomb %s)"
              "\n       haematocrit %s, skimming ratio %s" % tuple(row))

# %% [markdown]
# ## Pictures
# The red cells at the end, and the fractions with the error of counting.

# %%
figure, (scene, law) = plt.subplots(1, 2, figsize=(10, 5))
drawSpheres(scene, run.at())
for corner in ((-25, 5), (0, 5), (0, 30)), ((-25, -5), (0, -5), (0, -30)), ((10, -30), (10, 30)):
    scene.plot(*zip(*corner), "k", lw=1.5)
scene.annotate("", (-19, 0), (-26, 0), arrowprops={"arrowstyle": "->"})
scene.text(11, 27, "left, %d cells" % cells["left"], fontsize=9)
scene.text(11, -28, "right, %d cells" % cells["right"], fontsize=9)
scene.set_xlim(-27, 33)
scene.set_aspect("equal")
scene.set_xlabel("x [um]")
scene.set_ylabel("y [um]")
scene.set_title("%.0f ms" % (1e3*end), fontsize=10)

at = np.linspace(0, 1, 201)
law.plot(at, at, "k:", lw=0.8, label="as the flow")
law.plot(at, [priesSecomb(f) for f in at], "k", lw=1, label="Pries and Secomb, D 10 um")
for b, colour in zip(BRANCHES, ("C3", "C0")):
    share = cells[b]/allCells
    error = np.sqrt(max(share*(1 - share), 1/allCells)/allCells)
    law.errorbar([volume[b]/allVolume], [share], [error], fmt="o", color=colour, capsize=3,
                 label="%s, haematocrit %.2f" % (b, haematocrit[b]))
law.set_xlim(0, 1)
law.set_ylim(0, 1)
law.set_xlabel("fraction of the flow")
law.set_ylabel("fraction of the cells")
law.legend(fontsize=8)
figure.tight_layout()
figure.savefig("result.png", dpi=110)
