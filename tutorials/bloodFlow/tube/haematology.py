"""Viscosity, haematocrits, profiles and cell-free layer of the blood in the tube.

A notebook as a script: editors that know cells (# %%) run it cell by cell, python3 as a whole.
"""

# %% [markdown]
# # Blood in a tube
#
# `read` gives the run in the present folder; printed, it names the tables, their columns and units.

# %%
import numpy as np
import matplotlib.pyplot as plt
from clumps import read

RADIUS = 10e-6          # of the tube [m]

run = read(".")
print(run)

# %% [markdown]
# ## Means and standard errors
# The packing at the start is random: the first half of the run does not count. Every mean comes
# with its standard error from the means of blocks of time.

# %%
first = run["haematocrit"]["time"][-1]/2
means = {}
for name in "apparentViscosity", "haematocrit", "cellFreeLayer", "contactStress":
    means.update(run.means(name, first))
print(f"From {first:g} s on: mean, standard error")
for column in "muRel", "Ht", "Hd", "HtHd", "layer", "deepest":
    print("%s\t%.4g\t%.2g" % (column, *means[column]))

# %% [markdown]
# ## Glass tubes
# The fits of Pries and others to the measured viscosity (American Journal of Physiology 263, H1770,
# 1992) and tube haematocrit (Circulation Research 67, 826, 1990), over the discharge haematocrit Hd
# and the diameter D in um.


# %%
def tubeOverDischarge(Hd, D):
    return Hd + (1 - Hd)*(1 + 1.7*np.exp(-0.415*D) - 0.6*np.exp(-0.011*D))


def relativeViscosity(Hd, D):
    at45 = 220*np.exp(-1.3*D) + 3.2 - 2.44*np.exp(-0.06*D**0.645)
    wide = 1/(1 + 1e-11*D**12)
    c = (0.8 + np.exp(-0.075*D))*(wide - 1) + wide
    return 1 + (at45 - 1)*((1 - Hd)**c - 1)/((1 - 0.45)**c - 1)


# The discharge haematocrit that a glass tube has at the tube haematocrit of this run
D = 2e6*RADIUS
Hd = np.linspace(0, 0.8, 8001)
Hd = np.interp(means["Ht"][0], Hd*tubeOverDischarge(Hd, D), Hd)
print("glass tubes: relative viscosity %.2f, tube over discharge haematocrit %.2f"
      % (relativeViscosity(Hd, D), tubeOverDischarge(Hd, D)))

# %% [markdown]
# ## Profiles
# Haematocrit and velocity over the distance from the axis, with the cell-free layer; the dashed
# line is the parabola of the plain fluid at the same mean velocity.

# %%
figure, axes = plt.subplots(1, 2, figsize=(9, 3.5))
for panel, column, factor, label in ((axes[0], "H", 1, "haematocrit"),
                                     (axes[1], "U", 1e3, "velocity [mm/s]")):
    s, values, errors = run.profile(column, first)
    panel.errorbar(1e6*s, factor*values, factor*np.nan_to_num(errors), fmt="o-", ms=4,
                   color="firebrick")
    panel.axvline(1e6*(RADIUS - means["layer"][0]), color="0.6", lw=0.8)
    panel.set(xlabel="distance from the axis [um]", ylabel=label, xlim=(0, 1e6*RADIUS))
s = np.linspace(0, RADIUS, 50)
axes[1].plot(1e6*s, 2e3*means["Ub"][0]*(1 - (s/RADIUS)**2), "--", color="0.5", lw=1)
for panel in axes:
    panel.set_ylim(bottom=0)
figure.tight_layout()
figure.savefig("haematology.png", dpi=110)

# %% [markdown]
# ## How the red cells move to the axis
# Positions of all red cells, without jumps at the ends of the periodic tube.

# %%
time, cell, x = run.trajectories()
away = np.hypot(x[..., 1], x[..., 2])
print("mean distance of %d red cells from the axis: %.2f um at %g s, %.2f um at %g s; mean way"
      " %.0f um" % (len(cell), 1e6*away[:, 0].mean(), time[0], 1e6*away[:, -1].mean(), time[-1],
                    1e6*(x[:, -1, 0] - x[:, 0, 0]).mean()))
