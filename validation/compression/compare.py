"""The force of the plates over the indentation against Tatara; figure with Hertz."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from references import MODULUS, RADIUS, hertz, tatara      # noqa: E402
from results import Results, plt, read, save                # noqa: E402

SOURCE = "Tatara 1991, doc/theory.md"
SCALE = MODULUS*RADIUS**2

# Contact on less than the distance of two nodes, and strains beyond Tatara's linear elasticity
KNOWN = {(2, 0.4, 0.1): 0.7978, (2, 0.4, 0.2): 1.0622, (2, 0.4, 0.6): 1.1187,
         (3, 0.4, 0.6): 1.0818}

rows = read("data.csv")
curves = {}
for r in rows:
    curves.setdefault((int(r["subdivisions"]), r["poisson"]), []).append(
        (r["indentation_m"]/RADIUS, r["force_N"]/SCALE, r["seconds"]))


def at(curve, d):
    """Force at an indentation, which is one of the curve"""
    return min(curve, key=lambda row: abs(row[0] - d))[1]


results = Results()
for (n, nu), curve in curves.items():
    for d in (0.1, 0.2, 0.4, 0.6):
        results.add(
            "%d nodes, Poisson ratio %g: force at d/R %g" % (10*4**n + 2, nu, d),
            at(curve, round(d/0.006)*0.006)/(tatara(round(d/0.006)*0.006*RADIUS, nu)/SCALE),
            "of Tatara", 1, 0.05, SOURCE, KNOWN.get((n, nu, d)))
    results.report("%d nodes, Poisson ratio %g: force at d/R 0.1" % (10*4**n + 2, nu),
                   at(curve, 0.102)/(hertz(0.102*RADIUS, nu)/SCALE), "of Hertz", "contact alone")
    results.report("%d nodes, Poisson ratio %g: processor time of a curve" % (10*4**n + 2, nu),
                   curve[0][2], "s", "101 states")

figure, axes = plt.subplots(figsize=(5, 3.6))
for (n, nu), curve in curves.items():
    axes.plot([c[0] for c in curve], [c[1] for c in curve],
              label="%d nodes, nu %g" % (10*4**n + 2, nu))
grid = [0.006*k for k in range(1, 101)]
axes.plot(grid, [hertz(d*RADIUS, 0.4)/SCALE for d in grid], "k:", label="Hertz, nu 0.4")
axes.plot(grid, [tatara(d*RADIUS, 0.4)/SCALE for d in grid], "k--", label="Tatara, nu 0.4")
axes.set_xlabel("indentation over radius")
axes.set_ylabel("force over G R$^2$")
axes.legend(fontsize=6)
save(figure, "compression.png")
results.write()
