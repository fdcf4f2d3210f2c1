"""Peak velocity and history of settling spheres against ten Cate et al. (2002)."""

from results import Results, plt, read, save

reference = {r["case"]: r for r in read("reference/tencate2002_params_and_peaks.csv")}
curves = read("reference/tencate2002_curves.csv")
runs = read("data.csv")
uniform = [r for r in runs if r["refined"] == "no"]
finest = max(r["D_dx"] for r in uniform)

# Explained in the README
known = {("E1", "4"): 0.0344741, ("E4", "4"): 0.116106, ("E1", "8"): 0.0346858}
results = Results()
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2))
for r in runs:
    peak = reference[r["case"]]["u_max_exp_m_s"]
    mesh = f"{r['D_dx']:g}" + ("" if r["refined"] == "no" else f" to {2*r['D_dx']:g}")
    results.add(f"peak velocity {r['case']} D/dx {mesh}", r["peak_m_s"], "m/s", peak,
                "3%", "ten Cate et al. 2002, Table II, reference/tencate2002_params_and_peaks.csv",
                known.get((r["case"], mesh)))

for colour, case in enumerate(("E1", "E2", "E4")):
    for axes, quantity in (left, "vel"), (right, "gap"):
        points = [c for c in curves
                  if (c["src"], c["case"], c["quantity"]) == ("ff", case, quantity)]
        axes.plot([c["t_s"] for c in points], [c["value"] for c in points], "o", mfc="none", ms=4,
                  color=f"C{colour}")
        for resolution in sorted({r["D_dx"] for r in uniform}):
            if not any((r["case"], r["D_dx"]) == (case, resolution) for r in uniform):
                continue
            rows = read(f"history-{case}-{resolution:g}.csv")
            shown = [r["velocity_m_s"] if quantity == "vel" else (r["z_m"] - 0.0075)/0.015
                     for r in rows]
            axes.plot([r["t_s"] for r in rows], shown, color=f"C{colour}",
                      ls="-" if resolution == finest else "--",
                      label=f"{case}, D/dx {resolution:g}" if axes is left else None)
left.set_ylabel("velocity of the sphere [m/s]")
right.set_ylabel("gap between sphere and floor / D")
right.set_ylim(0, 8.5)
for axes in left, right:
    axes.set_xlim(0, 2)
    axes.set_xlabel("time [s]")
left.plot([], [], "ko", mfc="none", ms=4, label="experiment")
left.legend(fontsize=8)
save(figure, "settlingSphere.png")
results.write()
