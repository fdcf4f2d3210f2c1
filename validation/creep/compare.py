"""Normalised creep compliance, recovery of two cells, one bond against the exact solution;
figure."""
import math

from clumps import table
from results import Results, plt, read, save, write_table

REST = 7.6e-6
out = Results()
data = []


def compliance(case):
    shape = table(case, "clumpShape", clump=0)
    final = shape[-1]["Lx"]
    curve = [(0.0, 1.0)] + [(s["time"], (final - s["Lx"])/(final - REST)) for s in shape]
    data.extend([case, f"{t:g}", f"{value:.6g}"] for t, value in curve[::25])
    return curve


def half_time(curve):
    for (t0, y0), (t1, y1) in zip(curve, curve[1:]):
        if y1 <= 0.5:
            return t0 + (t1 - t0)*(y0 - 0.5)/(y0 - y1)


betas = {b: compliance(f"beta{b}") for b in (500, 1000, 1500, 3000)}
forces = {7: betas[1500], **{f: compliance(f"force{f}") for f in (20, 50, 100)}}

rise = max(b[1] - a[1] for curve in [*betas.values(), *forces.values()] for a,
           b in zip(curve, curve[1:]))
out.add("normalised creep compliance: largest rise in a step", max(rise, 0.0), "-", 0, 1e-6,
        "monotone from 1 to 0")
times = [half_time(c) for c in forces.values()]
out.add("half time, largest ratio from a force to the next larger",
        max(b/a for a, b in zip(times, times[1:])), "-", 0,
        0.999, "faster with larger force (Fig. 4b of the paper)")
print("half times", dict(zip(forces, times)))
slow = [half_time(c) for c in betas.values()]
out.add("half time over beta, largest deviation from proportional",
        100*max(abs(t/b/(slow[0]/500) - 1) for t, b in zip(slow, betas)), "%", 0, 0.001, "Eq. 10")

cells = {}
for cell in ("hochmuth01", "hochmuth02"):
    rows = read(cell + ".fit/residuals.csv")
    error = [float(row["model"]) - float(row["measured"]) for row in rows]
    out.add(f"recovery {cell}: RMS of length/width", math.sqrt(sum(e*e for e in error)/len(error)),
            "-", 0, 0.03,
            "Hochmuth et al. 1979")
    cells[cell] = rows
    data.extend([cell, f"{row['time']:g}", f"{row['model']:.6g}"] for row in rows)

# x(t) = F/K (1 - exp(-t/tau)); K = E_b A_b/l_b of the healthy cell
F, K, TAU, BOND = 7e-12, 64.3e-12/2e-6, 0.01, 2e-6
worst = max(abs((s["Lx"] - 2e-6 - BOND)/(F/K) - (1 - math.exp(-s["time"]/TAU)))
            for s in table("bond", "clumpShape"))
out.add("one bond, largest error of x K/F, step tau/100", 100*worst, "%", 0, 0.0005,
        "Kelvin-Voigt exact")
write_table("data.csv", ["case", "t_s", "value"], data)

fig, axes = plt.subplots(1, 3, figsize=(12, 3.6), squeeze=False)
for ax, curves, name in ((axes[0][0], betas, "beta = {}"), (axes[0][1], forces, "{} pN")):
    for key, curve in curves.items():
        ax.plot([p[0] for p in curve], [p[1] for p in curve], label=name.format(key))
    ax.set(xlabel="time [s]", ylabel="elongation still to come / final elongation", xlim=(0, 0.5))
    ax.legend()
axes[0][0].set_title("7 pN")
axes[0][1].set_title("beta = 1500")
for (cell, rows), colour in zip(cells.items(), ("C0", "C3")):
    curve = read(cell + ".fit/curve.csv")
    axes[0][2].plot([float(p["time"]) for p in curve], [float(p["ratio"]) for p in curve],
                    color=colour, label="fit")
    axes[0][2].plot([float(p["time"]) for p in rows], [float(p["measured"]) for p in rows], "o",
                    ms=3, color=colour,
                    label=f"Hochmuth 1979, cell {cell[-1]}")
axes[0][2].set(title="recovery", xlabel="time after release [s]", ylabel="length / width")
axes[0][2].legend()
save(fig, "creep.png")
out.write()
