"""Drag of a sphere near a wall over 6 pi mu a U: Faxen (parallel) and Brenner 1961 (normal)."""

from results import Results, mean, plt, read, save

table = read("reference/sphere_wall_corrections.csv")
exact = {
    direction: {r["x"]: r["lambda"] for r in table if r["type"] == f"{short}_gap_over_a"}
    for direction, short in (("parallel", "par"), ("normal", "perp"))
}
source = {
    "parallel": "Faxen 1922, reference/sphere_wall_corrections.csv",
    "normal": "Brenner 1961, reference/sphere_wall_corrections.csv",
}

groups = {}
for r in read("data.csv"):
    groups.setdefault((r["direction"], r["gap_over_a"], r["D_dx"], r["width_over_D"]),
                      []).append(r["lambda"])

# A gap of one mesh cell, see the README
known = {("normal", 0.5, 4, 12): 3.00515, ("normal", 0.5, 4, 20): 2.99377}
results = Results()
figure, axes = plt.subplots()
for (direction, gap, resolution, width), values in groups.items():
    if gap in exact[direction]:
        name = f"drag {direction} gap/a {gap:g} D/dx {resolution:g} box {width:g} D"
        results.add(name, mean(values), "6 pi mu a U", exact[direction][gap],
                    "3%", source[direction],
                    known.get((direction, gap, resolution, width)))
for colour, direction in enumerate(exact):
    gaps = sorted(g for g in exact[direction] if 0.25 < g <= 5)
    axes.plot(gaps, [exact[direction][g] for g in gaps], ".-", ms=4, color=f"C{colour}",
              label=f"{direction}, exact (tabulated)")
    for resolution, mark in (4, "o"), (8, "s"):
        points = [(k[1], mean(v)) for k, v in groups.items() if k[0] == direction
                  and k[2] == resolution]
        if points:
            axes.plot(*zip(*points), mark, mfc="none", color=f"C{colour}",
                      label=f"D/dx {resolution}")
axes.set_xlabel("gap between sphere and wall / radius a")
axes.set_ylabel("drag / Stokes drag 6 pi mu a U")
axes.set_xscale("log")
axes.set_xticks([0.3, 0.5, 1, 2, 3, 5], ["0.3", "0.5", "1", "2", "3", "5"])
axes.legend()
save(figure, "sphereWall.png")
results.write()
