"""Amplitude and phase of an oscillating flow, also with red cells, and the way of a bead that it
carries."""

import cmath
import math

from results import Results, mean, plt, read, save

NU, SPEED, HALF = 1e-6, 1e-3, 1e-3                      # of Allrun
START = {"x": 5.3e-6, "y": 6.4e-6, "z": 9.8e-6}         # of the bead
SOURCE = {"slit": "Stokes 1851", "tube": "Womersley 1955"}


def bessel(n, z):
    """The Bessel function J of the order n, by its power series"""
    term = (z/2)**n/math.factorial(n)
    total, k = term, 0
    while abs(term) > 1e-17*abs(total) or k < 5:
        k += 1
        term *= -(z/2)**2/(k*(k + n))
        total += term
    return total


def exact(section, alpha):
    """Complex amplitudes of the velocity in the middle, over that of the mean velocity, and of the
    gradient over that of the mean velocity"""
    rate = 1j*alpha**2*NU/HALF**2
    if section == "slit":
        k = cmath.sqrt(1j)*alpha
        free = 1 - cmath.tanh(k)/k
        return (1 - 1/cmath.cosh(k))/free, rate/free
    k = cmath.exp(0.75j*math.pi)*alpha
    free = 1 - 2*bessel(1, k)/(k*bessel(0, k))
    return (1 - 1/bessel(0, k))/free, rate/free


def amplitude(rows, column):
    """Of the sine: c of Im(c exp(i w t)), over a period"""
    n = len(rows)
    return 2j/n*sum(row[column]*cmath.exp(-2j*math.pi*(k + 1)/n) for k, row in enumerate(rows))


results = Results()
figure, axes = plt.subplots()
middles = {}
runs = read("data.csv")
for r in runs:
    rows = read(r["file"])
    alpha, steps = r["alpha"], int(r["steps"])
    name = f"{r['section']}, {r['drive']}, {r['scheme']}, alpha {alpha:g}, {steps} steps"
    if r["across_um"] != 80:
        name += f", mesh cells of {r['across_um']:g} um"
    U, G, middle = (amplitude(rows, c) for c in ("U_m_s", "G_m_s2", "middle_m_s"))
    u, g = exact(r["section"], alpha)
    middles.setdefault((r["section"], r["drive"], r["scheme"], alpha, steps), middle/SPEED)
    source = SOURCE[r["section"]]

    second = r["scheme"] == "backward"
    if r["drive"] == "mean":
        ratios = {"middle": middle/(u*SPEED), "gradient": G/(g*SPEED)}
        results.add(f"mean velocity: {name}", abs(U/SPEED - 1), "-", 0, 1e-8, "held")
        results.add(f"flux over a period: {name}", mean([row["U_m_s"] for row in rows])/SPEED,
                    "-", 0, 1e-6, "zero on average")
    else:
        steady = 3*NU*SPEED/HALF**2                     # the gradient that is given
        ratios = {"middle": middle*g/(u*steady), "mean velocity": U*g/steady}
    for what, ratio in ratios.items():
        if second and steps == 100 and (what, r["drive"]) != ("middle", "patches"):
            results.add(f"{what}: {name}", abs(ratio), "-", 1, "1%", source)
            results.add(f"phase of {what}: {name}", cmath.phase(ratio), "rad", 0, 0.01, source)
        else:
            results.report(f"{what}: {name}", abs(ratio), "-", source)
            results.report(f"phase of {what}: {name}", cmath.phase(ratio), "rad", source)
    if r["section"] == "slit" and r["drive"] == "mean" and second and steps == 100:
        t = [(k + 1)/steps for k in range(steps)]
        line, = axes.plot(t, [row["middle_m_s"]/SPEED for row in rows], ".", ms=3,
                          label=f"alpha {alpha:g}")
        axes.plot(t, [(u*cmath.exp(2j*math.pi*x)).imag for x in t], color=line.get_color(), lw=1)

for scheme, order in (("backward", 2), ("Euler", 1)):
    coarse, medium, fine = (middles["slit", "mean", scheme, 3, n] for n in (25, 50, 100))
    results.add(f"order in the step, {scheme}", math.log2(abs(coarse - medium)/abs(medium - fine)),
                "", order, 0.3, "order of the scheme")

# The README explains it
KNOWN = {("y", 50, "auto"): 0.013932}

for r in read("beads.csv"):
    path = read(r["file"])
    name = f"bead, {r['steps']:g} steps, sliding {r['sliding']}"
    for axis, start in START.items():
        back = path[-1][axis + "_m"] - start
        known = KNOWN.get((axis, r["steps"], r["sliding"]))
        results.add(f"back in {axis}: {name}", 1e6*back, "um", 0, 0.01, "Stokes flow reverses",
                    known)
    way = max(row["x_m"] for row in path) - START["x"]
    results.report(f"way: {name}", 1e6*way, "um", "forth")



def equivalent(gradient, alpha):
    """Viscosity over that of the plasma of the liquid in a slit that needs a gradient of this
    size over that of the mean velocity"""
    low, high = 0.1, 10
    for _ in range(60):
        ratio = math.sqrt(low*high)
        low, high = (ratio, high) if abs(ratio*exact("slit", alpha/math.sqrt(ratio))[1]) \
            < gradient else (low, ratio)
    return ratio


for r in read("cells.csv"):
    rows = read(r["file"])
    alpha = r["alpha"]
    name = f"red cells of 20 %, alpha {alpha:g}"
    U, G = (amplitude(rows, c) for c in ("U_m_s", "G_m_s2"))
    results.add(f"mean velocity: {name}", abs(U/SPEED - 1), "-", 0, 1e-8, "held")
    results.add(f"flux over a period: {name}", mean([row["U_m_s"] for row in rows])/SPEED,
                "-", 0, 1e-6, "zero on average")
    # exact() is in the units of a slit of 2 mm; G h^2/nu is the same in all of them
    scaled = G/U*(10e-6)**2/1.171e-6*NU/HALF**2
    ratio = equivalent(abs(scaled), alpha)
    phase = cmath.phase(ratio*exact("slit", alpha/math.sqrt(ratio))[1])
    results.report(f"gradient: {name}", abs(scaled/exact("slit", alpha)[1]), "-", "plasma alone")
    results.report(f"viscosity of the liquid with this gradient: {name}", ratio, "-", "plasma")
    results.add(f"phase of gradient: {name}", cmath.phase(scaled) - phase, "rad", 0, 0.03,
                "liquid of the viscosity that fits the amplitude")
    places = {}
    for row in read(r["places"]):
        places.setdefault(row["clump"], []).append([row[c] for c in ("x_m", "y_m", "z_m")])
    apart = [1e6*math.dist(path[-1], path[-2]) for path in places.values()]
    results.report(f"cells in the last period come back to within: {name}", max(apart), "um",
                   "Stokes flow reverses")

axes.set_xlabel("time in periods")
axes.set_ylabel("velocity in the middle over the mean one")
axes.legend()
save(figure, "womersley.png")
results.write()
