"""Restitution of a sphere in a liquid over that of dry bodies: exp(-35/St), a fit to measurements.

The velocity before is that of the fall; the one after is taken an eighth of a diameter above the
wall. St = rho_p D u/(9 mu) with the velocity of the fall."""

import math

import numpy as np
from results import Results, plt, read, save

D, RATIO, DRY, ABOVE = 2e-3, 8, 0.97, 1/8
SOURCE = "Gondret et al. 2002, Joseph et al. 2001; fit of Legendre et al. 2005"
# Measurements at the same Stokes number differ by about so much
SCATTER = 0.1

results = Results()
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
steps = {}
for r in read("data.csv"):
    t, y, u = np.loadtxt(r["history"], delimiter=",", skiprows=1, unpack=True)
    gap = y/D - 0.5
    fall = -u[0]
    St = RATIO*D*fall/(9*r["nu_m2_s"])
    after = np.nonzero((gap >= ABOVE) & (np.arange(len(u)) > u.argmin()) & (u > 0))[0]
    wet = u[after[0]]/fall if len(after) else 0
    largest = max(u.max(), 0)/fall
    name = "St %g, step %g contact times" % (r["Stokes_number"], r["step_over_contact"])
    name += ", place 0" if r["place"] == 0 else ""
    name += "" if r["film"] == "film" else ", without film"
    if St < 10:
        results.add(name + ": largest rebound", largest/DRY, "-", 0, 0.02, "no bounce below St 10")
    elif r["film"] == "film":
        results.add(name, wet/DRY, "-", math.exp(-35/St), SCATTER, SOURCE)
        results.report(name + ", at once", largest/DRY, "-", "largest velocity after the contact")
    else:
        results.report(name, wet/DRY, "-", "what the mesh resolves")
    if r["Stokes_number"] == 85 and r["film"] == "film" and r["place"] != 0:
        steps[r["step_over_contact"]] = wet/DRY
    left.plot(gap, u/fall, label=name)
    right.plot(St, wet/DRY, "o" if r["film"] == "film" else "x", color="C0")
results.add("St 85: both steps, difference", steps[0.08] - steps[0.02], "-", 0, 0.03,
            "no dependence on the step")

St = np.geomspace(5, 1000, 200)
right.semilogx(St, np.exp(-35/St), "k-", label="exp(-35/St)")
right.fill_between(St, np.exp(-35/St) - SCATTER, np.exp(-35/St) + SCATTER, color="0.9")
left.set_xlabel("gap / D")
left.set_ylabel("velocity / velocity of the fall")
left.legend(fontsize=6)
right.set_xlabel("St")
right.set_ylabel("restitution / dry restitution")
right.set_ylim(0, 1)
right.legend()
save(figure, "bounceInOil.png")
results.write()
