"""The point of the capsule in the picture of deformation over area, its tensions and its outline.

A notebook as a script: editors that know cells (# %%) run it cell by cell, python3 as a whole.
"""

# %% [markdown]
# # A capsule in a cytometer
# `read` gives the run in the present folder, and the name of a table a table of it: with the name
# of a column it is an array, with a number a row.

# %%
import matplotlib.pyplot as plt
from clumps import read

MEAN_VELOCITY = 0.1     # constant/fvOptions [m/s]

run = read(".")
contour, state, motion = run["clumpContour"], run["membraneState"], run["clumpForce"]

# %% [markdown]
# ## What the camera sees
# The deformation is 1 - circularity of the convex hull. It is steady when it does not change over
# the last quarter of the run.

# %%
last, before = contour[-1], contour[3*len(contour)//4]
rising = abs(last["deformation"] - before["deformation"]) > 0.01*last["deformation"]
print(f"area {last['area']*1e12:.1f} um2, deformation {last['deformation']:.4f}, a quarter of the "
      f"run before {before['deformation']:.4f}"
      f"{': not steady, take a later endTime' if rising else ''}")
print(f"inertia ratio {last['inertiaRatio']:.3f}")
if last["hullArea"] > 1.01*last["area"]:
    print("The outline is not convex: the nodes have lost the steady shape, see doc/cytometry.md")

# %% [markdown]
# ## The membrane
# A tension below zero would buckle the membrane.

# %%
print(f"tensions {state[-1]['smallestTension']*1e3:.1f} to {state[-1]['largestTension']*1e3:.1f} "
      f"mN/m, at rest {state[0]['meanTension']*1e3:.1f}")
print(f"velocity {motion[-1]['Ux']/MEAN_VELOCITY:.2f} of the mean of the flow")

# %% [markdown]
# ## Pictures
# The way of the capsule in the picture of deformation over area, and its membrane seen along z.

# %%
figure, (way, shape) = plt.subplots(1, 2, figsize=(9, 4))
way.plot(1e12*contour["area"], contour["deformation"], color="0.6")
way.plot(1e12*last["area"], last["deformation"], "o", color="firebrick")
way.set(xlabel="area [um2]", ylabel="deformation")
membrane = run.membranes()
x = 1e6*(membrane["x"] - membrane["x"].mean(axis=0))
shape.triplot(x[:, 0], x[:, 1], membrane["triangles"], color="firebrick", lw=0.3)
shape.set(xlabel="along the channel [um]", ylabel="across [um]", aspect="equal")
figure.tight_layout()
figure.savefig("result.png", dpi=110)
