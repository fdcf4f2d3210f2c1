"""Released dumbbell, stretched chain, tumbling and buckling of a fibre against their references."""

import math
import os
import sys

import numpy as np
from results import Results, half_turn, plt, read, save

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../resistance"))
import slender                                          # noqa: E402
from spheres import resistance, straining, stretch      # noqa: E402

a, mu = 1e-6, 1e-3
drag = 6*math.pi*mu*a

# Growth rates are a - b/m with a = 1.6 and b = 310 (reference/bending.csv). The drag is right to
# 4 % of b/m, and the box raises the rate of strain by the fibre's part in the stress, 8 % of a
LIMIT = {m: round(0.04*310/m + 0.08*1.6, 2) for m in (75, 110, 160, 240, 380)}

# See the README
KNOWN = {75: -2.86526, 380: 0.994027, "local": 186.92}
runs = read("data.csv")
results = Results()
figure, axes = plt.subplots(2, 2, figsize=(9, 7))


def cases(name):
    return [(r, {k: np.array([row[k] for row in read(r["file"])])
                 for k in ("t_s", "length_m", "width_m", "axis_x", "axis_y")})
            for r in runs if r["case"] == name]


def at(m, values):
    """Growth rates at m from the reference's; they are linear in 1/m."""
    return np.interp(-1/m, -1/np.array(stiffness), values)


# Two spheres, tension K e = R/2 de/dt on either: e falls as exp(-2 K t/R)
K, pair = 5.77e-12/(3*a), [0, 3]
tau = stretch(resistance(pair), pair)*drag/(2*K)
panel = axes[0, 0]
source = "Gluckman, Pfeffer & Weinbaum 1971, unbounded"
for run, h in cases("dumbbell"):
    name = f"D/dx {run['D_dx']:g}"
    t, e = h["t_s"] - 0.004, h["length_m"] - 5*a
    free = t > 1.5*run["deltaT_s"]
    ratios = e[free][:-1]/e[free][1:]
    results.add(f"dumbbell, {name}: steps in which it grows or oversteps its rest",
                np.sum(ratios <= 1) + np.sum(e[free] <= 0), "-", 0, "0", "creeping flow")

    # Implicit Euler steps divide e by 1 + dt/tau
    steps = len(ratios)
    mean = (e[free][0]/e[free][-1])**(1/steps)
    results.add(f"dumbbell, {name}: relaxation time", 1e3*run["deltaT_s"]/(mean - 1), "ms",
                1e3*tau, "4%", source)
    panel.semilogy(1e3*t, 1e6*e, "o", ms=2, label=name)
    if run["D_dx"] == 4:
        panel.semilogy(1e3*t[free], 1e6*e[free][0]*np.exp(-(t[free] - t[free][0])/tau), "k",
                       lw=1, label="theory")
panel.set(xlabel="time since the release [ms]", ylabel="extension [um]", title="dumbbell")
panel.legend()

# Bonds carry the sum of the forces on the spheres beyond them
K, shear, row = 2e-10/(2.5*a), 20, [2.5*(k - 3.5) for k in range(8)]
forces = drag*a*shear/2*straining(row)
tension = np.cumsum(forces[::-1])[::-1][1:]
exact = 1e6*tension.sum()/K
dipole = a*np.dot(row, forces)
found = {}
panel = axes[0, 1]
for run, h in cases("stretched"):
    side = run["height_r"]
    extension = 1e6*(h["length_m"] - 19.5*a)
    found[side] = extension.max()
    share = dipole/(mu*shear*(side*a)**3)
    results.add(f"eight spheres in shear, box of {side:g} radii: greatest extension", found[side],
                "um", exact, f"{4 + 100*share:.1f}%", f"{source}; the box changes it by some "
                f"{100*share:.1f} % (its part of the stress)")
    panel.plot(1e3*h["t_s"], extension, label=f"box of {side:g} radii")
