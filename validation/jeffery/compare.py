"""Rotation of a prolate spheroid in shear against Jeffery (1922): with r the ratio of the axes
and the angle phi between the long axis and the flow, tan phi = tan(gamma t r/(r^2 + 1))/r, and
the period is T = 2 pi (r + 1/r)/gamma."""

import math
from results import Results, half_turn, plt, read, save

shear = 200
ratio = 2


def turned(rows):
    """Angle the long axis has turned by; the axis has no direction, hence modulo pi."""
    angle, result = 0, []
    for r in rows:
        new = math.atan2(-r["axis_y"], r["axis_x"])
        angle += (new - angle + math.pi/2) % math.pi - math.pi/2
        result.append(angle)
    return result


results = Results()
figure, axes = plt.subplots()
phases = [i*math.pi/200 for i in range(1, 300)]
axes.plot([p*(ratio + 1/ratio) for p in phases],
          [math.degrees(math.atan2(math.sin(p)/ratio, math.cos(p)) % math.pi
                        + (math.pi if p >= math.pi else 0)) for p in phases],
          "k", lw=1, label="Jeffery 1922")

for run in read("data.csv"):
    name = f"D/dx {run['D_dx']:g}, height {run['height_over_a']:g} a, dt {run['deltaT_s']:g} s"
    rows = read(run["file"])
    times, angles = [r["t_s"] for r in rows], turned(rows)
    results.add(f"period x shear rate, {name}", 2*half_turn(times, angles)*shear, "-",
                2*math.pi*(ratio + 1/ratio), "3%" if run["D_dx"] < 6 else "1%", "Jeffery 1922")
    axes.plot([t*shear for t in times], [math.degrees(a) for a in angles], "--", label=name)

axes.set_xlabel("shear rate x time")
axes.set_ylabel("angle turned by the long axis [degrees]")
axes.legend(fontsize=8)
save(figure, "jeffery.png")
results.write()
