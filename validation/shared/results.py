"""What the compare scripts of the validations have in common: reading data.csv and the
reference tables, writing results.csv, the look of the figures."""

import csv
import math
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

plt.rcParams.update({
    "figure.figsize": (6.4, 4.2), "figure.dpi": 120, "font.size": 10,
    "axes.grid": True, "grid.alpha": 0.3, "legend.frameon": False,
    "figure.autolayout": True,
})


def read(name):
    """Rows of a csv file as dictionaries, numbers as numbers; lines with # are comments."""
    def number(text):
        try:
            return float(text)
        except (TypeError, ValueError):
            return text
    with open(name) as file:
        lines = [line for line in file if not line.startswith("#")]
    return [{k: number(v) for k, v in row.items()} for row in csv.DictReader(lines)]


def save(figure, name):
    """Keeps the figure of a full run; a quick one has too few points."""
    if os.environ.get("quick") != "true":
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


class Results:
    """Collects the lines of results.csv. Tolerance: a number, or relative as '3%'."""

    def __init__(self):
        self.rows = []

    def add(self, quantity, value, unit, reference, tolerance, source):
        self.rows.append((quantity, f"{value:.6g}", unit, f"{reference:.6g}", tolerance, source))

    def write(self):
        with open("results.csv", "w", newline="") as file:
            out = csv.writer(file)
            out.writerow("quantity value unit reference tolerance source".split())
            out.writerows(self.rows)
        missed = 0
        for quantity, value, unit, reference, tolerance, _ in self.rows:
            v, r = float(value), float(reference)
            t = str(tolerance)
            limit = float(t[:-1])/100*abs(r) if t.endswith("%") else float(t)
            ok = abs(v - r) <= limit
            missed += not ok
            print(f"{'ok    ' if ok else 'MISSED'}  {quantity}: {value} {unit} (reference {reference}, tolerance {t})")
        sys.exit(1 if missed else 0)
