"""Compares the drag of the sphere arrays with Zick and Homsy (1982) and draws it over D/dx."""

from results import Results, deviation, mean, plt, read, save

source = "Zick and Homsy 1982, reference/periodic_sphere_array_drag.csv"
K0 = {r["phi"]: r["K_zick"] for r in read("reference/periodic_sphere_array_drag.csv")
      if r["K_zick"] != ""}

groups = {}
for r in read("data.csv"):
    key = r["solidFraction"], r["forcing"], r["phi"], r["nominal_D_dx"]
    groups.setdefault(key, []).append(r)

limits = {4: (3, 2), 8: (2, 1), 16: (1, 0.3)}
known = {(0.216, 4): -8.78109}        # the gap is 1.4 mesh cells wide
results = Results()
for (fraction, forcing, phi, resolution), rows in groups.items():
    if (fraction, forcing) == ("tetClipping", "sharp"):
        errors = [100*(r["K"]/K0[phi] - 1) for r in rows]
        ofMean, ofDeviation = limits[resolution]
        name = f"phi {phi:g} D/dx {resolution:g}"
        results.add(f"mean drag error {name}", mean(errors), "%", 0, ofMean, source,
                    known.get((phi, resolution)))
        results.add(f"standard deviation {name}", deviation(errors), "%", 0, ofDeviation, source)

print("solid fraction, forcing: mean error +- standard deviation in %, seconds per run")
for (fraction, forcing, phi, resolution), rows in groups.items():
    errors = [100*(r["K"]/K0[phi] - 1) for r in rows]
    print(f"{fraction:15s} {forcing:11s} phi {phi:<6g} D/dx {resolution:<3g}"
          f"{mean(errors):8.1f} +- {deviation(errors):4.1f}   "
          f"{mean([r['seconds'] for r in rows]):6.2f} s")

figure, (left, right) = plt.subplots(1, 2, figsize=(11.5, 4))
models = sorted({k[:2] for k in groups}, key=lambda m: m != ("tetClipping", "sharp"))


def draw(axes, model, phi, **style):
    keys = sorted((k for k in groups if k[:2] == model and k[2] == phi), key=lambda k: k[3])
    errors = [[100*(r["K"]/K0[phi] - 1) for r in groups[k]] for k in keys]
    axes.errorbar([mean([r["D_dx"] for r in groups[k]]) for k in keys],
                  [mean(e) for e in errors], [deviation(e) for e in errors],
                  capsize=3, marker="o", ms=4, **style)


for phi in sorted({k[2] for k in groups}):
    draw(left, ("tetClipping", "sharp"), phi, label=f"volume fraction {phi:g}")
for model in models:
    draw(right, model, 0.064, label=" + ".join(model), lw=2 if model == models[0] else 1)
for axes in left, right:
    axes.axhline(0, color="k", lw=1)
    axes.set_xscale("log", base=2)
    axes.set_xticks([4, 8, 16], ["4", "8", "16"])
    axes.set_xlabel("sphere diameter / mesh cell width")
left.legend(fontsize=8)
right.legend(fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
left.set_title("recommended models", fontsize=10)
right.set_title("all models, volume fraction 0.064", fontsize=10)
left.set_ylabel("drag, deviation from Zick and Homsy (1982) [%]")
save(figure, "sphereArray.png")

results.write()
