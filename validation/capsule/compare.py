"""Deformation of a capsule in shear over time, against boundary integrals in the same box."""

from math import log2
from results import Results, plt, read, save

LAWS = {"neoHookean": "NH", "skalak": "SK"}


def courses(file, resolution):
    """Solutions by law, viscosity ratio, capillary number, stiffness and curvature of bending,
    height and length of the box (0: unbounded), and resolution: rows by time."""
    result = {}
    for r in read(f"reference/{file}"):
        key = (r["law"], r["viscosity_ratio"], r["Ca"], r.get("bending", 0), r.get("curvature", 0),
               r["box_H"], r["box_Lx"])
        result.setdefault(key, {}).setdefault(int(r[resolution]), {})[round(r["t"], 3)] = r
    return result


spectral = courses("capsule_spectral.csv", "degree")
triangles = courses("capsule_boundary_integral.csv", "nodes")
SOURCE = "boundary integrals in the same box (reference/capsule_spectral.csv)"


def reference(law, ratio, Ca, bending, curvature, height, length):
    """Of the highest degree."""
    ofDegree = spectral.get((LAWS[law], ratio, Ca, bending, curvature, height, length), {0: {}})
    return ofDegree[max(ofDegree)]


# Capsules with bending in the literature: courses by author
published = {}
for r in read("reference/capsule_NH_bending_shear.csv"):
    published.setdefault(r["source"], []).append((r["t_gdot"], r["D"]))
ends = [course[-1][1] for course in published.values()]
PUBLISHED = (f"published, {min(ends):.3f} to {max(ends):.3f} "
             "(reference/capsule_NH_bending_shear.csv)")

runs = {}
for r in read("data.csv"):
    key = (r["law"], r["Ca"], int(r["D_dx"]), r["step"], int(r["subdivisions"]), r["kernel"],
           r["ratio"], r["bending"], r["curvature"])
    runs.setdefault(key, []).append(r)

results = Results()
figure, (axes, bent) = plt.subplots(2, figsize=(8.5, 7), height_ratios=(3, 2), sharex=True)
axes.plot([], [], "k", lw=0.8, label="boundary integrals")
for course in published.values():
    bent.plot(*zip(*course), "0.7", lw=0.8)
bent.plot([], [], "0.7", lw=0.8, label="with bending, published")
for key, rows in runs.items():
    law, Ca, cells, step, subdivisions, kernel, ratio, bending, curvature = key
    nodes = 10*4**subdivisions + 2
    name = f"{cells} cells, step {step:g}, {nodes} nodes, {kernel}"
    if (law, Ca) != ("neoHookean", 0.15):
        name = f"{law}, Ca {Ca:g}, {name}"
    if ratio != 1:
        name += f", viscosity ratio {ratio:g}"
    if bending:
        name += f", bending {bending:g}, curvature {curvature:g}"
    results.add(f"volume, {name}", max((r["volume"] for r in rows), key=lambda v: abs(v - 1)), "-",
                1, 1e-6, "volume at rest")
    results.report(f"outer correctors, {name}", rows[-1]["correctors"], "-", "mean of the steps")
    course = reference(law, ratio, Ca, bending, curvature, rows[0]["height"], rows[0]["length"])
    if (cells, step, subdivisions, kernel) == (10, 0.05, 3, "threePoint"):
        times = [t for t in sorted(course) if t <= rows[-1]["t"]]
        panel = bent if bending else axes
        panel.plot(times, [course[t]["D"] for t in times], "k", lw=0.8)
        label = f"{law}, Ca {Ca:g}, viscosity ratio {ratio:g}"
        if bending:
            label = f"Ca {Ca:g}, with bending, curvature {curvature:g}/R"
        panel.plot([r["t"] for r in rows], [r["D"] for r in rows], ".", ms=4, label=label)
    known = [r for r in rows if round(r["t"], 3) in course and r["t"] > 0]
    if not known:
        results.report(f"D at t = {rows[-1]['t']:g}, {name}", rows[-1]["D"], "-", "no reference")
        continue
    last = known[-1]
    at_end = course[round(last["t"], 3)]
    limit = "2%" if cells >= 16 else "4%"
    results.add(f"D at t = {last['t']:g}, {name}", last["D"], "-", at_end["D"], limit, SOURCE)
    if bending and cells >= 16:
        results.add(f"D at t = {last['t']:g} in the published range, {name}", last["D"], "-",
                    (min(ends) + max(ends))/2, round((max(ends) - min(ends))/2, 5), PUBLISHED)
    results.add(f"angle at t = {last['t']:g}, {name}", last["angle_deg"], "degrees",
                at_end["angle_deg"], 1, SOURCE)
    worst = max(known, key=lambda r: abs(r["D"] - course[round(r["t"], 3)]["D"]))
    results.add(f"D farthest from the course, t = {worst['t']:g}, {name}", worst["D"], "-",
                course[round(worst["t"], 3)]["D"], 0.01, SOURCE)

