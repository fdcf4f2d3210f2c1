#!/usr/bin/python3
"""Reads the tables below postProcessing/ of a case by the names of their columns.

    from clumpTables import table
    rows = table("case", "clumpForce", clump=0)         # [{"time": 0.1, "Fx": 1e-12, ...}, ...]
    rows[-1]["Fx"]

    clumpTables.py [-last] [-clump N] [-type NAME] <case> <table>:<column> ...

prints the columns as comma separated lines, numbers as they stand in the tables: all rows, or those
of clump N, or of the clump type NAME, and with -last the last one of them. The columns may come
from tables that have the same rows, and a column without a table is of the one before. A wrong name
ends with the names there are.

The tables of this library have the names in the first line that is not a comment. Those of OpenFOAM
have them in the last comment line; a value in parentheses below `volAverage(U)` has the names
`volAverage(U) x` and so on, and `Time` is `time`. A table of a restart replaces the rows of
the runs before after the time at which it has started; of those of rbcIbFoam -postProcess only the
rows of further times count.
"""

import bisect
import os
import re
import signal
import sys

sys.dont_write_bytecode = True
from clumpArguments import parser   # noqa: E402


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def own(file_lines):
    """Rows of a table of this library."""
    names = None
    for line in file_lines:
        cells = line.rstrip("\n").split("\t")
        if line.startswith("#"):
            continue
        if names is None:
            names = cells
        else:
            yield dict(zip(names, cells))


def foreign(file_lines):
    """Rows of a table of OpenFOAM."""
    names = []
    for line in file_lines:
        if line.startswith("#"):
            names = [name.strip() for name in line.lstrip("# ").split("\t")]
            names = ["time" if name == "Time" else name for name in names]
            continue
        row = {}
        for name, cell in zip(names, re.findall(r"\([^)]*\)|[^\s()]+", line)):
            if cell.startswith("("):
                row.update(zip((f"{name} {c}" for c in "xyz"), cell.strip("()").split()))
            else:
                row[name] = cell
        yield row


def parse(path):
    """Rows of one file as dictionaries of texts."""
    with open(path) as file:
        lines = file.readlines()
    data = [line for line in lines if not line.startswith("#")]
    named = data and isinstance(number(data[0].split("\t")[0].strip()), str)
    return list(own(lines) if named else foreign(lines))


def ofLaterUse(path):
    """Whether rbcIbFoam -postProcess has written a table."""
    with open(path) as file:
        return file.readline().startswith("# Written by rbcIbFoam -postProcess")


def joined(rows, more):
    """Rows, and of more rows those of further times, in the order of time."""
    times = sorted({float(r["time"]) for r in rows})

    def known(time):
        k = bisect.bisect(times, time)
        return any(abs(t - time) <= 1e-9*abs(time) for t in times[max(k - 1, 0):k + 1])

    return sorted(rows + [r for r in more if not known(float(r["time"]))],
                  key=lambda r: float(r["time"]))


def texts(case, name, **wanted):
    """Rows of a table, of all its starts; wanted: clump=0, type="bead"."""
    folder = os.path.join(case, "postProcessing", name)
    rows, later = [], []
    if not os.path.isdir(folder):
        there = os.path.dirname(folder)
        sys.exit(f"There is no table {name} in {case}; there are "
                 + (", ".join(sorted(os.listdir(there))) if os.path.isdir(there) else "none"))
    for start in sorted(os.listdir(folder), key=float):
        files = [os.path.join(folder, start, file) for file in os.listdir(
            os.path.join(folder, start))]
        for file in sorted(files, key=os.path.getmtime):
            more = parse(file)
            if ofLaterUse(file):
                later = joined(more, later)
                continue
            if rows:
                # Tables of OpenFOAM do not say that -postProcess has written them
                more = [r for r in more if float(r["time"]) > (1 + 1e-9)*float(start)]
            if more:
                rows = [r for r in rows if float(r["time"]) < (1 + 1e-9)*float(start)]
            rows += more
    if later:
        rows = joined(rows, later)
    for key, value in wanted.items():
        if rows and key not in rows[0]:
            sys.exit(f"The table {name} in {case} has no column {key}: its rows are not of clumps")
        rows = [r for r in rows if r[key] == str(value)]
    return rows


def seconds_of_steps(case):
    """Wall time of every step, from the solver's log."""
    with open(os.path.join(case, "log.rbcIbFoam")) as file:
        log = file.read()
    totals = [float(t) for t in re.findall(r"^ExecutionTime = (\S+) s", log, re.M)]
    if totals:
        return [b - a for a, b in zip([0] + totals, totals)]
    return [float(t) for t in re.findall(r"^Step (\S+) s", log, re.M)]


def table(case, name, **wanted):
    """As texts, numbers as numbers."""
    return [{k: number(v) for k, v in row.items()} for row in texts(case, name, **wanted)]


def main(arguments):
    options = parser(__doc__)
    options.add_argument("-last", action="store_true")
    options.add_argument("-clump")
    options.add_argument("-type")
    options.add_argument("case")
    options.add_argument("columns", nargs="+", metavar="table:column")
    given = options.parse_args(arguments)
    wanted = {key: value for key, value in (("clump", given.clump), ("type", given.type)) if value}
    case, columns, name = given.case, [], None
    for word in given.columns:
        name, _, column = word.rpartition(":") if ":" in word else (name, "", word)
        if not name:
            options.error(f"argument table:column: {word} is no column of a table; for all columns"
                          f" of a table read its file in {case}/postProcessing")
        columns.append((name, column))
    tables = {name: texts(case, name, **wanted) for name, _ in columns}
    if len({len(rows) for rows in tables.values()}) != 1:
        sys.exit(f"{case}: the tables {', '.join(tables)} have different numbers of rows")
    count = len(next(iter(tables.values())))
    if count == 0:
        sys.exit(f"{case}: no row" + "".join(f" of {key} {value}" for key, value in wanted.items())
                 + f" in {', '.join(tables)}")
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)       # of a reader that has enough, as head
    for i in range(count - 1 if given.last else 0, count):
        try:
            print(",".join(tables[name][i][column] for name, column in columns))
        except KeyError as error:
            sys.exit(f"{case}: no column {error} in {', '.join(tables)}; there are "
                     + "; ".join(", ".join(rows[i]) for rows in tables.values()))


if __name__ == "__main__":
    main(sys.argv[1:])
