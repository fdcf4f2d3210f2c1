"""Drag of a periodic sphere on uniform, graded and locally split meshes against Zick and Homsy
(1982)."""

from results import Results, mean, plt, read, save

rows = read("data.csv")
reference = next(r["K_zick"]
                 for r in read("../sphereArray/reference/periodic_sphere_array_drag.csv")
                 if r["phi"] == 0.064)

results = Results()
figure, axes = plt.subplots()
for place, (mesh, limit) in enumerate((("uniform", "1%"), ("graded", "3%"), ("split", "2%"))):
    values = [r["K"] for r in rows if r["mesh"] == mesh]
    cells = mean([r["cells"] for r in rows if r["mesh"] == mesh])
    results.add(f"mean drag, {mesh} mesh, {cells:.0f} cells", mean(values), "6 pi mu a U",
                reference, limit,
                "Zick and Homsy 1982, ../sphereArray/reference/periodic_sphere_array_drag.csv")
    axes.plot([place]*len(values), [v/reference for v in values], "o")
axes.axhline(1, color="k", lw=1)
axes.set_xticks(range(3), ["uniform", "graded 1:4", "split cells"])
axes.set_ylabel("drag / drag of Zick and Homsy (1982)")
save(figure, "meshes.png")
results.write()
