"""Tumbling of a stiff ring against Jeffery (1922): a body of revolution turns as the spheroid with
its effective aspect ratio r (Bretherton 1962), period T = 2 pi (r + 1/r)/gamma."""

import math
from results import Results, half_turn, plt, read, save

shear = 200
ring = "ring 10 spheres r=1.955;R=1.955"
ratio = next(r["aspect_ratio"] for r in read("reference/effectiveAspectRatio.csv")
             if r["body"] == ring)


def turned(rows):
    """Angle the axis has turned by from the flow; every step turns with the rate at its end."""
    angle, time, result = 0, 0, []
    for r in rows:
        angle -= r["rate"]*(r["t_s"] - time)
        time = r["t_s"]
        result.append(angle)
    return result


results = Results()
figure, axes = plt.subplots()
angles = [i*math.pi/200 for i in range(300)]
axes.plot([math.degrees(a) for a in angles],
          [(math.cos(a)**2 + ratio**2*math.sin(a)**2)/(ratio**2 + 1) for a in angles],
          "k", lw=1, label=f"Jeffery 1922, aspect ratio {ratio:.3f}")

for run in read("data.csv"):
    name = f"D/dx {run['D_dx']:g}, height {run['height_over_a']:g} a, dt {run['deltaT_s']:g} s"
    rows = read(run["file"])
    times, angles = [r["t_s"] for r in rows], turned(rows)
    results.add(f"period x shear rate, {name}", 2*half_turn(times, angles)*shear, "-",
                2*math.pi*(ratio + 1/ratio), "2%",
                "Jeffery 1922, reference/effectiveAspectRatio.csv")
    axes.plot([math.degrees(a) for a in angles], [-r["rate"]/shear for r in rows], "--", label=name)

axes.set_xlabel("angle between the axis and the flow [degrees]")
axes.set_ylabel("angular velocity / shear rate")
axes.set_xlim(0, 250)
axes.set_ylim(0, 1.3)
axes.legend(fontsize=8, loc="upper center")
save(figure, "tumblingRing.png")
results.write()
