"""Deformation, areal strain and damage of the cell in the contraction and in shear."""
import matplotlib
import numpy as np
from clumps import table

matplotlib.use("Agg")
import matplotlib.pyplot as plt     # noqa: E402

VISCOSITY = 28.2e-6*1025        # [Pa s] (constant/transportProperties)
SHEAR = 2*2.16e-3/24e-6         # [1/s] (0.orig/U, system/shear)
END = 60                        # of the contraction [um] (system/extension)


def columns(case):
    """Time, place, velocity and the tables of shape and damage, over time."""
    force, shape, damage = (table(case, name)
                            for name in ("clumpForce", "clumpShape", "clumpDamage"))
    result = {name: np.array([r[name] for r in damage]) for name in (
        "time", "stress", "stressPeak", "deformation", "arealStrain", "arealStrainPeak",
        "pores", "law")}
    result.update({"x": 1e6*np.array([r["x"] for r in force]),
                   "Ux": np.array([r["Ux"] for r in force]),
                   "L1": 1e6*np.array([r["L1"] for r in shape]),
                   "L2": 1e6*np.array([r["L2"] for r in shape])})
    return result


flows = {case: columns(case) for case in ("extension", "shear")}
extension = flows["extension"]
inside = (extension["x"] > 20) & (extension["x"] < 50)
rate, start = np.polyfit(1e-6*extension["x"][inside], extension["Ux"][inside], 1)
departure = np.abs(1e-6*rate*extension["x"] + start - extension["Ux"])[inside].max()
print("the speed of the cell grows by %.0f 1/s, within %.1f %%: %.1f Pa; in shear %.0f 1/s: %.1f Pa"
      % (rate, 100*departure/extension["Ux"][inside].mean(), 2*VISCOSITY*rate, SHEAR,
         VISCOSITY*SHEAR))
leaves = np.flatnonzero(extension["x"] < END)[-1]
print("after %.1f ms, at the end of the contraction:" % (1e3*extension["time"][leaves]))
for case, c in flows.items():
    k = min(leaves, len(c["time"]) - 1)
    print("%-9s  %.1f x %.1f um, deformation %.2f, largest stress %.0f Pa, areal strain %.1f %%, "
          "pores %.1e, law %.1e"
          % (case, c["L1"][k], c["L2"][k], c["deformation"][k], c["stressPeak"][k],
             100*c["arealStrainPeak"][k], c["pores"][k], c["law"][k]))

figure, axes = plt.subplots(1, 3, figsize=(11, 3.4), sharex=True)
for case, c in flows.items():
    shown = slice(leaves + 1) if case == "extension" else slice(None)
    for axis, values in zip(axes, (c["deformation"], 100*c["arealStrain"], c["stress"])):
        axis.plot(1e3*c["time"][shown], values[shown], label=case)
for axis, name in zip(axes, ("deformation (L - W)/(L + W)", "largest areal strain [%]",
                             "stress around the cell [Pa]")):
    axis.set_xlabel("time [ms]")
    axis.set_ylabel(name)
    axis.grid(alpha=0.3)
axes[0].legend()
figure.tight_layout()
figure.savefig("result.png", dpi=120)
