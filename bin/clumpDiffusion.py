#!/usr/bin/python3
"""Diffusion of clumps across a flow, from the positions in the table clumpForce.

    clumpDiffusion.py [-from T] [-to T] [-direction x|y|z] [-period L] [-type NAME] <case>

prints the mean squared displacement over the lag, and at the end the coefficient D:

    msd(lag) = mean of (y(t + lag) - y(t))^2 over all clumps and times t        [m2]
    msd(lag) = a + 2 D lag                                                      [m2/s]

with the straight line fitted to the lags from an eighth to a half of the interval, where the
displacements of neighbouring clumps have lost their memory (in shear: a strain of some units). The
error of D is the standard error over eight groups of clumps.

-direction (default y) is the one across the flow, in which the displacement is measured; in a
direction that is periodic, -period is the length of the period [m], and jumps of more than half of
it are taken for crossings of the boundary. Write clumpForce often enough, at least five times in
the shortest lag of interest. The rows must have equal intervals of time.
"""

import math
import sys

sys.dont_write_bytecode = True
from clumpArguments import parser   # noqa: E402
from clumpTables import table   # noqa: E402


def paths(rows, direction, period):
    """Positions of every clump over time, continuous across periodic boundaries."""
    result = {}
    for row in rows:
        path = result.setdefault(row["clump"], [])
        x = row[direction]
        if path and period:
            x -= round((x - path[-1])/period)*period
        path.append(x)
    longest = max(len(path) for path in result.values())
    return [path for path in result.values() if len(path) == longest]


def displacements(some, lag):
    """Mean squared displacement over a number of rows."""
    squares = [(path[i + lag] - path[i])**2
               for path in some for i in range(len(path) - lag)]
    return sum(squares)/len(squares)


def slope(xs, ys):
    """Of the straight line through the points."""
    mx, my = sum(xs)/len(xs), sum(ys)/len(ys)
    return sum((x - mx)*(y - my) for x, y in zip(xs, ys))/sum((x - mx)**2 for x in xs)


def coefficient(some, step):
    """D [m2/s] of some paths."""
    n = len(some[0]) - 1
    lags = sorted({max(1, round(n*k/32)) for k in range(4, 17)})
    if len(lags) < 2:
        sys.exit("too few times for a straight line")
    return slope([lag*step for lag in lags], [displacements(some, lag) for lag in lags])/2


def diffusion(case, direction="y", period=0, first=-math.inf, last=math.inf, **wanted):
    """The lags [s], the mean squared displacements [m2], D and its error [m2/s]."""
    rows = [row for row in table(case, "clumpForce", **wanted) if first <= row["time"] <= last]
    if not rows:
        sys.exit(f"{case}: no row of clumpForce in the interval")
    times = sorted({row["time"] for row in rows})
    all_ = paths(rows, direction, period)
    step = (times[-1] - times[0])/(len(times) - 1)
    counts = sorted({max(1, round((len(times) - 1)*k/32)) for k in range(1, 17)})
    D = coefficient(all_, step)
    groups = [all_[k::8] for k in range(8)]
    error = math.nan
    if all(groups):
        error = math.sqrt(sum((coefficient(g, step) - D)**2 for g in groups)/(8*7))
    return [lag*step for lag in counts], [displacements(all_, lag) for lag in counts], D, error


def main(arguments):
    options = parser(__doc__)
    options.add_argument("-from", dest="first", type=float, default=-math.inf)
    options.add_argument("-to", type=float, default=math.inf)
    options.add_argument("-direction", choices="xyz", default="y")
    options.add_argument("-period", type=float, default=0)
    options.add_argument("-type")
    options.add_argument("case")
    given = options.parse_args(arguments)
    wanted = {"type": given.type} if given.type else {}
    lags, msd, D, error = diffusion(given.case, given.direction, given.period, given.first,
                                    given.to, **wanted)
    print("lag\tmsd")
    for pair in zip(lags, msd):
        print("\t".join(f"{value:.6g}" for value in pair))
    print(f"D = {D:.4g} m2/s, "
          + ("no standard error: it needs eight clumps" if math.isnan(error)
             else f"standard error {error:.2g}"))


if __name__ == "__main__":
    main(sys.argv[1:])
