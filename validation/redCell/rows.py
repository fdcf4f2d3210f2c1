"""Rows of the tables of a run: of a stretched cell one per force, of one that recovers one per
time, of one in shear one."""
import re
import sys
from math import atan2, cos, degrees, hypot, pi, sin

from clumps import frames, membranes, table

kind = sys.argv[1]
case = {"sheared": "sheared", "turned": "sheared", "tube": "tube"}.get(kind, "stretch")
rows = table(case, "clumpShape")
start = rows[0]


def unwrapped(angles, periods=1):
    """Angles without jumps by a turn, or by a part of it."""
    result = [angles[0]]
    for angle in angles[1:]:
        change = periods*(angle - result[-1])
        result.append(result[-1] + atan2(sin(change), cos(change))/periods)
    return result


def lastHalfTurn(times, angles):
    """Frequency over the last half turn of a node, after which the ellipse is as before, and the
    row where it begins; nan and the middle row where there is none."""
    for n in range(len(angles) - 2, 0, -1):
        if angles[n] - angles[-1] >= pi:
            part = (angles[n] - angles[-1] - pi)/(angles[n] - angles[n + 1])
            return 0.5/(times[-1] - times[n] - part*(times[n + 1] - times[n])), n
    return float("nan"), len(angles)//2


def hollow(path):
    """Depth of the hollow at the rear: from the rearmost node to the rear of the cell within 1 um
    of the line through its centre along the tube."""
    x = membranes(path)["x"]
    centre = x.mean(axis=0)
    middle = [p[0] for p in x if hypot(p[1] - centre[1], p[2] - centre[2]) < 1e-6]
    return min(middle) - min(p[0] for p in x)


if kind == "tube":
    name, distance, seconds = sys.argv[2:]
    speeds = table(case, "clumpForce")
    for time, path in frames(case)[1:]:
        r, f = (min(t, key=lambda row: abs(row["time"] - time)) for t in (rows, speeds))
        print(f"{name},{distance},{time:g},{f['Ux']/0.8e-3:.4f},{1e6*hypot(f['y'], f['z']):.3f},"
              f"{1e6*r['Lx']:.3f},{1e6*r['Ly']:.3f},{1e6*r['Lz']:.3f},{1e6*hollow(path):.3f},"
              f"{r['volume']/start['volume']:.8f},{r['area']/start['area']:.5f},{seconds}")
elif kind == "stretch":
    law, subdivisions, hold = sys.argv[2].split(";")[0].split()[1], sys.argv[3], float(sys.argv[4])
    for n, force in enumerate(sys.argv[5:]):
        held = [r for r in rows if n*hold + 1e-9 < r["time"] <= (n + 1)*hold + 1e-9]
        last = held[-1]
        print(f"{law},{subdivisions},{force},{last['Lx']*1e6:.3f},{last['Ly']*1e6:.3f},"
              f"{last['Lx']/held[-2]['Lx'] - 1:.5f},{last['volume']/start['volume']:.8f},"
              f"{last['area']/start['area']:.5f}")
elif kind == "recovery":
    release, viscosity = float(sys.argv[2]), sys.argv[3]
    for r in rows:
        if r["time"] >= release - 1e-9:
            print(f"{viscosity},{r['time'] - release:g},{r['Lx']/r['Ly']:.5f}")
elif kind == "turned":
    rate, mu, strain, subdivisions = sys.argv[2:]
    axis = unwrapped([r["inclination"] for r in rows], 2)
    node = unwrapped([r["phase"] for r in rows])
    half = len(rows)//2
    print(f"{rate},{mu},{subdivisions},{strain},{degrees(axis[-1] - axis[half]):.0f},"
          f"{degrees(node[-1] - node[half]):.0f}")
else:
    rate, mu, subdivisions, step, cells, seconds = sys.argv[2:]
    with open(f"{case}/log.rbcIbFoam") as file:
        correctors = [int(n) for n in re.findall(r"^Outer correctors: (\d+)", file.read(), re.M)]
    turned = unwrapped([r["phase"] for r in rows])
    f, first = lastHalfTurn([r["time"] for r in rows], turned)
    last = rows[first:]
    mean = {k: sum(r[k] for r in last)/len(last) for k in ("inclination", "Lx", "Lz")}
    print(f"{rate},{mu},{subdivisions},{step},{cells},{f/float(rate):.5f},"
          f"{degrees(mean['inclination']):.2f},{mean['Lx']*1e6:.3f},{mean['Lz']*1e6:.3f},"
          f"{last[-1]['volume']/start['volume']:.8f},{last[-1]['area']/start['area']:.5f},"
          f"{sum(correctors)/len(correctors):.2f},{seconds}")
