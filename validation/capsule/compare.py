"""Deformation of a capsule in shear over time, against a boundary-integral solution: in the same
box, or unbounded where the viscosities differ and the box is wide."""

from results import Results, plt, read, save

# Recorded misses, by run and its last time: D there, and D where it is farthest from the course
KNOWN = {}

SOURCES = {
    True: "boundary integrals in the same box (reference/capsule_boundary_integral.csv)",
    False: "boundary integrals, unbounded (reference/capsule_boundary_integral.csv)",
}

# By viscosity ratio; those other than 1 are unbounded
reference = {}
for r in read("reference/capsule_boundary_integral.csv"):
    box = (6, 8) if r["viscosity_ratio"] == 1 else (0, 0)
    if (r["law"], r["Ca"], r["nodes"], r["box_H"], r["box_Lx"]) == ("NH", 0.15, 642) + box:
        reference.setdefault(r["viscosity_ratio"], {})[round(r["t"], 3)] = r

runs = {}
for r in read("data.csv"):
    key = int(r["D_dx"]), r["step"], int(r["subdivisions"]), r["kernel"], r["ratio"]
    runs.setdefault(key, []).append(r)

results = Results()
figure, axes = plt.subplots()
for ratio, course in sorted(reference.items()):
    times = [t for t in sorted(course) if t <= 6]
    axes.plot(times, [course[t]["D"] for t in times], "k", lw=0.8)
axes.plot([], [], "k", lw=0.8, label="boundary integrals")
for key, rows in runs.items():
    cells, step, subdivisions, kernel, ratio = key
    course = reference.get(ratio, {})
    nodes = 10*4**subdivisions + 2
    name = f"{cells} cells, step {step:g}, {nodes} nodes, {kernel}"
    if ratio != 1:
        name += f", viscosity ratio {ratio:g}"
    source = SOURCES[ratio == 1]
    results.add(f"volume, {name}", max((r["volume"] for r in rows), key=lambda v: abs(v - 1)), "-",
                1, 1e-6, "volume at rest")
    results.report(f"outer correctors, {name}", rows[-1]["correctors"], "-", "mean of the steps")
    axes.plot([r["t"] for r in rows], [r["D"] for r in rows], ".-", lw=0.8, label=name)
    known = [r for r in rows if round(r["t"], 3) in course and r["t"] > 0]
    if not known:
        results.report(f"D at t = {rows[-1]['t']:g}, {name}", rows[-1]["D"], "-", "no reference")
        continue
    last = known[-1]
    at_end = course[round(last["t"], 3)]
    limit = "2%" if cells >= 16 else "4%"
    misses = KNOWN.get(key + (last["t"],), (None, None))
    results.add(f"D at t = {last['t']:g}, {name}", last["D"], "-", at_end["D"], limit, source,
                misses[0])
    results.add(f"angle at t = {last['t']:g}, {name}", last["angle_deg"], "degrees",
                at_end["angle_deg"], 1, source)
    worst = max(known, key=lambda r: abs(r["D"] - course[round(r["t"], 3)]["D"]))
    results.add(f"D farthest from the course, t = {worst['t']:g}, {name}", worst["D"], "-",
                course[round(worst["t"], 3)]["D"], 0.01, source, misses[1])

# The error of the time step: against a quarter of it
if (10, 0.0125, 3, "threePoint", 1) in runs:
    coarse = {r["t"]: r["D"] for r in runs[10, 0.05, 3, "threePoint", 1]}
    for r in runs[10, 0.0125, 3, "threePoint", 1][-1:]:
        results.add(f"D at t = {r['t']:g} with steps of 0.05 over that with 0.0125",
                    coarse[r["t"]]/r["D"], "-", 1, 0.002, "the shorter step")

axes.set_xlabel("time x shear rate")
axes.set_ylabel("Taylor deformation D")
axes.legend(fontsize=6)
save(figure, "capsule.png")
results.write()
