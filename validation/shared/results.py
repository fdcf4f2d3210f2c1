"""Results of validations: what the compare scripts have in common, and the summary.

    from results import Results, plt, read, save    # in a compare.py, started by Allrun
    results = Results()
    results.add("peak velocity", 0.0572, "m/s", 0.05718, "3%", "ten Cate et al. 2002")
    results.add("peak velocity, coarse", 0.0525, "m/s", 0.05718, "3%", "the same", known=0.0525)
    results.report("seconds per step", 0.4, "s", "this machine")
    results.write()                                 # results.csv; ends the script

    python3 results.py <folder with results.csv> ...    # the table of all; status 1 if one fails

A tolerance is absolute, or relative to the reference with a % sign. The status of a row:

    within         the value is within the tolerance of the reference
    OUTSIDE        it is not: the validation fails
    known miss     it is not, the miss is recorded (known) and explained in the README, and the
                   value is not farther from the reference than the recorded one
    MARK IS STALE  the recorded miss is within the tolerance now: take its mark away; fails
    no reference   the row has none; it is reported, and counts neither way
"""

import csv
import math
import os
import sys

HEADER = ["quantity", "value", "unit", "reference", "tolerance", "source", "known"]
QUICK = os.environ.get("quick") == "true"       # not the run whose misses are recorded
FAILURES = "OUTSIDE", "MARK IS STALE"


def status(row):
    """The status of a row of results.csv, see above."""
    if not row["reference"]:
        return "no reference"
    value, reference, known = (float(row[k] or "nan") for k in ("value", "reference", "known"))
    tolerance = row["tolerance"]
    allowed = float(tolerance.rstrip("%"))
    if tolerance.endswith("%"):
        allowed *= abs(reference)/100
    miss = abs(value - reference)
    if miss <= allowed:
        return "MARK IS STALE" if row["known"] else "within"

    # A hundredth of the recorded miss for its rounding
    if miss <= 1.01*abs(known - reference) and (value - reference)*(known - reference) > 0:
        return "known miss"
    return "OUTSIDE"


def counted(rows):
    """Sentence with the number of rows of every status."""
    found = [status(row) for row in rows]
    text = f"{found.count('within')} within, {found.count('OUTSIDE')} outside"
    for what, name in (("known miss", "known to miss"), ("MARK IS STALE", "with a stale mark"),
                       ("no reference", "without reference")):
        if what in found:
            text += f", {found.count(what)} {name}"
    return text


class Results:
    """Collects the rows of results.csv."""

    def __init__(self):
        self.rows = []

    def add(self, quantity, value, unit, reference, tolerance, source, known=None):
        self.rows.append([quantity, f"{value:.6g}", unit, f"{reference:.6g}", str(tolerance),
                          source,
                          "" if known is None else f"{known:.6g}"])

    def report(self, quantity, value, unit, source):
        """A row without a reference."""
        self.rows.append([quantity, f"{value:.6g}", unit, "", "", source, ""])

    def change(self, name, run, base, column, tolerance, known=None):
        """The relative change of a mean from that of another run, and its standard error."""
        ratio = run[column]/base[column]
        error = math.hypot(run[column + "_error"]/run[column], base[column + "_error"]/base[column])
        self.add(name, ratio - 1, "-", 0, tolerance, "D/dx 4 and the longer step", known)
        self.report(f"{name}: standard error", ratio*error, "-", "blocks")

    def write(self):
        """Writes and prints the rows, and ends the script: status 1 if one fails."""
        write_table("results.csv", HEADER, self.rows)
        rows = [dict(zip(HEADER, row)) for row in self.rows]
        for row in rows:
            print(f"{status(row):13s} {line(row)}")
        print(counted(rows))
        sys.exit(1 if any(status(row) in FAILURES for row in rows) else 0)


def line(row):
    """A row as a sentence."""
    unit = f" {row['unit']}" if row["unit"] not in ("", "-", "1") else ""
    text = f"{row['quantity']}: {row['value']}{unit}"
    if row["reference"]:
        text += f", reference {row['reference']}, tolerance {row['tolerance']}"
    return text + (f", recorded miss {row['known']}" if row["known"] else "")


def find(name):
    """A file of the run (the current folder), else of the validation's own folder."""
    if os.path.exists(name):
        return name
    return os.path.join(os.path.dirname(os.path.abspath(sys.argv[0])), name)


def read(name):
    """Rows of a csv file as dictionaries, numbers as numbers; lines with # are comments."""
    def number(text):
        try:
            return float(text)
        except (TypeError, ValueError):
            return text
    with open(find(name)) as file:
        lines = [text for text in file if not text.startswith("#")]
    return [{k: number(v) for k, v in row.items()} for row in csv.DictReader(lines)]


def at_one_speed(rows, cost):
    """Scales processor seconds to the highest speed that the machine had, at which the unit case
    (see scenes) took least."""
    least = min(row["unit_s"] for row in rows)
    for row in rows:
        row[cost] *= least/row["unit_s"]
        row["unit_s"] = least


def write_table(name, header, rows):
    with open(name, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def __getattr__(name):
    """plt: matplotlib in the style of all figures, loaded only where one is drawn."""
    if name != "plt":
        raise AttributeError(name)
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot
    matplotlib.pyplot.rcParams.update({
        "figure.figsize": (6.4, 4.2), "figure.dpi": 120, "font.size": 10,
        "axes.grid": True, "grid.alpha": 0.3, "legend.frameon": False, "figure.autolayout": True,
    })
    return matplotlib.pyplot


def save(figure, name):
    figure.savefig(name)


def mean(values):
    return sum(values)/len(values)


def deviation(values):
    """Standard deviation of a sample."""
    m = mean(values)
    return math.sqrt(sum((v - m)**2 for v in values)/max(len(values) - 1, 1))


def half_turn(times, angles):
    """Time of half a turn from 10 degrees on, past the start from rest."""
    def crossing(level):
        for i in range(1, len(times)):
            if angles[i - 1] < level <= angles[i]:
                part = (level - angles[i - 1])/(angles[i] - angles[i - 1])
                return times[i - 1] + (times[i] - times[i - 1])*part
        raise SystemExit(f"the axis turned by {angles[-1]:.2f} only: no half period within the run")
    first = math.radians(10)
    return crossing(first + math.pi) - crossing(first)


def main(folders):
    """Prints one table of all results; status 1 if a row fails or there is none."""
    rows = []
    print(f"\n{'':14s}{'validation':<18s}")
    for folder in folders:
        name = os.path.relpath(folder).removesuffix("/run").removesuffix("/quick")
        for row in read(os.path.join(folder, "results.csv")):
            row = {k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()}
            rows.append(row)
            print(f"{status(row):13s} {name:<17s} {line(row)}")
    print(f"\n{counted(rows)}")
    return 1 if not rows or any(status(row) in FAILURES for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
