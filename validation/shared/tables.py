"""Reads the tables below postProcessing/ of a case by the names of their columns.

    from tables import table
    rows = table("case", "clumpForce", clump=0)         # [{"time": 0.1, "Fx": 1e-12, ...}, ...]
    rows[-1]["Fx"]

    python3 tables.py [-last] [-clump N] [-type NAME] <case> <table>:<column> ...

prints the columns as comma separated lines, numbers as they stand in the tables; the columns may
come from tables that have the same rows, and a column without a table is of the one before. A wrong
name ends with the names there are.

Names are those of the header without units. Vectors have a name per component: `Fx Fy Fz` are three
columns; `interior x y z` are `interior x`, `interior y`, `interior z`; a value in parentheses below
`volAverage(U)` gives `volAverage(U) x` and so on.
"""

import os
import re
import sys


def column_names(header):
    """Names of the columns below a header line."""
    names = []
    for group in header.lstrip("# ").rstrip("\n").split("\t"):
        words = re.sub(r"\[.*?\]|relative:", " ", group).split()
        if len(words) >= 3 and [w[-1] for w in words[-3:]] in (list("xyz"), list("123")):
            prefix = words[:-3]
            names += [" ".join(prefix + [w]) for w in words[-3:]]
        else:
            names.append(" ".join(words))
    return names


def parse(path):
    """Rows of one file as dictionaries of texts."""
    header, rows = [], []
    with open(path) as file:
        for line in file:
            if line.startswith("#"):
                header = column_names(line)
                continue
            cells, names = [], []
            for name, cell in zip(header, re.findall(r"\([^)]*\)|[^\s()]+", line)):
                parts = cell.strip("()").split()
                cells += parts
                names += [name] if not cell.startswith("(") else [f"{name} {c}" for c in "xyz"]
            rows.append(dict(zip(names, cells)))
    return rows


def texts(case, name, **wanted):
    """Rows of a table, of all its starts; wanted: clump=0, type="bead"."""
    folder = os.path.join(case, "postProcessing", name)
    rows = []
    for start in sorted(os.listdir(folder), key=float):
        for file in sorted(os.listdir(os.path.join(folder, start))):
            rows += parse(os.path.join(folder, start, file))
    for key, value in wanted.items():
        rows = [r for r in rows if r[key] == str(value)]
    if rows and "Time" in rows[0]:
        rows = [{("time" if k == "Time" else k): v for k, v in r.items()} for r in rows]
    return rows


def seconds_of_steps(case):
    """Wall time of every step, from the solver's log."""
    with open(os.path.join(case, "log.rbcIbFoam")) as file:
        log = file.read()
    totals = [float(t) for t in re.findall(r"^ExecutionTime = (\S+) s", log, re.M)]
    if totals:
        return [b - a for a, b in zip([0] + totals, totals)]
    return [float(t) for t in re.findall(r"^Step (\S+) s", log, re.M)]


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def table(case, name, **wanted):
    """As texts, numbers as numbers."""
    return [{k: number(v) for k, v in row.items()} for row in texts(case, name, **wanted)]


def main(arguments):
    last, wanted = False, {}
    while arguments and arguments[0].startswith("-"):
        option = arguments.pop(0)[1:]
        if option == "last":
            last = True
        elif option in ("clump", "type"):
            wanted[option] = arguments.pop(0)
        else:
            sys.exit(__doc__)
    case, columns, name = arguments[0], [], None
    for word in arguments[1:]:
        name, _, column = word.rpartition(":") if ":" in word else (name, "", word)
        columns.append((name, column))
    tables = {name: texts(case, name, **wanted) for name, _ in columns}
    if len({len(rows) for rows in tables.values()}) != 1:
        sys.exit(f"{case}: the tables {', '.join(tables)} have different numbers of rows")
    count = len(next(iter(tables.values())))
    for i in range(max(count - 1, 0) if last else 0, count):
        try:
            print(",".join(tables[name][i][column] for name, column in columns))
        except KeyError as error:
            sys.exit(f"{case}: no column {error} in {', '.join(tables)}; there are "
                     + "; ".join(", ".join(rows[i]) for rows in tables.values()))


if __name__ == "__main__":
    main(sys.argv[1:])
