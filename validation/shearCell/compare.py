"""A red blood cell in shear: rotation and diameters at steps of 1e-4 and 1e-3 s against the
smallest step (1e-5 s) at the same resolution, bounds over the whole run, the scatter of the rate
over the place in the grid, the drift at rest."""

from results import Results, deviation, mean, plt, read, save

outer, thickness = 7.82e-6, 3.91e-6
start = 0.005       # [s] from rest
goal = {1e-4: 0.01, 1e-3: 0.05}        # of differences at any time
means = {1e-4: 0.005, 1e-3: 0.03}

# The start from rest, see the README
known = {("rate", 4, 1e-3, 1e-4): 0.3946}

results = Results()
runs = read("data.csv")


def history(run):
    """Time, longest and shortest diameter in the plane, thickness, rate."""
    return [(r["t_s"], max(r["L1_m"], r["L2_m"]), min(r["L1_m"], r["L2_m"]), r["L3_m"], -r["rate"])
            for r in read(run["file"])]


def turned(rows):
    """Angle turned by at every time."""
    angle, time, result = 0, 0, []
    for row in rows:
        angle += row[4]*(row[0] - time)
        time = row[0]
        result.append((time, angle))
    return result


def at(rows, times):
    """The rows nearest to the times."""
    result, i = [], 0
    for t in times:
        while i + 1 < len(rows) and abs(rows[i + 1][0] - t) <= abs(rows[i][0] - t):
            i += 1
        result.append(rows[i])
    return result


everywhere = [r for r in runs if r["test"] == "free"]
free = [r for r in everywhere if r["shift_x"] == 0]
for resolution in sorted({r["D_dx"] for r in free}):
    same = sorted((r for r in free if r["D_dx"] == resolution), key=lambda r: r["deltaT_s"])
    fine = history(same[0])
    end = min(0.1, same[0]["end_s"])
    for run in same:
        step = run["deltaT_s"]
        name = f"D/dx {resolution:g}, step {step:g}"
        rows = history(run)
        results.add(f"longest diameter / D over {run['end_s']:g} s, {name}",
                    max(r[1] for r in rows)/outer,
                    "-", 1, 0.1, "bounded")
        results.add(f"shortest diameter / D over {run['end_s']:g} s, {name}",
                    min(r[2] for r in rows)/outer,
                    "-", 1, 0.1, "bounded")
        results.add(f"thickness / rest over {run['end_s']:g} s, {name}",
                    max(r[3] for r in rows)/thickness,
                    "-", 1, 0.01, "not crumpled")
        if run is same[0]:
            continue

        # At the common times, a millisecond apart
        source = f"step {same[0]['deltaT_s']:g}"
        limit = goal[step]
        times = [0.001*(i + 1) for i in range(round(1000*end))]
        pairs = list(zip(at(rows, times), at(fine, times)))
        angles = at(turned(rows), times)[-1][1], at(turned(fine), times)[-1][1]
        results.add(f"angle turned in {end:g} s, {name}", angles[0], "rad", angles[1],
                    f"{100*means[step]:g}%", source)
        for column, what in (1, "longest diameter"), (2, "shortest diameter"), (4, "rate"):
            differences = [abs(a[column]/b[column] - 1) for a, b in pairs]
            started = round(1000*start)
            results.add(f"mean {what} over {end:g} s, {name}", mean([a[column] for a, _ in pairs]),
                        "1/s" if column == 4 else "m", mean([b[column] for _, b in pairs]),
                        f"{100*means[step]:g}%", source)
            results.add(f"largest difference of the {what} past {start:g} s, {name}",
                        max(differences[started:]),
                        "-", 0, limit, source)
            results.add(f"largest difference of the {what} in the first {start:g} s, {name}",
                        max(differences[:started]), "-", 0, limit, source,
                        known.get((what, resolution, step, same[0]["deltaT_s"])))

