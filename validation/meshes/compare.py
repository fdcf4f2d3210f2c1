"""Drag of a periodic sphere on meshes that are not uniform against Zick and Homsy (1982)."""

from results import Results, mean, plt, read, save

KINDS = {   # in data.csv: what it is, limit
    "uniform": ("uniform", "1%"),
    "graded3": ("graded 1:3", "3%"),
    "graded": ("graded 1:4", "3%"),
    "aspect5": ("aspect ratio 5", "4%"),
    "split": ("split around the sphere", "2%"),
    "box": ("split in a box", "2%"),
    "polyhedra": ("polyhedral", "4%"),
    "30, 0": ("inclined by 30 degrees", "3%"),
    "45, 0": ("inclined by 45 degrees", "5%"),
}
SOURCE = "Zick and Homsy 1982, ../sphereArray/reference/periodic_sphere_array_drag.csv"

rows = read("data.csv")
reference = next(r["K_zick"]
                 for r in read("../sphereArray/reference/periodic_sphere_array_drag.csv")
                 if r["phi"] == 0.064)


def drag(mesh):
    return [r["K"] for r in rows if r["mesh"] == mesh]


results = Results()
figure, axes = plt.subplots()
for place, (mesh, (name, limit)) in enumerate(KINDS.items()):
    cells = mean([r["cells"] for r in rows if r["mesh"] == mesh])
    results.add(f"mean drag, {name}, {cells:.0f} mesh cells", mean(drag(mesh)), "6 pi mu a U",
                reference, limit, SOURCE)
    axes.plot([place]*len(drag(mesh)), [v/reference for v in drag(mesh)], "o")
for angle in 30, 45:
    for n in 1, 2:
        results.add(f"inclined by {angle} degrees, drag with nNonOrthogonalCorrectors {n}",
                    mean(drag(f"{angle}, {n}")), "6 pi mu a U", mean(drag(f"{angle}, 0")), "0.1%",
                    "nNonOrthogonalCorrectors 0")
axes.axhline(1, color="k", lw=1)
axes.set_xticks(range(len(KINDS)), [name for name, _ in KINDS.values()], rotation=30, ha="right")
axes.set_ylabel("drag / drag of Zick and Homsy (1982)")
save(figure, "meshes.png")
results.write()
