"""Compares a sphere that starts from rest with the equation of Basset, Boussinesq and Oseen.

    (m + rho V/2) du/dt + 6 pi mu R u + 6 R^2 (pi mu rho)^(1/2) int du/ds (t - s)^(-1/2) ds = W

The Laplace transform of u is W/(s Z(s)) with Z = (m + rho V/2) s + 6 pi mu R (1 + R (s/nu)^(1/2)).
Implicit Euler replaces s by (1 - z)/dt; u of step n is the coefficient of z^n, by Cauchy's
integral. The exact velocity is the limit of small steps, by Talbot's contour."""

import cmath
import math

import numpy as np
from results import Results, plt, read, save

R, RHO = 1e-3, 1000.
V = 4/3*math.pi*R**3


def Z(s, ratio, nu):
    """Force over velocity and density of the fluid [m3/s]."""
    return (ratio + 0.5)*V*s + 6*math.pi*nu*R*(1 + R*(s/nu)**0.5)


def implicit(n, ratio, nu, dt):
    """Velocities after the first n implicit steps for a unit force over the density."""
    points, radius = 1024, 1e-8**(1/1024)
    z = radius*np.exp(2j*np.pi*np.arange(points)/points)
    f = z/(1 - z)/Z((1 - z)/dt, ratio, nu)
    return (np.fft.fft(f).real/points*radius**-np.arange(points))[1:n + 1]


def exact(t, ratio, nu, points=32):
    """Velocity at the time t."""
    total = 0
    for k in range(points):
        a = -math.pi + (k + 0.5)*2*math.pi/points
        cot = 1/math.tan(0.6407*a)
        s = points/t*(0.5017*a*cot - 0.6122 + 0.2645j*a)
        ds = points/t*(0.5017*cot - 0.5017*0.6407*a*(1 + cot**2) + 0.2645j)
        total += cmath.exp(s*t)/(s*Z(s, ratio, nu))*ds
    return (total/(1j*points)).real


# Of the first step and of later ones, and for a mesh in which the sphere lies symmetrically
LIMITS = 0.05, 0.03
ELSEWHERE = {4: 0.25, 8: 0.1, 16: 0.05}

# Mesh cells that become solid bring fluid at rest with them
KNOWN = {(0, 1e-4): 0.946767, (0.01, 1e-4): 0.947599}
# Ended one outer corrector too early
KNOWN_FIRST = {(0.9, 100): 1.23703}

source = "Basset-Boussinesq-Oseen, in implicit steps"
results = Results()
rows = read("data.csv")
print("velocity over that of the equation in implicit steps (in brackets: over the exact one)")
figure, axes = plt.subplots(1, 4, figsize=(13, 3.6), sharey=True)
numbers = sorted({r["viscous_number"] for r in rows})
for r in rows:
    ratio, number, across = r["density_ratio"], r["viscous_number"], r["D_dx"]
    usual = r["place"] == "0.2 0.1 -0.3"
    u = [h["velocity_m_s"] for h in read(r["history"])]
    scale = (1 - ratio)*V*r["g_m_s2"]
    stepped = scale*implicit(len(u), ratio, r["nu_m2_s"], r["deltaT_s"])
    true = [scale*exact((k + 1)*r["deltaT_s"], ratio, r["nu_m2_s"]) for k in range(len(u))]
    over = np.array(u)/stepped
    print(f"ratio {ratio:<6g} nu dt/dx2 {number:<6g} D/dx {across:<3g} at {r['place']:13s}"
          + "".join(f"  {k}: {over[k - 1]:.3f} ({u[k - 1]/true[k - 1]:.3f})"
                    for k in (1, 2, 5, 10, 20) if k <= len(u)))
    first, later = LIMITS if usual else 2*[ELSEWHERE[across]]
    name = f"ratio {ratio:g}, viscous number {number:g}, D/dx {across:g} at {r['place']}"
    results.add(f"first step, {name}", over[0], "-", 1, first, source,
                KNOWN_FIRST.get((ratio, number)) if usual else None)
    results.add(f"largest deviation later, {name}",
                max(over[1:], key=lambda x: abs(x - 1)), "-", 1, later, source,
                KNOWN.get((ratio, number)) if usual and len(u) == 20 else None)
    if usual:
        at = axes[numbers.index(number)]
        at.plot(range(1, len(u) + 1), over, marker=".", label=f"{ratio:g}")
        at.set_title(f"viscous number {number:g}", fontsize=10)
        at.set_xlabel("step")
axes[0].set_ylabel("velocity / that of the equation")
axes[0].legend(title="density ratio", fontsize=7, title_fontsize=7)
save(figure, "startOfMotion.png")
results.write()
