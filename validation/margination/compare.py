"""Beads in a slit with more and more red cells: way to the walls and diffusivity."""

import numpy as np
from results import Results, plt, read, save

results = Results()

HALF = 10                   # of the slit [um]
# Of platelets across a shear flow of 100 1/s at 35 %, from the public trajectories of
# kotsaloscv/PLTs-FatTails (CC BY 4.0), computed for this project: by lag [s], in um2/s
TRAJECTORIES = {0.01: (129, 4), 0.02: (135, 4), 0.05: (134, 5)}
# See README
KNOWN = {0.01: 12.4749, 0.02: 17.3345, 0.05: 15.0534}


def table(name):
    return np.genfromtxt("history-%s.csv" % name, delimiter=",", names=True, dtype=None,
                         encoding=None)


figure, (paths, spread) = plt.subplots(1, 2, figsize=(9, 3.6))
diffusivity, way = {}, {}
for r in read("data.csv"):
    rows, lags = table(r["history"]), table(r["history"] + "-D")
    name = "%s, H %g" % (r["flow"], r["H"])
    last = lags[(lags["time"] == lags["time"][-1]) & (lags["type"] == "bead")]
    last = last[np.isfinite(last["D"])]
    D = {round(row["lag"], 6): (1e12*row["D"], 1e12*row["error"]) for row in last}
    spread.errorbar([1e3*lag for lag in D], [d for d, _ in D.values()],
                    [e for _, e in D.values()], fmt="o-", label=name)
    if r["flow"] == "shear":
        for lag, (value, error) in D.items():
            if lag in TRAJECTORIES:
                results.add("%s, lag %g ms: diffusivity of beads" % (name, 1e3*lag), value,
                            "um2/s", TRAJECTORIES[lag][0], "20%",
                            "PLTs-FatTails; standard error here %.0f" % error, KNOWN.get(lag))
        results.add(name + ", lag 20 ms: diffusivity beside experiments", D[0.02][0], "um2/s", 15,
                    10, "5 to 25: Turitto, Benis and Leonard 1972")
        continue
    times = np.unique(rows["time"])
    distance = np.array([HALF - 1e6*np.abs(rows["y"][rows["clump"] == c])
                         for c in np.unique(rows["clump"])])
    early = distance[:, times <= 0.1*r["end_s"]].mean(axis=1)
    late = distance[:, times > 0.8*r["end_s"]].mean(axis=1)
    way[r["H"]] = late - early
    lag = min(D, key=lambda t: abs(t - 6e-3))
    diffusivity[r["H"]] = D[lag]
    paths.plot(1e3*times, distance.mean(axis=0), label=name)
    text = "standard error %.2f" % (way[r["H"]].std()/np.sqrt(len(early)))
    if r["H"] == 0:
        results.add(name + ": change of the distance of the beads from the wall",
                    way[0].mean(), "um", 0, 0.05, "no red cells; " + text)
        results.add("%s, lag %g ms: diffusivity of beads" % (name, 1e3*lag), D[lag][0], "um2/s",
                    0, 0.5, "no red cells")
    else:
        results.report(name + ": change of the distance of the beads from the wall",
                       way[r["H"]].mean(), "um", text)
        results.report("%s, lag %g ms: diffusivity of beads" % (name, 1e3*lag), D[lag][0],
                       "um2/s", "standard error %.0f" % D[lag][1])

H = sorted(diffusivity)
results.add("pairs of haematocrits whose diffusivities of beads are not in their order",
            sum(diffusivity[a][0] >= diffusivity[b][0] for a, b in zip(H, H[1:])), "-", 0, 0.5,
            "faster at higher H: Fitzgibbon et al. 2015")
paths.set_xlabel("time [ms]")
paths.set_ylabel("distance of the beads from the wall [um]")
paths.legend(fontsize=6)
spread.set_xlabel("lag [ms]")
spread.set_ylabel("diffusivity of the beads [um$^2$/s]")
spread.legend(fontsize=6)
figure.tight_layout()
save(figure, "margination.png")
results.write()