# The error of the time step, and its order from the differences between steps halved twice
usual = "neoHookean", 0.15, 10
steps = {step: {r["t"]: r["D"] for r in runs[usual + (step, 3, "threePoint", 1, 0, 0)]}
         for step in (0.1, 0.05, 0.025, 0.0125) if usual + (step, 3, "threePoint", 1, 0, 0) in runs}
if len(steps) == 4:
    end = max(steps[0.0125])
    D = {step: rows[end] for step, rows in steps.items()}
    results.add(f"D at t = {end:g} with steps of 0.05 over that with 0.0125", D[0.05]/D[0.0125],
                "-", 1, 0.002, "the shorter step")
    for step in 0.1, 0.05:
        halved = (D[step] - D[step/2])/(D[step/2] - D[step/4])
        results.report(f"order of the time step at {step:g}, {step/2:g} and {step/4:g}",
                       log2(abs(halved)), "-", "of the differences")

# Extrapolated over the mesh in the second order
for key, rows in runs.items():
    law, Ca, cells, step, subdivisions, kernel, ratio, bending, curvature = key
    fine = runs.get((law, Ca, 16) + key[3:])
    if cells == 10 and step == 0.05 and fine:
        t = fine[-1]["t"]
        coarse = next(r["D"] for r in rows if r["t"] == t)
        part = 1/((16/10)**2 - 1)
        course = reference(law, ratio, Ca, bending, curvature, rows[0]["height"],
                           rows[0]["length"])
        results.report(f"D at t = {t:g} extrapolated from 10 and 16 cells over the reference,"
                       f" Ca {Ca:g}, viscosity ratio {ratio:g}" + (
                           f", bending {bending:g}, curvature {curvature:g}" if bending else ""),
                       (fine[-1]["D"] + part*(fine[-1]["D"] - coarse))/course[round(t, 3)]["D"],
                       "-", "second order")

# The reference: solved anew, with fewer harmonics, and the solutions on triangles
for r in read("solved.csv")[-1:]:
    course = reference("neoHookean", r["viscosity_ratio"], r["Ca"], 0, 0, r["box_H"], r["box_Lx"])
    results.add(f"reference, solved with degree {r['degree']:g}, t = {r['t']:g}", r["D"], "-",
                course[round(r["t"], 3)]["D"], "0.5%", "more harmonics")
for key, ofDegree in spectral.items():
    law, ratio, Ca, bending, curvature, height, length = key
    case = f"{law}, viscosity ratio {ratio:g}, Ca {Ca:g}, " + (
        f"box {length:g} x {height:g}" if height else "unbounded") + (
        f", bending {bending:g}, curvature {curvature:g}" if bending else "")
    finest = ofDegree[max(ofDegree)]
    for degree, course in ofDegree.items():
        if degree < max(ofDegree):
            t = max(course)
            results.add(f"reference, degree {degree} over {max(ofDegree)}, t = {t:g}, {case}",
                        course[t]["D"]/finest[t]["D"], "-", 1, 0.003, "more harmonics")
    for nodes, course in triangles.get(key, {}).items():
        for t in 2, 4:
            if t in course and t in finest:
                name = f"triangles, {nodes} nodes, over the reference, t = {t}, {case}"
                part = course[t]["D"]/finest[t]["D"]
                if nodes == 2562 and t == 2:
                    results.add(name, part, "-", 1, 0.003, "another method")
                else:
                    results.report(name, part, "-", "second order in the triangles")

# Without a box and a curvature, one of the published solutions is of the same energy
same = spectral["NH", 1, 0.15, 0.1125, 0, 0, 0][6]
t = max(same)
results.add(f"reference, bending 0.1125, unbounded, t = {t:g}", same[t]["D"], "-",
            published["subdivision_methods_C_S"][-1][1], "0.3%",
            "published, on subdivided triangles")

bent.set_xlabel("time x shear rate")
for panel in axes, bent:
    panel.set_ylabel("Taylor deformation D")
    panel.legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
save(figure, "capsule.png")
results.write()
