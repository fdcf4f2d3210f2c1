"""Deformation of a capsule in shear over time, against a boundary-integral solution in the same
box."""

from results import Results, plt, read, save

# Recorded misses, by run and its last time: D there, and D where it is farthest from the course
KNOWN = {
    (10, 0.05, 3, "threePoint", 6): (0.29355, 0.29372),
    (10, 0.05, 3, "fourPoint", 1): (0.25512, 0.25512),
    (16, 0.05, 3, "threePoint", 2): (0.28255, None),
}

SOURCE = "boundary integrals in the same box (reference/capsule_boundary_integral.csv)"

reference = {}
for r in read("reference/capsule_boundary_integral.csv"):
    if (r["law"], r["viscosity_ratio"], r["Ca"], r["box_H"], r["box_Lx"]) == ("NH", 1, 0.15, 6, 8):
        reference[round(r["t"], 3)] = r

runs = {}
for r in read("data.csv"):
    key = int(r["D_dx"]), r["step"], int(r["subdivisions"]), r["kernel"]
    runs.setdefault(key, []).append(r)

results = Results()
figure, axes = plt.subplots()
times = sorted(reference)
axes.plot(times, [reference[t]["D"] for t in times], "k", label="boundary integrals")
for key, rows in runs.items():
    cells, step, subdivisions, kernel = key
    nodes = 10*4**subdivisions + 2
    name = f"{cells} cells, step {step:g}, {nodes} nodes, {kernel}"
    known = [r for r in rows if round(r["t"], 3) in reference and r["t"] > 0]
    last = known[-1]
    at_end = reference[round(last["t"], 3)]
    limit = "2%" if cells >= 16 else "4%"
    misses = KNOWN.get(key + (last["t"],), (None, None))
    results.add(f"D at t = {last['t']:g}, {name}", last["D"], "-", at_end["D"], limit, SOURCE,
                misses[0])
    results.add(f"angle at t = {last['t']:g}, {name}", last["angle_deg"], "degrees",
                at_end["angle_deg"], 1, SOURCE)
    worst = max(known, key=lambda r: abs(r["D"] - reference[round(r["t"], 3)]["D"]))
    results.add(f"D farthest from the course, t = {worst['t']:g}, {name}", worst["D"], "-",
                reference[round(worst["t"], 3)]["D"], 0.01, SOURCE, misses[1])
    results.add(f"volume, {name}", max((r["volume"] for r in rows), key=lambda v: abs(v - 1)), "-",
                1, 1e-6, "volume at rest")
    results.report(f"outer correctors, {name}", last["correctors"], "-", "mean of the steps")
    axes.plot([r["t"] for r in rows], [r["D"] for r in rows], ".-", lw=0.8, label=name)

# The error of the time step: against a quarter of it
if (10, 0.0125, 3, "threePoint") in runs:
    coarse = {r["t"]: r["D"] for r in runs[10, 0.05, 3, "threePoint"]}
    for r in runs[10, 0.0125, 3, "threePoint"][-1:]:
        results.add(f"D at t = {r['t']:g} with steps of 0.05 over that with 0.0125",
                    coarse[r["t"]]/r["D"], "-", 1, 0.002, "the shorter step")

axes.set_xlabel("time x shear rate")
axes.set_ylabel("Taylor deformation D")
axes.legend(fontsize=7)
save(figure, "capsule.png")
results.write()
