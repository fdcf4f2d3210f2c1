"""Plots of the tables of one or more runs."""
import math

import numpy as np
from clumpDomain import fitting
from clumps import statistics

from clumpReport.figures import Figure, Series

MOST_LINES = 6          # of clumps of a type in a plot; of more there are the quantiles
ROUNDING = 1e-5         # of the largest value in the same unit, below which is no result
TOLERANCE = 2e-4        # the same of forces and torques, which have the error of the solvers
FLAT = 5e-5             # of a value, a variation that is no result
BLOCKS = 8

# Columns in which half the range in one row is the other end of it, beside the coordinates at
# periodic boundaries: angles [rad]
AROUND = {"inclination": np.pi, "phase": 2*np.pi}
AXES = {"s": "s, from the axis or the lower wall"}
AXIS = "axisx", "axisy", "axisz"


def ranges(box):
    """By column, the range [m or rad] at whose ends a value comes round; box: the domain."""
    low, high = box or ([0]*3, [float("inf")]*3)
    return {**AROUND, **{"xyz"[k]: high[k] - low[k] for k in range(3)}}


def steady(line):
    """The rows of a clump with that end of its axis which is nearer to that of the row before."""
    result, before = [], None
    for row in line:
        if set(AXIS) <= set(row):
            axis = np.array([row[name] for name in AXIS], dtype=float)
            if before is not None and axis @ before < 0:
                axis = -axis
            before = axis
            row = {**row, **dict(zip(AXIS, axis))}
        result.append(row)
    return result


def curve(rows, column, around):
    """Times and values; a line is interrupted where a value comes round."""
    times, values = [], []
    jump = 0.5*around.get(column, float("inf"))
    for time, value in ((row["time"], row[column]) for row in rows):
        if values and abs(value - values[-1]) > jump:
            times.append((times[-1] + time)/2)
            values.append(math.nan)
        times.append(time)
        values.append(value)
    return times, values


def rounded(table, radius):
    """Columns whose values are rounding or the error of the solvers: far below the others in the
    same unit, torques also below the forces times a radius."""
    def most(column):
        values = [abs(row[column]) for row in table.rows if math.isfinite(row[column])]
        return max(values) if values else 0

    largest = {}
    for column in table.columns:
        kind = table.unit.get(column)
        if kind:
            largest[kind] = max(largest.get(kind, 0), most(column))
    if radius and "N" in largest:
        for kind in "N m", "N.m":
            largest[kind] = max(largest.get(kind, 0), radius*largest["N"])
    return [c for c in table.columns if 0 < most(c) < largest.get(table.unit.get(c), 0)
            * (TOLERANCE if table.unit.get(c, "").startswith("N") else ROUNDING)]


def groups(rows, key):
    """Rows by the value of a column, in the order in which they come."""
    result = {}
    for row in rows:
        result.setdefault(row[key], []).append(row)
    return result


def quantiles(rows, column):
    """Times, and the quantiles 0.1, 0.5 and 0.9 of all clumps."""
    values = {}
    for row in rows:
        if math.isfinite(row[column]):
            values.setdefault(row["time"], []).append(row[column])
    times = sorted(values)
    return times, *np.array([np.quantile(values[t], (0.1, 0.5, 0.9)) for t in times]).T.reshape(
        3, -1)


def ofClumps(rows, column, kind, around, prefix):
    """A curve per clump of a type, or, of many, the median with the quantiles."""
    each = groups(rows, "clump")
    if len(each) > MOST_LINES:
        times, low, middle, high = quantiles(rows, column)
        yield Series(f"{prefix}median of {len(each)}", times, middle, low, high, kind)
        return
    for clump, line in each.items():
        yield Series(f"{prefix}clump {clump:g}", *curve(steady(line), column, around), kind=kind)


def ofProfile(table, column):
    """Means over the second half of the run with their standard errors, over the place across."""
    rows, _ = table.secondHalf()
    each = [part for _, part in sorted(groups(rows, "bin").items())]
    s = [part[0]["s"] for part in each]
    found = np.array([statistics(part, column, BLOCKS) for part in each])
    y, error = found[:, 0], np.nan_to_num(np.fmax(found[:, 1], found[:, 2]))
    return Series("", s, y, y - error, y + error)


