"""What a red cell that passes both ends of a channel does to flow and pressure, as columns of
leaving.csv. Jumps are second differences: what a step changes beyond the trend of its neighbours.

    python3 passage.py <case>
"""

import sys
from clumps import table

case = sys.argv[1]
forces = table(case, "clumpForce")
pressure = [r["areaAverage(p)"] for r in table(case, "inletPressure")]
inflow = [r["sum(phi)"] for r in table(case, "inletFlow")]
outflow = [r["sum(phi)"] for r in table(case, "outletFlow")]

# Without the start of the flow. The drop as a force on the cross-section
first = 15
force = [r["Fx"] for r in forces][first:]
drop = [1025*256e-12*p for p in pressure][first:]


def largest(values):
    return max(abs(v) for v in values)


def jumps(x):
    return [x[i + 1] - 2*x[i] + x[i - 1] for i in range(1, len(x) - 1)]


print(",".join(f"{v:.6g}" for v in (
    forces[-1]["time"],
    sum(force)/len(force),
    largest(jumps(force)),
    largest(b - a for a, b in zip(drop, drop[1:])),
    largest(jumps(drop)),
    # The step without the red cell against the last one with it
    drop[len(force)] - drop[len(force) - 1],
    largest(a + b for a, b in zip(inflow, outflow))/largest(inflow))))
