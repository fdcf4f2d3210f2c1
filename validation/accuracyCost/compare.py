"""Error against cost of every numerical choice, scene by scene; the Pareto front, the accuracy
levels and the paper's choice."""

import os

from results import Results, at_one_speed, plt, read, save

unit = {"array": "processor seconds per array", "tether": "processor seconds per simulated second",
        "shear": "processor seconds per simulated second",
        "drift": "processor seconds per simulated second",
        "stretching": "processor seconds per curve"}
title = {"array": "Drag of a cubic array of spheres", "tether": "Drag on the tethered cell",
         "shear": "Rotation of a free cell in shear",
         "drift": "Drift of a free cell across the shear", "stretching": "Stretching curve"}

against = {"array": "Zick and Homsy 1982", "tether": "the finest run", "shear": "the finest run",
           "drift": "the converged run", "stretching": "the measurement"}

# Of an error of one, in the unit of the error
scale = {scene: (100, "%") for scene in title}
scale["drift"] = (1, "um/s")

rows = read("data.csv")
at_one_speed(rows, "cost_s")


def value(scene, knob, setting):
    found = [r["value"] for r in rows if r["scene"] == scene and r["knob"] == knob
             and r["setting"] == setting]
    return found[0] if found else None


def reference(scene):
    """The converged run, or the finest mesh, corrected for its time step where a smaller one was
    run."""
    converged = [r["value"] for r in rows if r["scene"] == scene and r["knob"] == "converged"]
    if converged:
        return converged[0]
    same = [r for r in rows if r["scene"] == scene and r["knob"] == "D/dx"]
    finest = max(same, key=lambda r: r["D_dx"])
    if scene != "tether":
        return finest["value"]
    coarse, small = value("tether", "D/dx", 4), value("tether", "dt", 2.5e-4)
    return finest["value"] + (small - coarse if coarse and small else 0)


points = {scene: [] for scene in title}
for scene in title:
    given = scene in ("array", "stretching")        # the value is the error
    for r in rows:
        if r["scene"] != scene or r["value"] == "lost":
            continue
        error = r["value"] if given else abs(r["value"] - reference(scene))
        if scene in ("tether", "shear"):
            error /= abs(reference(scene))
        setting = r["setting"] if isinstance(r["setting"], str) else f"{r['setting']:g}"
        # What the reference is built from has no error of its own
        if given or error > 1e-6:
            points[scene].append((r["cost_s"], error, r["knob"], setting))


def front(scene):
    best, result = float("inf"), []
    for point in sorted(points[scene]):
        if point[1] < best:
            best = point[1]
            result.append(point)
    return result


for scene in title:
    on_front = front(scene)
    lost = [f"{r['knob']} {r['setting']}" for r in rows if r["scene"] == scene
            and r["value"] == "lost"]
    print(f"\n{title[scene]}\n  {'knob':14s} {'setting':18s} {'error':>8s}  {unit[scene]}")
    factor, of = scale[scene]
    for cost, error, knob, setting in sorted(points[scene], key=lambda p: (p[2], p[0])):
        print(f"  {knob:14s} {setting:18s} {factor*error:7.2f} {of:4s}  {cost:10.3g}"
              f"{'   Pareto' if (cost, error, knob, setting) in on_front else ''}")
    for name in lost:
        print(f"  {name}: lost its stability")


def place(axis, labels):
    """Writes each label beside its point, where it covers neither another label nor a point."""
    renderer = axis.figure.canvas.get_renderer()
    taken = [axis.transData.transform((x, y)) for line in axis.get_lines()
             for x, y in zip(*line.get_data())]
    boxes = []
    for x, y, text, style in labels:
        trials = []
        for right, up in ((1, 1), (1, -1), (-1, 1), (-1, -1), (1, 3), (-1, 3), (1, -3), (-1, -3)):
            trial = axis.annotate(text, (x, y), xytext=(5*right, 5*up), textcoords="offset points",
                                  ha="left" if right > 0 else "right",
                                  va="bottom" if up > 0 else "top", **style)
            box = trial.get_window_extent(renderer)
            covered = sum(box.overlaps(other) for other in boxes) \
                + sum(box.contains(*point) for point in taken) \
                + (box.x0 < axis.bbox.x0) + (box.x1 > axis.bbox.x1)
            trials.append((covered, len(trials), trial, box))
        best = min(trials)
        boxes.append(best[3])
        for trial in trials:
            if trial is not best:
                trial[2].remove()


