"""The row of data.csv of a run, and its history of places."""
import sys

import numpy as np
from clumps import frames, membranes, table

SLIT = 14e-6, 20e-6         # along the channel [m]

case, parameters, steps, seconds, history = sys.argv[1:]


def enclosed(nodes, surface, triangles):
    """The part of the nodes around which the surface has a whole solid angle (van Oosterom and
    Strackee 1983)"""
    a, b, c = (surface[None, triangles[:, k]] - nodes[:, None] for k in range(3))
    A, B, C = (np.linalg.norm(v, axis=2) for v in (a, b, c))
    angle = 2*np.arctan2(
        (a*np.cross(b, c)).sum(axis=2),
        A*B*C + (a*b).sum(axis=2)*C + (b*c).sum(axis=2)*A + (c*a).sum(axis=2)*B).sum(axis=1)
    return np.isclose(angle, 4*np.pi, atol=1e-6).mean()


rows = []
for time, path in frames(case):
    m = membranes(path)
    cell, nucleus = (m["x"][m["clump"] == n] for n in (0, 1))
    first = np.argmax(m["clump"] == 0)
    triangles = m["triangles"][m["clump"][m["triangles"][:, 0]] == 0] - first
    rows.append((time, cell[:, 0].min(), cell[:, 0].max(), nucleus[:, 0].min(),
                 nucleus[:, 0].max(), np.ptp(cell[:, 1]), np.ptp(nucleus[:, 1]),
                 enclosed(nucleus, cell, triangles)))
with open(history, "w") as file:
    file.write("time_s,cellRear_m,cellFront_m,nucleusRear_m,nucleusFront_m,cellHeight_m,"
               "nucleusHeight_m,inside\n")
    for row in rows:
        file.write(",".join("%.6g" % v for v in row) + "\n")

volumes = {}
for row in table(case, "clumpShape"):
    volumes.setdefault(row["clump"], []).append(row["volume"])
off = [max((v/values[0] for v in values), key=lambda v: abs(v - 1)) for _, values in
       sorted(volumes.items())]
enters = next((t for t, _, front, *_ in rows if front > SLIT[0]), float("nan"))
inside = next((row[0] for row in rows if row[3] > SLIT[0]), float("nan"))
print("%s,%.3g,%.3g,%.10f,%.10f,%.6f,%.3f,%s,%s" % (
    parameters, 1e3*enters, 1e3*inside, *off, min(r[7] for r in rows),
    1e6*max(r[6] for r in rows if r[3] > SLIT[0]), steps, seconds))
