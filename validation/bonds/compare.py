"""Statics, frequencies and motion of bonded spheres against their references; orders of
convergence; figure."""
import math

from clumps import table
from results import Results, plt, read, save

REFERENCE = "reference/beam_ring_references.csv"
cases = {}
for row in read("data.csv"):
    cases[row["case"], float(row["parameter"]), int(row["n"])] = float(row["value"])
reference = read(REFERENCE)
elastica = {float(p["p"]): float(p["v1"]) for p in reference if p["type"] == "elastica"}
rings = {p["p"]: p for p in reference if p["type"] == "ring"}
out = Results()


def series(name, parameter):
    return {n: v for (c, p, n), v in sorted(cases.items()) if c == name and p == parameter}


def order(values):
    """Order from the differences between the three finest numbers of bonds, each twice the one
    before."""
    a, b, c = [v for n, v in sorted(values.items()) if n in (16, 32, 64)]
    return math.log2(abs((a - b)/(b - c)))


errors = {}
curves = {}
for law in ("elastic", "timoshenko"):
    for load, exact in elastica.items():
        values = series(f"elastica {law}", load)
        if values:
            name = f"elastica, {law}, PL2/EI = {load:g}"
            curves[name] = values
            errors[name] = {n: v/exact - 1 for n, v in values.items()}
            out.add(f"cantilever PL2/EI = {load:g}, 32 bonds, {law}", values[32], "L", exact,
                    "0.1%",
                    "elastica by shooting, Bisshopp & Drucker 1945")

for name, column in (("ring loaded", "v1"), ("ring other", "v2")):
    values = series(name, 1e-3)
    worst = max(abs(v/float(rings[n][column]) - 1) for n, v in values.items())
    out.add(f"{name} diameter, N = 8 to 64, against the polygon", 100*worst, "%", 0, 0.05,
            "Euler-Bernoulli polygon, computed exactly")
    exact = float(rings[math.inf][column])
    out.add(f"{name} diameter, N = 32, against the circle", values[32], "PR3/EI", exact, "1%",
            "Timoshenko")
    curves[name] = values
    errors[name] = {n: v/exact - 1 for n, v in values.items()}

out.add("twist under end torques, 32 bonds", cases["torsion", 0.25, 32], "rad", 0.5, "0.0001%",
        "TL/GJ")
for n in (1, 4, 32):
    out.add(f"beam under a tip load with shear, {n} bonds", cases["timoshenko beam", 1e-4, n], "-",
            1/3 + 1/20, "0.001%",
            "PL3/3EI + PL/GA")

RATIO = 1/0.7
exact = {("ring in plane", 2): math.sqrt(7.2), ("ring in plane", 3): math.sqrt(9*64/10),
         ("ring out of plane", 2): math.sqrt(36/(4 + RATIO)), ("free beam bending", 1): 4.730041**2}
for (name, mode), omega in exact.items():
    values = series(name, mode)
    curves[f"frequency, {name}, mode {mode}"] = values
    errors[f"frequency, {name}, mode {mode}"] = {n: v/omega - 1 for n, v in values.items()}
    out.add(f"frequency, {name}, mode {mode}, 32 spheres", values[32], "rad/s", omega, "1%",
            "continuous beam or ring")

for name, values in curves.items():
    out.add(f"order in the number of bonds: {name}", order(values), "-", 2, 0.05
            if name.startswith("elastica") else 0.25,
            "second order expected")

steps = max(n for c, n, _ in cases if c == "energy drift")
out.add(f"energy drift over {steps:.0f} explicit steps", cases["energy drift", steps, 10], "-", 0,
        1e-4, "conserved")
out.add(f"momentum drift over {steps:.0f} explicit steps", cases["momentum drift", steps, 10], "-",
        0, 1e-13, "conserved")
out.add(f"angular momentum drift over {steps:.0f} explicit steps",
        cases["angular momentum drift", steps, 10], "-", 0,
        1e-13, "conserved")
for name, allowed in (("implicit energy rise", 1e-15), ("implicit angular momentum drift", 1e-15),
                      ("implicit equilibrium", 1e-7)):
    values = {p: v for (c, p, n), v in cases.items() if c == name}
    worst = max(values.values(), key=abs)
    out.add(f"{name}, steps {min(values):g} to {max(values):g} s", worst, "-", 0, allowed,
            "dissipative, one equilibrium")


def collision():
    """Velocities along x of both rods: [(time, u0, u1)]."""
    rows = {}
    for row in table("collision", "clumpForce"):
        rows.setdefault(row["time"], {})[int(row["clump"])] = row["Ux"]
    return [(t, u[0], u[1]) for t, u in sorted(rows.items())]


path = collision()
speed = 1e-3
out.add("head-on collision: momentum over that of one rod",
        max(abs(u0 + u1) for _, u0, u1 in path)/speed, "-", 0, 1e-12,
        "conserved")
out.add("head-on collision: restitution of equal elastic rods",
        (path[-1][2] - path[-1][1])/(2*speed), "-", 1, 0.05,
        "de Saint-Venant: equal rods exchange velocities")

fig, axes = plt.subplots(1, 2, figsize=(12, 4), squeeze=False)
for k, (name, values) in enumerate(curves.items()):
    # Towards the limit that the two finest give at second order
    limit = values[64] + (values[64] - values[32])/3
    axes[0][0].loglog(list(values), [100*abs(v/limit - 1) for v in values.values()],
                      "o-s-^-v-d-"[2*(k//3):2*(k//3) + 2],
                      ms=3, lw=1, color=plt.cm.tab20(k), label=name)
axes[0][0].loglog([8, 64], [6, 6/64], "k--", lw=0.8, label="second order")
axes[0][0].set_xticks([4, 8, 16, 32, 64], ["4", "8", "16", "32", "64"])
axes[0][0].minorticks_off()
axes[0][0].set(xlabel="number of bonds", ylabel="deviation from infinitely many bonds [%]",
               xlim=(3.5, 70))
axes[0][0].legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
for q in (1, 2):
    axes[0][1].plot([1e6*p[0] for p in path], [1e3*p[q] for p in path], label=f"rod {q}")
axes[0][1].set(xlabel="time [us]", ylabel="velocity [mm/s]",
               title="head-on collision of two elastic rods")
axes[0][1].legend()
save(fig, "bonds.png")
out.write()
