"""Mean distance of the rings and of the membranes from the axis, at the start and at the end."""

from collections import defaultdict
from math import hypot

from clumps import table

rows = table(".", "clumpForce")
for label, time in ("first", rows[0]["time"]), ("last", rows[-1]["time"]):
    distances = defaultdict(list)
    for row in rows:
        if row["time"] == time:
            distances[row["type"]].append(1e6*hypot(row["y"], row["z"]))
    print(f"{label} row, {1e3*time:g} ms, from the axis: " + ", ".join(
        f"{len(d)} of type {kind} {sum(d)/len(d):.2f} um" for kind, d in distances.items()))
