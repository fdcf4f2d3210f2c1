"""Place and angle of red cells at the end, over the time step: errors against the smallest step,
orders from three steps that are halved."""

import math

from results import QUICK, Results, plt, read, save

PERIOD = {"shear": 45e-6, "tumbling": 45e-6, "bifurcation": None}   # of x [m]
LIMIT = {"shear": 0.5, "tumbling": 0.5, "bifurcation": 1}   # at 1e-3 s [% of way and of angle]
# Explained in the README
KNOWN = {
    "place, of the way: shear, converged, 0.001 s": 0.559742,
    "place, of the way: shear, standard, 0.001 s": 0.525708,
    "place, of the way: tumbling, converged, 0.001 s": 0.583135,
    "place, of the way: tumbling, standard, 0.001 s": 1.04465,
    "angle: bifurcation, converged, 0.001 s": 3.5321,
    "angle: bifurcation, standard, 0.001 s": 5.03719,
    "angle: bifurcation, standard, 0.0005 s": 1.68537,
}
rows = read("data.csv")
results = Results()
figure, axes = plt.subplots(1, 2, figsize=(9, 4))


def state(row):
    """Way [m], place [m] and angle [rad] at the end."""
    table = read(row["file"])
    period = PERIOD[row["scene"]]
    place = [0, 0, 0]
    way = angle = 0
    for before, after in zip(table, table[1:]):
        step = [after[k] - before[k] for k in ("x_m", "y_m", "z_m")]
        if period:
            step[0] -= period*round(step[0]/period)
        place = [a + b for a, b in zip(place, step)]
        way += math.hypot(*step)
        if row["scene"] == "tumbling":
            # The rate is the rotation of the step over its time
            angle += after["rate"]*(after["t_s"] - before["t_s"])
        else:
            turn = after["phase"] - before["phase"]
            angle += math.remainder(turn, 2*math.pi)
    # The first row is one step after the start
    first = table[0]
    start = first["rate"]*first["t_s"] if row["scene"] == "tumbling" else first["phase"]
    return way, [first[k] + p for k, p in zip(("x_m", "y_m", "z_m"), place)], angle + start


states = {(r["scene"], r["settings"], r["deltaT_s"]): state(r) for r in rows}
for scene in dict.fromkeys(r["scene"] for r in rows):
    best = min((r for r in rows if r["scene"] == scene),
               key=lambda r: (r["settings"] != "converged", r["deltaT_s"]))
    way, place, angle = states[scene, best["settings"], best["deltaT_s"]]
    print(f"{scene}: way {1e6*way:.2f} um, angle {angle:.3f} rad")
    for settings in "converged", "standard":
        steps = sorted((r["deltaT_s"] for r in rows
                        if r["scene"] == scene and r["settings"] == settings), reverse=True)
        found = [states[scene, settings, step] for step in steps]
        off = [(100*math.dist(s[1], place)/way, 100*abs(s[2] - angle)/abs(angle)) for s in found]
        for i, (step, errors) in enumerate(zip(steps, off)):
            text = f"{scene}, {settings}, {step:g} s"
            orders = ""
            if i >= 2:
                a, b, c = found[i - 2:i + 1]
                for what, d in (("place", (math.dist(a[1], b[1]), math.dist(b[1], c[1]))),
                                ("angle", (abs(a[2] - b[2]), abs(b[2] - c[2])))):
                    order = math.log2(d[0]/d[1])
                    orders += f", order of the {what} {order:.1f}"
                    if settings == "converged":
                        results.report(f"order of the {what}: {text}", order, "-", "")
            print(f"    {text}: place {errors[0]:.3f} % of the way, angle {errors[1]:.3f} %"
                  f"{orders}")
            if (settings, step) == (best["settings"], best["deltaT_s"]):
                continue
            for what, error in zip(("place, of the way", "angle"), errors):
                if step <= 1e-3:
                    name = f"{what}: {text}"
                    results.add(name, error, "%", 0, str(LIMIT[scene]), "the smallest step",
                                None if QUICK else KNOWN.get(name))
                else:
                    results.report(f"{what}: {text}", error, "%", "the smallest step")
        for axis, i in zip(axes, (0, 1)):
            line = [(s, e[i]) for s, e in zip(steps, off) if e[i] > 0]
            axis.loglog(*zip(*line), "o-" if settings == "converged" else "s--",
                        label=f"{scene}, {settings}")
for axis, what in zip(axes, ("place, error [% of the way]", "angle, error [%]")):
    axis.set_xticks([2.5e-4, 5e-4, 1e-3, 2e-3], ["2.5e-4", "5e-4", "1e-3", "2e-3"])
    axis.minorticks_off()
    axis.set_xlabel("time step [s]")
    axis.set_ylabel(what)
axes[0].legend(fontsize=7, loc="lower right")
figure.tight_layout()
save(figure, "motionOrder.png")
results.write()
