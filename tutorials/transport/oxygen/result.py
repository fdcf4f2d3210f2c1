"""Saturation of the red cells along the capillary, and where the oxygen is at the end."""
import matplotlib
from clumps import table

matplotlib.use("Agg")
import matplotlib.pyplot as plt     # noqa: E402

SITES, HALF, EXPONENT = 20.3, 0.0358, 2.7      # system/controlDict
SOLUBILITY, START, WALL = 1.35e-3, 0.135, 0.027    # mol/m3/mmHg; 0.orig/c
LENGTH, RADIUS = 30e-6, 5e-6


def saturation(c):
    """Hill's curve of the free concentration."""
    return c**EXPONENT/(c**EXPONENT + HALF**EXPONENT)


figure, axes = plt.subplots(1, 2, figsize=(8, 3.2))
print("way [um]   saturation of the red cells")
ways, values = [], []
for n in (0, 1):
    moves = table(".", "clumpForce", clump=n)
    rows = table(".", "oxygenClumps", clump=n)
    ways.append([1e6*(r["x"] - moves[0]["x"]) for r in moves])
    values.append([r["bound"]/(SITES*r["volume"]) for r in rows])
    axes[0].plot(ways[n], values[n], label=f"red cell {n}")
for way in range(0, int(min(w[-1] for w in ways)) + 1, 20):
    places = [next(i for i, x in enumerate(w) if x >= way) for w in ways]
    print(f"{way:8d}   " + "  ".join(f"{v[i]:.3f}" for v, i in zip(values, places)))
print(f"in equilibrium with the wall, at {WALL/SOLUBILITY:.0f} mmHg: {saturation(WALL):.3f}")

rows = table(".", "oxygen")
taken, before, sums = 0, 0, []
for r in rows:
    taken += r["out_walls"]*(r["time"] - before)
    before = r["time"]
    sums.append(r["inside"] + r["outside"] + taken)
wall, cells, plasma = (100*x/sums[0] for x in (taken, rows[-1]["inside"], rows[-1]["outside"]))
print(f"of the oxygen, the wall has taken {wall:.2f} %, the cells have {cells:.2f} %, the plasma "
      f"{plasma:.2f} %;\n"
      f"together {100*sums[-1]/sums[0]:.10f} %")

axes[0].axhline(saturation(WALL), color="grey", linestyle=":", label="as at the wall")
axes[0].set_xlabel("way [um]")
axes[0].set_ylabel("saturation")
axes[0].legend()
area = 2*3.14159*RADIUS*LENGTH
axes[1].plot([1e3*r["time"] for r in rows], [1e6*r["out_walls"]/area for r in rows])
axes[1].set_xlabel("time [ms]")
axes[1].set_ylabel("flux into the wall [$\\mu$mol/m$^2$/s]")
axes[1].set_ylim(0, 1e6*rows[20]["out_walls"]/area)
figure.tight_layout()
figure.savefig("result.png", dpi=120)
