"""Compares the drag of fixed clumps with the computed resistance of the same bodies.

The reference is for unbounded fluid; in a periodic cube of side L the mobility is lower by
2.8373/(6 pi mu L) (Hasimoto 1959, the leading order)."""

import math
from results import Results, deviation, mean, plt, read, save

source = ("reference/stokes_drag_rings_tori_biconcave_computed.csv, "
          "periodic correction of Hasimoto 1959")
mu = 1.2e-3
D = 7.82e-6
rows = {r["shape"]: r for r in read("reference/stokes_drag_rings_tori_biconcave_computed.csv")}
bodies = {
    "redBloodCell": "ring 10 spheres a=1.955;R=1.955 (CFDEM RBC)",
    "overlapping": "ring 10 overlapping a=1.30;R=2.61 (D=7.82)",
    "touching6": "ring 6 touching equal spheres",
    "touching8": "ring 8 touching equal spheres",
}


def reference(body, orientation, box):
    unbounded = mu*D*rows[bodies[body]]["Kz" if orientation == "broadside" else "Kx"]
    return 1/(1/unbounded - 2.8373/(6*math.pi*mu*box))


groups = {}
for r in read("data.csv"):
    groups.setdefault((r["body"], r["orientation"], r["D_dx"]), []).append(r)

results = Results()
figure, axes = plt.subplots()
marks = {}
for (body, orientation, resolution), runs in groups.items():
    exact = reference(body, orientation, runs[0]["box_m"])
    drags = [r["drag_N_s_m"] for r in runs]
    results.add(f"drag {body} {orientation} D/dx {resolution:g}", 1e6*mean(drags), "pN s/um",
                1e6*exact, "1.5%", source)
    ratio = [d/exact for d in drags]
    print(f"{body} {orientation} D/dx {resolution:g}: {100*(mean(ratio) - 1):+.2f} +- "
          f"{100*deviation(ratio):.2f} % over {len(runs)} positions")
    marks.setdefault((body, orientation), []).append((resolution, mean(ratio), deviation(ratio)))

for (body, orientation), points in marks.items():
    shift = 0.05*(list(marks).index((body, orientation)) - len(marks)/2)
    axes.errorbar([p[0] + shift for p in points], [p[1] for p in points], [p[2] for p in points],
                  marker="o" if orientation == "broadside" else "s", ms=5, capsize=3, lw=1,
                  label=f"{body}, {orientation}")
axes.axhline(1, color="k", lw=1)
axes.set_xticks([4, 8])
axes.set_xlabel("sphere diameter / mesh cell width")
axes.set_ylabel("drag / drag of the same body in Stokes flow")
axes.legend(fontsize=8)
save(figure, "fixedClump.png")
results.write()
