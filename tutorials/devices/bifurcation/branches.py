"""Counts the red cells that leave through each branch and draws them.

A notebook as a script: editors that know cells (# %%) run it cell by cell, python3 as a whole. It
reads the tables clumpPassages (what entered and left), flowRight and flowLeft (volume flow through
the branches) and the spheres in VTK/clumps, and writes result.csv and result.png.
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
VOLUME = 94e-18         # of a red cell [m3]
FEED = 0.2              # discharge haematocrit of the feed
DIAMETER = 10           # of the channels [um]

run = read(".")

# %% [markdown]
# ## What has left where
# `clumpPassages` has a row for every red cell that enters or leaves, with the name of the patch.

# %%
passages = run["clumpPassages"]
time, event, patch = passages["time"], passages["event"], passages["patch"]
left = {b: time[(event == "left") & (patch == b)] for b in BRANCHES}
entered = (event == "entered").sum()
print("%d cells have entered, %d have left, %d are inside"
      % (entered, (event == "left").sum(), entered - (event == "left").sum()))

# %% [markdown]
# ## Fractions of the cells and of the flow
# From the time on at which the first cell leaves. The tables of OpenFOAM's function objects have
# the time and one value. The law is that of Pries and Secomb (Microvascular blood viscosity and the
# endothelial surface layer, Am. J. Physiol. 289, H2657, 2005) for branches of equal diameters.


# %%
def priesSecomb(flow, feed=FEED, diameter=DIAMETER):
    """Fraction of the cells over the fraction of the flow; diameter in um"""
    x0 = 0.964*(1 - feed)/diameter
    b = 1 + 6.98*(1 - feed)/diameter
    if not x0 < flow < 1 - x0:
        return 0.0 if flow <= x0 else 1.0
    s = (flow - x0)/(1 - 2*x0)
    return 1/(1 + (s/(1 - s))**-b)


flow = {b: run["flow" + b.capitalize()] for b in BRANCHES}
end = flow["left"]["time"][-1]
begin = min((t for times in left.values() for t in times), default=0)
cells, volume = {}, {}
for b in BRANCHES:
    rate = flow[b][flow[b].columns[1]]
    volume[b] = rate[flow[b]["time"] > begin].mean()*(end - begin)
    cells[b] = (left[b] > begin).sum()
allCells, allVolume = max(sum(cells.values()), 1), sum(volume.values())

with open("result.csv", "w", newline="") as out:
    result = csv.writer(out)
    result.writerow(["branch", "cells", "fraction_of_flow", "fraction_of_cells",
                    "Pries_Secomb", "discharge_haematocrit"])
    for b in BRANCHES:
        share = volume[b]/allVolume
        row = [b, cells[b], "%.3f" % share, "%.3f" % (cells[b]/allCells),
               "%.3f" % priesSecomb(share), "%.3f" % (cells[b]*VOLUME/volume[b])]
        result.writerow(row)
        print("%-6s %3s cells, %s of the flow, %s of the cells (Pries and Secomb %s), "
              "haematocrit %s" % tuple(row))

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
                 label="%s, haematocrit %.2f" % (b, cells[b]*VOLUME/volume[b]))
law.set_xlim(0, 1)
law.set_ylim(0, 1)
law.set_xlabel("fraction of the flow")
law.set_ylabel("fraction of the cells")
law.legend(fontsize=8)
figure.tight_layout()
figure.savefig("result.png", dpi=110)
