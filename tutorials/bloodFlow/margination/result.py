"""Where the beads are between the walls, over time; profiles, layers and diffusivities by type."""
import matplotlib
import numpy as np
from clumps import table

matplotlib.use("Agg")
import matplotlib.pyplot as plt     # noqa: E402

HALF = 10                       # height of the slit [um] over two (system/blockMeshDict)

rows = table(".", "clumpForce")
times = np.array(sorted({r["time"] for r in rows}))
height = {}                     # of each clump [um], over time
for r in rows:
    height.setdefault((r["type"], r["clump"]), []).append(1e6*r["y"])
fromWall = {name: np.array([HALF - np.abs(y) for (type_, _), y in height.items()
                            if type_ == name]) for name in ("bead", "healthy")}
even = HALF/2                   # of points that are spread evenly
print("distance from the wall, mean and error over the clumps [um]; evenly spread %.1f" % even)
for low, high in ((0, 0.02), (0.07, 0.09)):
    window = (times > low) & (times < high + 1e-9)
    text = []
    for name, y in fromWall.items():
        mean = y[:, window].mean(axis=1)
        text.append("%s %.1f +- %.1f" % (name, mean.mean(), mean.std()/np.sqrt(len(mean))))
    print("%3.0f to %3.0f ms: %s" % (1e3*low, 1e3*high, ", ".join(text)))

layer = 1e6*np.mean([r["layer_healthy"] for r in table(".", "cellFreeLayer") if r["time"] > 0.05])
within = (fromWall["bead"] < layer).mean(axis=0)
print("layer without red cells after 50 ms: %.2f um\n"
      "beads with their centre in it: %.0f %% in the first 20 ms, %.0f %% in the last"
      % (layer, 100*within[times < 0.02].mean(), 100*within[times > 0.07].mean()))
spread = table(".", "clumpDispersion")
last = [r for r in spread if r["time"] == spread[-1]["time"]]
print("diffusivity across the flow [um2/s] at lags of %s ms" % ", ".join(
    "%g" % (1e3*r["lag"]) for r in last if r["type"] == "bead"))
for name in fromWall:
    print("%11s: %s" % (name, ", ".join(
        "%.0f +- %.0f" % (1e12*r["DGradient"], 1e12*r["errorGradient"])
        for r in last if r["type"] == name)))

figure, (path, profile) = plt.subplots(1, 2, figsize=(9, 3.6))
for name, y in fromWall.items():
    path.plot(1e3*times, y.mean(axis=0), label=name)
for y in fromWall["bead"]:
    path.plot(1e3*times, y, "k", lw=0.3, alpha=0.5)
path.set_xlabel("time [ms]")
path.set_ylabel("distance from the wall [um]")
path.legend()
bins = [r for r in table(".", "clumpProfiles") if r["time"] > 0.05]
places = sorted({r["s"] for r in bins})
for name in fromWall:
    mean = np.array([np.mean([r["H_" + name] for r in bins if r["s"] == s]) for s in places])
    profile.plot(1e6*np.array(places), mean/mean.mean(), "o-", label=name)
profile.set_xlabel("place between the walls [um]")
profile.set_ylabel("volume over the mean, after 50 ms")
profile.legend()
figure.tight_layout()
figure.savefig("result.png", dpi=120)
