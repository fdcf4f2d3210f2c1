"""Results of validations: written by their compare scripts, checked by Allrun.

    from results import Results         # in a compare script, run from its folder
    results = Results()
    results.add("axial diameter at 193 pN", 16.4, "um", 16.24, 1.82, "Suresh 2005")
    results.write()                     # results.csv

    python3 results.py stretching ...   # prints one table; status 1 when a result is outside its tolerance

A tolerance is absolute, or relative to the reference with a % sign.
"""
import csv
import math
import os
import sys

HEADER = ["quantity", "value", "unit", "reference", "tolerance", "source"]


class Results:
    def __init__(self):
        self.rows = []

    def add(self, quantity, value, unit, reference, tolerance, source):
        self.rows.append([quantity, f"{value:.6g}", unit, f"{reference:.6g}", str(tolerance), source])

    def write(self, name="results.csv"):
        write_table(name, HEADER, self.rows)
        for row in self.rows:
            print("within" if inside(dict(zip(HEADER, row))) else "OUTSIDE", *row, sep="  ")


def write_table(name, header, rows):
    with open(name, "w", newline="") as f:
        writer = csv.writer(f, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def read_table(name):
    """Rows as dictionaries; lines from # on are comments."""
    with open(name) as f:
        return list(csv.DictReader(line for line in f if not line.startswith("#")))


def clump_shape(case=".", clump=0):
    """Rows of the function object clumpShape of one clump: time, extents along x, y, z."""
    rows = []
    folder = os.path.join(case, "postProcessing/clumpShape")
    for start in sorted(os.listdir(folder), key=float):
        with open(os.path.join(folder, start, "clumpShape.dat")) as f:
            for line in f:
                words = line.replace("(", " ").replace(")", " ").split()
                if words and words[0] != "#" and int(words[1]) == clump:
                    rows.append((float(words[0]), [float(w) for w in words[3:6]], words[2]))
    return rows


def inside(row):
    """Whether a result is within its tolerance; one without a reference is only reported."""
    if not row["reference"]:
        return True
    value, reference = float(row["value"]), float(row["reference"])
    tolerance = row["tolerance"]
    allowed = float(tolerance.rstrip("%"))
    if tolerance.endswith("%"):
        allowed *= abs(reference)/100
    return math.isfinite(value) and abs(value - reference) <= allowed


def figure(columns=1, rows=1, width=None, height=None):
    """A figure in the style that all validations share."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.25, "axes.spines.top": False,
                         "axes.spines.right": False, "legend.frameon": False, "lines.linewidth": 1.4})
    return plt.subplots(rows, columns, figsize=(width or 4.6*columns, height or 3.6*rows), squeeze=False,
                        constrained_layout=True)


def save(fig, name):
    fig.savefig(name, dpi=120)


def main(names):
    bad = 0
    print(f"\n{'validation':<20} {'quantity':<58} {'value':>11} {'reference':>11} {'tolerance':>10}  unit")
    for name in names:
        for row in read_table(os.path.join(name, "results.csv")):
            good = inside(row)
            bad += not good
            print(f"{name:<20} {row['quantity']:<58} {row['value']:>11} {row['reference']:>11} {row['tolerance']:>10}"
                  f"  {row['unit']}{'' if good else '   OUTSIDE'}")
    if not names:
        print("\nNo results")
        return 1
    print(f"\n{bad} outside their tolerance" if bad else "\nAll within their tolerances")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
