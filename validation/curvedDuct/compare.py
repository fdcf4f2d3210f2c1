"""Where a sphere stays in the cross-section of a bend: the zero of its drift."""

import numpy as np
from results import Results, plt, read, save

H = 50e-6               # of Allrun [m]
SETTLED = 0.8           # time after which the drift is measured [H/U]
rows = read("data.csv")
reference = [r for r in read("reference.csv") if r["type"].startswith("stable")]
results = Results()


def path(r):
    """Time [H/U] and place in the cross-section [H/2]"""
    history = read(r["file"])
    t, x, y, z = (np.array([p[k] for p in history]) for k in ("t_s", "x_m", "y_m", "z_m"))
    return t*r["U_m_s"]/H, (np.hypot(x, y) - r["R_m"])/(H/2), z/(H/2)


def drift(r):
    """Mean place, and the velocity there [U/2]"""
    t, across, z = path(r)
    late = t > SETTLED
    return [np.mean(across[late]), np.mean(z[late])], \
        [np.polyfit(t[late], q[late], 1)[0] for q in (across, z)]


def zero(three):
    """Of the drift as a linear function of the place, and its Jacobian"""
    places, drifts = (np.array(q) for q in zip(*map(drift, three)))
    jacobian = np.linalg.solve(places[1:] - places[0], drifts[1:] - drifts[0]).T
    return places[0] - np.linalg.solve(jacobian, drifts[0]), jacobian


def scenes():
    """The runs of each scene together"""
    keys = "size", "bend", "Re", "across", "Courant", "tolerance", "convection"
    found = {}
    for r in rows:
        found.setdefault(tuple(r[k] for k in keys), []).append(r)
    return found


def name(r):
    return (f"{r['size']:g} H, bend {r['bend']:g} H/2, Re {r['Re']:g}, "
            f"{r['size']*r['across']:g} mesh cells, Courant {r['Courant']:g}"
            + (f", couplingTolerance {r['tolerance']:g}" if r["tolerance"] != 0.01 else ""))


figure, axes = plt.subplots()
usual = next(iter(scenes()))
for key, three in scenes().items():
    r = three[0]
    if len(three) == 1:
        place, v = drift(r)
        results.add(f"drift without inertia, bend {r['bend']:g} H/2", v[0]/2, "U", 0, "1e-4",
                    "creeping flow is reversible")
        continue
    place, jacobian = zero(three)
    expected = next(e for e in reference if (e["a_2a_over_H"], e["R_2R_over_H"]) == key[:2]
                    and e["z_over_halfH"] > -0.01)
    source = "Harding, Stokes and Bertozzi 2019"
    results.add(f"place away from the centre of curvature, {name(r)}", place[0], "H/2",
                expected["r_over_halfH"], "0.02", source)
    results.add(f"place across, {name(r)}", abs(place[1]), "H/2",
                abs(expected["z_over_halfH"]), "0.02", source)
    # In the unit of the reference, rho U^2 a^2/(mu H^2)
    rates = np.linalg.eigvals(jacobian)/(r["Re"]*(r["size"]/2)**2)
    results.report(f"fast rate, {name(r)}", min(rates.real), "rho U^2 a^2/(mu H^2)",
                   f"{source}: {expected['rate_fast']:g}")
    results.report(f"swirl, {name(r)}", max(abs(rates.imag)), "rho U^2 a^2/(mu H^2)",
                   f"{source}: {expected['swirl']:g}")
    if key[2:] == usual[2:] or key[0] != usual[0]:
        line, = axes.plot(*place, "o", label=f"{r['size']:g} H, bend {r['bend']:g} H/2")
        axes.plot(expected["r_over_halfH"], expected["z_over_halfH"], "x", color=line.get_color(),
                  markersize=10)
results.report("seconds of one core for a place, the first bend",
               sum(r["seconds"] for r in rows[:3]), "s", "this machine")
axes.plot([], [], "kx", label="Harding et al.")
axes.set(xlim=(-1, 1), ylim=(-1, 1), aspect="equal",
         xlabel="away from the centre of curvature [H/2]", ylabel="across [H/2]")
axes.legend()
save(figure, "curvedDuct.png")
results.write()
