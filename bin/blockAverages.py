#!/usr/bin/python3
"""Means and standard errors of the tables of a run, over time.

    blockAverages.py [-from T] [-to T] [-blocks N] [-by COLUMN] <case> <table> [<column> ...]

    blockAverages.py -from 0.02 . apparentViscosity muRel
    blockAverages.py -from 0.02 -by bin . clumpProfiles s H U

<table> is a function object of the case; without columns all that hold numbers are averaged. -by
averages the rows of every value of a column separately, the bins of a profile for example. The
tables of all restarts are read as one.

The interval from T to T (default: all rows) is divided into N blocks of equal length (default 8).
The mean is that of all rows, its standard error

    error = sqrt(sum_k (m_k - m)^2/(N (N - 1)))

with the means m_k of the blocks. This is right if the blocks are longer than the time over which
the values are correlated. The column "ofHalf" is the same with N/2 blocks of twice the length: if
it is much larger than "error", the blocks are too short, and the larger one is the better estimate.
Rows with nan are left out.
"""

import math
import sys

sys.dont_write_bytecode = True
from clumpArguments import parser   # noqa: E402
from clumpTables import table   # noqa: E402


def mean(values):
    return sum(values)/len(values) if values else math.nan


def block_error(times, values, blocks):
    """Standard error of the mean; nan where a block is empty."""
    if blocks < 2 or not times:
        return math.nan
    first, last = min(times), max(times)
    parts = [[] for _ in range(blocks)]
    for time, value in zip(times, values):
        share = (time - first)/(last - first) if last > first else 0
        parts[min(int(share*blocks), blocks - 1)].append(value)
    if not all(parts):
        return math.nan
    means = [mean(part) for part in parts]
    centre = mean(means)
    return math.sqrt(sum((m - centre)**2 for m in means)/(blocks*(blocks - 1)))


def statistics(rows, column, blocks):
    """Mean, its standard error, and that with half as many blocks."""
    pairs = [(row["time"], row[column]) for row in rows if not math.isnan(row[column])]
    times, values = [t for t, _ in pairs], [v for _, v in pairs]
    return (mean(values), block_error(times, values, blocks),
            block_error(times, values, blocks//2))


def averages(case, name, columns=(), first=-math.inf, last=math.inf, blocks=8, by=None):
    """[(value of by, column, mean, error, error of half)] of a table of a case."""
    rows = [row for row in table(case, name) if first <= row["time"] <= last]
    if not rows:
        sys.exit(f"{case}: no row of {name} in the interval")
    for column in [*columns, *([by] if by else [])]:
        if column not in rows[0]:
            sys.exit(f"{name} has no column '{column}'; there are {', '.join(rows[0])}")
    columns = columns or [key for key, value in rows[0].items()
                          if isinstance(value, float) and key not in ("time", by)]
    groups = {}
    for row in rows:
        groups.setdefault(row[by] if by else None, []).append(row)
    return [(group, column, *statistics(groups[group], column, blocks))
            for group in groups for column in columns]


def main(arguments):
    options = parser(__doc__)
    options.add_argument("-from", dest="first", type=float, default=-math.inf)
    options.add_argument("-to", type=float, default=math.inf)
    options.add_argument("-blocks", type=int, choices=range(2, 10001), metavar="2 to 10000",
                         default=8)
    options.add_argument("-by")
    for name in "case", "table":
        options.add_argument(name)
    options.add_argument("columns", nargs="*")
    given = options.parse_args(arguments)
    by = given.by
    means = averages(given.case, given.table, given.columns, given.first, given.to, given.blocks,
                     by)
    if any(math.isnan(error) and not math.isnan(middle) for _, _, middle, error, _ in means):
        print(f"Without an error (nan): fewer rows than the {given.blocks} blocks, or one of "
              "them is empty; see -blocks", file=sys.stderr)
    print("\t".join(([by] if by else []) + ["column", "mean", "error", "ofHalf"]))
    for group, *cells in means:
        head = [f"{group:g}" if isinstance(group, float) else str(group)] if by else []
        print("\t".join(head + [cells[0]] + [f"{value:.6g}" for value in cells[1:]]))


if __name__ == "__main__":
    main(sys.argv[1:])
