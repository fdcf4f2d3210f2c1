"""How a cell moves in shear, and how often its spheres go round, against experiments.

The motion, over the second half of a run:
  tank-treading  the spheres go round, the longest axis stays within 20 degrees
  swinging       the spheres go round, the longest axis swings by more, without a turn
  rolling        the longest axis goes round with the spheres
  tumbling       the ring's axis turns in the plane of flow and gradient, less than 45 degrees
                 out of it
"""

import math
from results import Results, mean, plt, read, save


def unwrapped(angles):
    """Degrees of an axis without direction, continued over 180."""
    result = angles[:1]
    for a in angles[1:]:
        result.append(result[-1] + (a - result[-1] + 90) % 180 - 90)
    return result


def motion(rows):
    if mean([abs(r["normal_z"]) for r in rows]) < math.sin(math.pi/4):
        tilt = unwrapped([math.degrees(math.atan2(r["normal_y"], r["normal_x"])) for r in rows])
        return "tumbling" if max(tilt) - min(tilt) > 180 else "swinging", max(tilt) - min(tilt)
    axis = unwrapped([r["inclination_deg"] for r in rows])
    swing = max(axis) - min(axis)
    return "tank-treading" if swing < 20 else "swinging" if swing < 180 else "rolling", swing


reference = read("reference/ttf_fischer_binned.csv")
results = Results()
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2))
points = []

# A ring has no membrane, see the README
known = {8.21: 0.0717997, 16.88: 0.0616169, 32.44: 0.0516876, 65.17: 0.0453307,
         131.59: 0.0398185, 257.99: 0.0378445}

for run in sorted(read("data.csv"), key=lambda r: r["shear_rate"]):
    rows = [r for r in read(run["file"]) if r["t_s"] > run["end_s"]/2]
    stress = 1e-3*run["viscosity_mPas"]*run["shear_rate"]
    kind, swing = motion(rows)
    print(f"{run['start']:<9} {run['viscosity_mPas']:6g} mPa s {run['shear_rate']:7g} 1/s "
          f"{stress:6.3f} Pa: {kind},"
          f" swing {swing:.0f} degrees, inclination "
          f"{mean([r['inclination_deg'] for r in rows]):.1f},"
          f" diameters {1e6*mean([r['L1_m'] for r in rows]):.2f} x "
          f"{1e6*mean([r['L2_m'] for r in rows]):.2f} um,"
          f" axis along the vorticity {rows[0]['normal_z']:.2f} to {rows[-1]['normal_z']:.2f}")
    if run["start"] != "treading":
        continue

    results.add(f"swing of the longest axis at {run['shear_rate']:g} 1/s", swing, "degrees", 0, 20,
                "red blood cells tank-tread at 28.9 mPa s")
    frequency = (rows[-1]["turned_rad"] - rows[0]["turned_rad"])/(rows[-1]["t_s"]
                                                                  - rows[0]["t_s"])/(2*math.pi)
    row = min(reference, key=lambda r: abs(r["mean_shear_rate"] - run["shear_rate"]))
    print(f"frequency of circulation / shear rate: {frequency/run['shear_rate']:.4f}, cells "
          f"{row['mean_f_over_g']}")
    results.add(f"frequency of circulation / shear rate at {run['shear_rate']:g} 1/s",
                frequency/run["shear_rate"], "-", row["mean_f_over_g"], row["sd"],
                "Fischer, reference/ttf_fischer_binned.csv", known[run["shear_rate"]])
    points.append((run["shear_rate"], frequency/run["shear_rate"]))
    times = [run["shear_rate"]*r["t_s"] for r in read(run["file"])]
    right.plot(times, [r["inclination_deg"] for r in read(run["file"])], lw=1,
               label=f"{run['shear_rate']:g} 1/s")

left.errorbar([r["mean_shear_rate"] for r in reference], [r["mean_f_over_g"] for r in reference],
              [r["sd"] for r in reference], fmt="ko", mfc="none", capsize=3,
              label="red blood cells, Fischer")
left.plot(*zip(*sorted(points)), "C0s-", label="ring of ten spheres")
left.axhline(1/(4*math.pi), color="C7", ls=":", label="rigid disc, $1/(4\\pi)$")
left.set_xscale("log")
left.set_ylim(0, 0.09)
left.set_xlabel("shear rate [1/s]")
left.set_ylabel("frequency of circulation / shear rate")
left.legend(fontsize=8)
right.set_xlabel("shear rate x time")
right.set_ylabel("inclination of the longest axis [degrees]")
right.set_xlim(0, 60)
right.legend(fontsize=8)
save(figure, "shearMotion.png")
results.write()
