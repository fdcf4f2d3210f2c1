"""Torque on a rotating sphere and rate of a free sphere in shear, against Stokes flow.

In a simple-cubic array the torque is 8 pi mu a^3 omega/(1 - phi), phi the volume fraction: the
periodic sum of rotlets lacks the mean, -T/(6 mu L^3) of rotation. In shear omega = gamma/2."""

import math
from results import Results, deviation, mean, plt, read, save

mu = 1e-3
a = 2e-6

groups = {}
for r in read("data.csv"):
    if r["test"] == "torque":
        phi = 4/3*math.pi*(a/r["box_m"])**3
        ratio = r["value"]*(1 - phi)/(8*math.pi*mu*a**3)
    else:
        ratio = r["value"]/0.5
    groups.setdefault((r["test"], r["D_dx"]), []).append(ratio)

results = Results()
sources = {
    "torque": "Stokes (1845): 8 pi mu a^3 omega, periodic correction 1/(1 - phi)",
    "rate": "Einstein (1906): omega = gamma/2",
}
names = {"torque": "torque on a rotating sphere", "rate": "rotation rate in shear"}
figure, axes = plt.subplots()
for test in names:
    keys = sorted(k for k in groups if k[0] == test)
    for key in keys:
        print(f"{names[test]} D/dx {key[1]:g}: {mean(groups[key]):.4f} +- "
              f"{deviation(groups[key]):.4f} of the exact value")
        limit = "2%" if test == "rate" or key[1] >= 12 else "3%" if key[1] >= 8 else "10%"
        results.add(f"{names[test]} D/dx {key[1]:g}", mean(groups[key]), "-", 1, limit,
                    sources[test])
    axes.errorbar([k[1] for k in keys], [mean(groups[k]) for k in keys],
                  [deviation(groups[k]) for k in keys], marker="o", capsize=3, label=names[test])
axes.axhline(1, color="k", lw=1)
axes.set_xlabel("sphere diameter / mesh cell width")
axes.set_ylabel("computed / exact in Stokes flow")
axes.legend()
save(figure, "rotatingSphere.png")
results.write()