# Of the knobs with a scale every setting is written beside its point, of the others beside the
# knob's name
scales = ("D/dx", "dt", "N", "refinement")
figure, axes = plt.subplots(3, 2, figsize=(17, 15))
axes[2, 1].axis("off")
for axis, scene in zip(axes.flat, title):
    if not points[scene]:
        axis.axis("off")
        continue
    factor, of = scale[scene]
    labels = []
    knobs = sorted({p[2] for p in points[scene]} - {"level", "paper"})
    for i, knob in enumerate(knobs):
        own = sorted(p for p in points[scene] if p[2] == knob)
        line = "-" if knob in ("D/dx", "dt", "N") else "none"
        name = knob if knob in scales else f"{knob}: {', '.join(p[3] for p in own)}"
        axis.plot([p[0] for p in own], [factor*p[1] for p in own], "os^vD<>phX*"[i % 11], ls=line,
                  lw=0.8, ms=6,
                  color=plt.cm.tab20(i), label=name)
        for cost, error, _, setting in own if knob in scales else ():
            labels.append((cost, factor*error, setting, {"fontsize": 7}))
    best = front(scene)
    axis.plot([p[0] for p in best], [factor*p[1] for p in best], "k--", lw=1, label="Pareto front")
    for cost, error, knob, setting in points[scene]:
        if knob in ("level", "paper"):
            axis.plot(cost, factor*error, "*" if knob == "level" else "X", color="r", ms=13,
                      zorder=5)
            labels.insert(0, (cost, factor*error,
                              "the paper's choice" if knob == "paper" else setting,
                              {"fontsize": 9, "color": "r"}))
    axis.set_xscale("log")
    axis.set_yscale("linear" if scene == "stretching" else "log")
    axis.set_title(title[scene])
    axis.set_xlabel(unit[scene])
    axis.set_ylabel(f"error against {against[scene]} [{of}]")
    place(axis, labels)
    axis.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.01, 1))
save(figure, "accuracyCost.png")

results = Results()
levels = {p[3]: p for p in points["tether"] if p[2] == "level"}
for name, limit in ("draft", 10), ("standard", 4), ("fine", 1.5):
    if name in levels:
        results.add(f"error of level {name}", 100*levels[name][1], "%", 0, limit, "tethered cell")
        cheaper = [p[0] for p in points["tether"] if p[1] <= levels[name][1] and p[2] != "level"]
        if cheaper:
            results.add(f"cost of level {name} over the cheapest of its accuracy",
                        levels[name][0]/min(cheaper), "-",
                        0, 1.1, "Pareto front",
                        known=3.96287 if name == "standard" else None)  # see README.md
if len(levels) == 3:
    # What the levels of etc/accuracy say of themselves, with two digits
    rotation = {p[3]: p for p in points["shear"] if p[2] == "level"}
    name = os.path.join(os.path.dirname(__file__), "../../etc/accuracy/measured")
    with open(name) as file:
        head = file.read().split("\ndraft", 1)[0]
    with open(name, "w") as file:
        file.write(head + "\n")
        for level in "draft", "standard", "fine":
            figures = {"dragError": 100*levels[level][1], "dragCost": levels[level][0],
                       "rotationError": 100*rotation[level][1], "rotationCost": rotation[level][0]}
            text = " ".join(f"{key} {float(f'{value:.2g}'):g};" for key, value in figures.items())
            file.write(f"{level:11s} {{ {text} }}\n")

    results.add("cost of fine over that of draft", levels["fine"][0]/levels["draft"][0], "-", 60,
                40, "20 at least")
for scene in "array", "tether", "shear":
    meshes = sorted((p for p in points[scene] if p[2] == "D/dx"), key=lambda p: float(p[3]))
    if len(meshes) > 1:
        results.add(f"{scene}: error on the finest over that on the coarsest mesh",
                    meshes[-1][1]/meshes[0][1], "-", 0, 1,
                    "converges")
results.write()
