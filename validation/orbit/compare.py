"""Radius and angle of a sphere that goes around with a rotating fluid, over the time step."""

import cmath
import math

from results import Results, plt, read, save

RATE, MIDDLE, RADIUS, TIME = 200, 15e-6, 5e-6, 0.1      # of Allrun
a, nu = 2e-6, 1e-6                                      # sphere and fluid

# Without the pressure of the rotating fluid a sphere as heavy as the fluid is thrown outwards:
# m omega^2 r over 6 pi mu a
OUTWARDS = math.exp(2*a**2/(9*nu)*RATE**2*TIME)
SOURCE = "it goes around with the fluid"

rows = read("data.csv")
results = Results()
figure, axes = plt.subplots()

errors = {}
for r in rows:
    path = [complex(p["x_m"] - MIDDLE, p["y_m"] - MIDDLE) for p in read(r["file"])]
    turned = sum(cmath.phase(after/before) for before, after in zip([RADIUS + 0j] + path, path))
    exact = OUTWARDS if r["fluid"] == "frozen" else 1
    radius = abs(path[-1])/RADIUS
    angle = turned - RATE*TIME
    per_step = RATE*r["deltaT_s"]
    print(f"{r['fluid']}, {per_step:g} rad per step: radius {radius:.4f}, without inertia "
          f"{radius/exact:.4f}, angle {angle:+.4f} rad of {RATE*TIME:g}")
    errors.setdefault(r["fluid"], []).append((per_step, radius/exact - 1, angle/(RATE*TIME)))
    flow = {"frozen": "frozen flow", "resolved": "resolved flow",
            "standard": "resolved flow, level standard",
            "two": "resolved flow, two correctors"}[r["fluid"]]
    name = f"after 20 rad, {flow}, {per_step:g} rad per step"
    if per_step <= 0.1 and r["fluid"] != "two":
        results.add(f"radius {name}", radius/exact, "", 1, "1%", SOURCE)
        results.add(f"angle {name}", turned, "rad", RATE*TIME, "1%", SOURCE)
    else:
        results.report(f"radius {name}", radius/exact, "", SOURCE)
        results.report(f"angle {name}", turned, "rad", SOURCE)

for fluid, points in errors.items():
    points.sort()
    axes.loglog([p[0] for p in points], [abs(p[2]) for p in points], "o-", label=f"angle, {fluid}")
    axes.loglog([p[0] for p in points], [abs(p[1]) for p in points], "s--",
                label=f"radius, {fluid}")
    if fluid == "frozen":
        (h0, _, e0), (h1, _, e1) = points[-3], points[-1]
        results.add("order of the angle, frozen flow", math.log(abs(e1/e0))/math.log(h1/h0), "", 2,
                    "0.3", "midpoint rule")
axes.set_xlabel("angle per step [rad]")
axes.set_ylabel("relative error after 20 rad")
axes.legend()
save(figure, "orbit.png")
results.write()