def ofTable(table, column, types, around):
    """The curves of a column."""
    if table.has("bin", "s"):
        series = ofProfile(table, column)
        series.kind = ofType(column, types)
        yield series
    elif table.has("clump", "type"):
        kinds = groups(table.rows, "type")
        for name, rows in kinds.items():
            several = len(kinds) > 1
            yield from ofClumps(rows, column, types.index(name) if several else None, around,
                                f"{name}, " if several else "")
    elif over(table) != "time":
        last = [row for row in table.rows if row["time"] == table.rows[-1]["time"]]
        for name, rows in groups(last, "type").items() if table.has("type") else [("", last)]:
            kind = types.index(name) if name else ofType(column, types)
            yield Series(name, [row[over(table)] for row in rows], [row[column] for row in rows],
                         kind=kind)
    else:
        key = next((k for k in ("patch", "type") if table.has(k)), None)
        for name, rows in groups(table.rows, key).items() if key else [("", table.rows)]:
            kind = types.index(name) if key == "type" else ofType(column, types)
            yield Series(name, *curve(rows, column, around), kind=kind)


def ofType(column, types):
    """Number of the type that the name of a column ends with."""
    return next((k for k, name in enumerate(types) if column.endswith("_" + name)), None)


def over(table):
    """The column that the others are plotted over."""
    if table.has("bin", "s"):
        return "s"
    first = table.columns[0] if table.columns else None
    rows = table.rows
    several = len(rows) > 1 and rows[0]["time"] == rows[1]["time"] and not table.has("clump")
    if several and not table.has("patch") and len(table.columns) > 1 \
            and rows[0][first] != rows[1][first]:
        return first
    return "time"


def note(table):
    """What the curves of a table are."""
    if table.has("bin", "s"):
        return f"Means from {table.secondHalf()[1]:.4g} s on, and their standard errors."
    if table.has("clump", "type"):
        return "A curve for each clump, or, of a type with more than " \
            f"{MOST_LINES}, the median with the quantiles 0.1 and 0.9."
    return f"At {table.rows[-1]['time']:.4g} s." if over(table) != "time" else "Over time."


def axis(name, unit, values):
    """Name of an axis with a unit that fits its values, and the factor to it."""
    values = [abs(v) for v in values if math.isfinite(v)]
    factor, unit = fitting(unit or "", max(values, default=0))
    return name + (f" [{unit}]" if unit else ""), factor


def flat(figure):
    """Limits of a plot whose values vary by rounding only."""
    values = np.concatenate([np.asarray(s.y, dtype=float) for s in figure.series])
    values = values[np.isfinite(values)]*figure.factors[1]
    most = np.abs(values).max() if len(values) else 0
    if most > 0 and np.ptp(values) <= FLAT*most:
        return float(values.mean() - 0.1*most), float(values.mean() + 0.1*most)
    return None


def bases(columns, types):
    """Columns by what they are of all types: {H: [H, H_healthy, H_platelet]}. That of the only type
    is the same as that of all."""
    result = {}
    for column in columns:
        kind = ofType(column, types)
        base = column if kind is None else column[:-len(types[kind]) - 1]
        if kind is None or len(types) > 1 or base not in result:
            result.setdefault(base, []).append(column)
    return result


def figure(tables, base, columns, types, arounds, names):
    """A plot of columns that are of all and of single types, with the curves of every run; names:
    of the runs."""
    x, first = over(tables[0]), tables[0]
    curves = []
    for run, (table, around) in enumerate(zip(tables, arounds)):
        for column in filter(table.columns.__contains__, columns):
            for series in ofTable(table, column, types, around):
                kind = ofType(column, types)
                parts = [names[run] if len(tables) > 1 else "",
                         types[kind] if kind is not None else "all" if len(columns) > 1 else "",
                         series.name]
                series.run, series.name = run, ", ".join(filter(None, parts))
                curves.append(series)
    across, ofX = axis(AXES.get(x, x), "s" if x == "time" else first.unit.get(x),
                       [v for s in curves for v in s.x])
    upwards, ofY = axis(base, first.unit.get(columns[0]), [v for s in curves for v in s.y])
    result = Figure(base, across, upwards, curves, (ofX, ofY), zero=base == "H")
    result.limits = flat(result)
    return result


def passages(tables, types, names):
    """How many clumps of each type have entered and left through each patch, and are inside."""
    curves = []
    for run, table in enumerate(tables):
        prefix = f"{names[run]}: " if len(tables) > 1 else ""
        each = {}
        for row in table.rows:
            each.setdefault((row["event"], row["patch"], row["type"]), []).append(row["time"])
        for (event, patch, kind), times in sorted(each.items()):
            curves.append(Series(f"{prefix}{kind} {event}, {patch}", times,
                                 range(1, len(times) + 1), kind=types.index(kind), run=run))
        curves.append(Series(prefix + "inside", [row["time"] for row in table.rows],
                             [row["inside"] for row in table.rows], run=run))
    across, factor = axis("time", "s", [v for s in curves for v in s.x])
    return Figure("clumps that have entered and left", across, "clumps", curves, (factor, 1),
                  steps=True)
