"""Velocity of a settling capsule over that of the bead on the same mesh, and of one that starts to
settle over that of a rigid sphere."""

import numpy as np
from results import Results, plt, read, save

RADIUS, NU, WEIGHT = 3e-4, 1.2e-6, -5.5e-3      # of begin in Allrun; force per displaced mass

# Misses that the README explains: of the ratio 20, by the part of the time
KNOWN = {0.25: 1.19949, 0.5: 1.1157, 1: 1.05647}


def rigid_sphere(ratio, times, parts=2000):
    """Velocity [m/s] of a rigid sphere that starts in creeping flow without walls (Basset 1888):

    (ratio + 1/2) U' = WEIGHT - 9 nu/(2 R^2) U - 9/(2 R) sqrt(nu/pi) int_0^t U'(s)/sqrt(t - s) ds

    with U linear in each of equal parts of the time
    """
    t = np.linspace(0, max(times), parts + 1)
    h = t[1]
    inertia, drag = (ratio + 0.5)/h, 4.5*NU/RADIUS**2
    history = 4.5*np.sqrt(NU/np.pi)/RADIUS*2*(np.sqrt(t[1:]) - np.sqrt(t[:-1]))/h
    U, change = np.zeros(parts + 1), np.zeros(parts)
    for n in range(parts):
        past = np.dot(history[n:0:-1], change[:n])
        change[n] = (WEIGHT - drag*U[n] - past)/(inertia + drag + history[0])
        U[n + 1] = U[n] + change[n]
    return np.interp(times, t, U)


results = Results()
runs = read("data.csv")

for run in runs:
    bead = next(r for r in runs if r["kind"] == "bead"
                and (r["mesh"], r["D_dx"]) == (run["mesh"], run["D_dx"]))
    name = f"{run['kind']}, viscosity ratio {run['ratio']:g}, D/dx {run['D_dx']:g}"
    if run["mesh"] != "uniform":
        name += f", {run['mesh']}"
    if run["kind"] == "capsule":
        results.add(f"{name}: velocity over that of a bead",
                    run["velocity_m_s"]/bead["velocity_m_s"], "-", 1, 0.02,
                    "a rigid sphere of the same volume and weight")
    else:
        results.report(f"{name}: velocity", 1e3*run["velocity_m_s"], "mm/s", "the bead")

figure, axes = plt.subplots(figsize=(8, 4))
starts = read("starts.csv")
for run in starts:
    ratio, capsule = run["density_ratio"], run["kind"] == "capsule"
    rows = read(f"history-{run['kind']}-{ratio:g}.csv")
    t, U = (np.array([r[name] for r in rows]) for name in ("t_s", "velocity_m_s"))
    exact = rigid_sphere(ratio, t)
    for part in (0.25, 0.5, 1):
        k = np.argmin(abs(t - part*t[-1]))
        results.add(f"{run['kind']}, density ratio {ratio:g}, D/dx {run['D_dx']:g}: velocity after "
                    f"{part*t[-1]*NU/RADIUS**2:.2g} R2/nu over the exact one", U[k]/exact[k], "-",
                    1, 0.05, "Basset 1888", KNOWN[part] if capsule and ratio == 20 else None)
    colour = f"C{sorted({r['density_ratio'] for r in starts}).index(ratio)}"
    axes.plot(t*NU/RADIUS**2, -1e6*U, "o" if capsule else "x", ms=3, color=colour, mfc="none",
              label=f"{run['kind']}, density ratio {ratio:g}")
    if capsule:
        axes.plot(t*NU/RADIUS**2, -1e6*exact, color=colour, lw=1)
axes.set_xlabel("time nu/R$^2$")
axes.set_ylabel("velocity [um/s]")
axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
save(figure, "starts.png")
results.write()