if len(found) == 2:
    near, far = sorted(found)
    results.add("eight spheres in shear, no box: greatest extension", found[far]
                - (found[near] - found[far])/((far/near)**3 - 1), "um", exact, "4%", source)
panel.axhline(exact, color="k", lw=1, label="theory at 45 degrees, no box")
panel.set(xlabel="time [ms]", ylabel="extension [um]", title="eight separate spheres in shear")
panel.legend()

panel = axes[1, 0]
ratio = read("reference/aspectRatio.csv")[0]["aspect_ratio"]
shear, cylinder = 100, 8
cox = 1.24*cylinder/math.sqrt(math.log(cylinder))
for run, h in cases("tumbling"):
    angles = -np.unwrap(2*np.arctan2(h["axis_y"], h["axis_x"]))/2
    angles -= angles[0] + h["t_s"][0]*-shear
    period = 2*half_turn(list(h["t_s"]), list(angles))*shear
    results.add("fibre, period x shear rate", period, "-", 2*math.pi*(ratio + 1/ratio), "5%",
                "Jeffery 1922, reference/aspectRatio.csv")
    results.add("fibre, period x shear rate, as of a blunt cylinder", period, "-",
                2*math.pi*(cox + 1/cox), "10%", "Cox 1971")
    panel.plot(shear*h["t_s"], np.degrees(angles), label="D/dx 4")
    p = np.linspace(0, 1.5*math.pi, 300)
    panel.plot((ratio + 1/ratio)*p,
               np.degrees(np.unwrap(np.arctan2(ratio*np.sin(p), np.cos(p)))), "k", lw=1,
               label=f"Jeffery, aspect ratio {ratio:.2f}")
panel.set(xlabel="shear rate x time", ylabel="angle turned [degrees]", title="stiff fibre")
if panel.lines:
    panel.legend()

# Growth of the bend while the fibre passes the axis of compression
panel = axes[1, 1]
theory = read("reference/bending.csv")
stiffness, rates, whole = ([r[k] for r in theory]
                           for k in ("stiffness", "growth", "growth_whole_clump"))
panel.plot(stiffness, rates, "k", lw=1, label="without a mesh, this chain")
panel.plot(stiffness, whole, "k:", lw=1, label="the same, spheres turn with the whole")
panel.plot(stiffness, [slender.growth(m) for m in stiffness], "k--", lw=1,
           label="local slender-body theory")
points = []
for run, h in cases("buckling"):
    m = run["stiffness"]
    angle = np.degrees(np.arctan2(-h["axis_y"], h["axis_x"]))
    near = abs(angle - 45) < 6
    slope = np.polyfit(shear*h["t_s"][near], np.log(h["width_m"][near] - 2*a), 1)[0]
    points.append((m, slope))
    name = f"growth of a bend over the shear rate at {m:g}"
    results.add(name, slope, "-", at(m, rates), LIMIT[m], "reference/bending.csv",
                KNOWN.get(m))
    results.add(f"{name}, spheres turn with the whole", slope, "-", at(m, whole), LIMIT[m],
                "reference/bending.csv")
if points:
    m, slopes = (np.array(values) for values in zip(*points))
    threshold = -1/np.interp(0, slopes, -1/m)
    results.add("the bend grows above", threshold, "-",
                -1/np.interp(0, rates, -1/np.array(stiffness)), "10%", "reference/bending.csv")
    results.add("the bend grows above, local slender-body theory", threshold, "-",
                slender.threshold(), "25%", "slender.py; Liu et al. 2018", KNOWN.get("local"))
    panel.plot(*zip(*points), "o", label="D/dx 4")
panel.set(xlabel=r"$8\pi\mu\dot\gamma L^4/(cB)$", ylabel="growth rate / shear rate",
          title="bend of a fibre under compression", ylim=(-5, 2))
panel.legend()
save(figure, "fibre.png")
results.write()