stiff = [r for r in runs if r["test"] == "rigid"]
for resolution in sorted({r["D_dx"] for r in stiff}):
    rates = [-r["rate"] for r in stiff if r["D_dx"] == resolution]
    results.add(f"rate of a stiff ring / (shear rate/2), mean of {len(rates)} places, D/dx "
                f"{resolution:g}",
                mean(rates)/100, "-", 1, "3%",
                "unbounded shear, any body of revolution about its axis")
    print(f"rate of a stiff ring, D/dx {resolution:g}: {mean(rates):.1f} +- "
          f"{deviation(rates):.1f} 1/s over"
          f" {len(rates)} places, {min(rates):.1f} to {max(rates):.1f}")

kinds = {"aside": "", "asideTight": ", ten outer correctors, tight"}
for run in runs:
    if run["test"] == "rest":
        results.add("drift of a cell at rest / D per step", run["rate"]*run["deltaT_s"]/outer, "-",
                    0, 1e-15,
                    "no force")
    if run["test"].startswith("aside"):
        results.report(f"velocity towards the wall, 1 um below the middle, step "
                       f"{run['deltaT_s']:g} s{kinds[run['test']]}",
                       1e6*run["rate"], "um/s",
                       "zero in Stokes flow for a body that keeps its shape")
    if run["test"] == "free":
        print(f"wall time of 0.1 s, D/dx {run['D_dx']:g}, step {run['deltaT_s']:g}:"
              f" {run['seconds']*0.1/run['end_s']:.0f} s"
              + (" (goal 30 s)" if (run["D_dx"], run["deltaT_s"]) == (5, 1e-4) else ""))

for run in everywhere:
    rows = [r for r in history(run) if r[0] <= 0.1 + 1e-9]
    print(f"rate over {rows[-1][0]:g} s, D/dx {run['D_dx']:g}, step {run['deltaT_s']:g}, "
          f"{run['shift_x']:g} cells beside the"
          f" middle: {turned(rows)[-1][1]/rows[-1][0]:.2f} 1/s")

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(14, 4.2))
colours = {4: "C0", 5: "C1", 8: "C2", 10: "C3"}
styles = {1e-5: "-", 1e-4: "--", 1e-3: ":"}
for run in sorted(everywhere, key=lambda r: (r["D_dx"], r["shift_x"], r["deltaT_s"])):
    rows = [r for r in history(run) if r[0] <= 0.1 + 1e-9]
    times = [1e3*r[0] for r in rows]
    style = {"ls": styles[run["deltaT_s"]], "color": colours[run["D_dx"]], "lw": 0.8
             if run["shift_x"] else 1.4}
    label = f"{run['D_dx']:g}, {run['deltaT_s']:.0e} s" + (", half a cell aside" if run["shift_x"]
                                                           else "")
    left.plot(times, [r[4] for r in rows], label=label, **style)
    if run["D_dx"] == 4 and not run["shift_x"]:
        for column in 1, 2:
            middle.plot(times, [1e6*r[column] for r in rows],
                        **{**style, "color": "C0" if column == 1 else "C1"},
                        label=("longest, " if column == 1 else "shortest, ")
                        + f"{run['deltaT_s']:.0e} s")
for axes, label in (left, "rotation [1/s]"), (middle, "longest and shortest diameter [um]"):
    axes.set_xlabel("time [ms]")
    axes.set_ylabel(label)
left.set_ylim(85, 113)
middle.set_ylim(7.4, 8.2)
for axes, title in (left, "D/dx, step"), (middle, "D/dx = 4"):
    axes.legend(title=title, title_fontsize=7, fontsize=7, ncol=2, loc="upper right")
for central, style, label in (False, "C0o", "other places"), (True, "C3s",
                                                              "middle of the box, as on the left"):
    some = [r for r in stiff if (r["shift_x"] == r["shift_y"] == 0) == central]
    right.plot([r["D_dx"] for r in some], [-r["rate"] for r in some], style, ms=5, mfc="none",
               label=label)
right.set_xlabel("D/dx")
right.set_ylabel("rotation of a stiff ring [1/s]")
right.legend(fontsize=8)
save(figure, "shearCell.png")
results.write()
