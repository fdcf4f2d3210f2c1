"""The row of a run in data.csv: steps, whether it ended, mean outer correctors, steps that were
repeated and that missed the tolerance, largest change of volume, largest area and length over those
at the start, the same in the second half of the run over the first, and largest angle between
triangles that share an edge at any time written."""
import re
import sys

import clumps
import numpy as np

case, name = sys.argv[1:]
with open(f"{case}/log.rbcIbFoam") as file:
    log = file.read()
correctors = [int(n) for n in re.findall(r"^Outer correctors: (\d+)", log, re.M)]
missed = re.findall(r"(\d+) of \d+ steps did not reach", log)


def fold(path):
    """Largest angle between the normals of neighbouring triangles [degrees]."""
    membranes = clumps.membranes(path)
    x, triangles = membranes["x"], membranes["triangles"]
    a, b, c = (x[triangles[:, i]] for i in range(3))
    n = np.cross(b - a, c - a)
    n /= np.linalg.norm(n, axis=1)[:, None]
    edges = {}
    smallest = 1
    for t, corners in enumerate(triangles):
        for i in range(3):
            edge = frozenset((corners[i], corners[(i + 1) % 3]))
            if edge in edges:
                smallest = min(smallest, n[t] @ n[edges[edge]])
            edges[edge] = t
    return np.degrees(np.arccos(smallest))


rows = clumps.table(case, "clumpShape")
first = rows[0]
volume = max(abs(r["volume"]/first["volume"] - 1) for r in rows)
middle = len(rows)//2
area, length = (max(r[c] for r in rows)/first[c] for c in ("area", "L1"))
later = [max(r[c] for r in rows[middle:])/max(r[c] for r in rows[:middle])
         for c in ("area", "L1")]
folds = max(fold(path) for _, path in clumps.frames(case))
print(f"{name},{len(correctors)},{'yes' if re.search('^End', log, re.M) else 'no'},"
      f"{sum(correctors)/max(len(correctors), 1):.2f},"
      f"{len(re.findall('is repeated with', log))},{missed[0] if missed else 0},"
      f"{volume:.1e},{area:.3f},{length:.3f},{later[0]:.5f},{later[1]:.5f},{folds:.0f}")
