"""The numbers that the page begins with: what entered and left, the means with their errors."""
import math
from collections import Counter
from dataclasses import dataclass

import numpy as np
from clumpDomain import fitting
from clumps import statistics

from clumpReport.plots import BLOCKS, FLAT, groups, rounded

# Columns of the tables in words; a column Ht_<type> is that of the type alone
WORDS = {
    "muRel": "relative viscosity",
    "Ht": "tube haematocrit",
    "Hd": "discharge haematocrit",
    "Ub": "mean velocity of the blood",
    "layer": "cell-free layer",
    "drift": "drift across the stream",
    "shift": "lateral shift per period",
    "drag": "drag",
    "lift": "lift",
    "TaylorDeformation": "Taylor deformation",
    "deformation": "deformation in the picture",
    "meanTension": "tension of the membrane, mean over its surface",
    "largestTension": "tension of the membrane, largest",
    "areaRatio": "area of the membrane over that at rest",
    "volumeRatio": "volume of the membrane over that at rest",
    "weighted": "size of the cluster of a clump",
    "contacts": "pairs of spheres in contact",
}
PROFILE = {"H": "haematocrit", "U": "velocity of fluid and clumps", "Uc": "velocity of the clumps",
           "n": "number of clumps"}
# Of a branch, from its totals
BRANCH = {"flow": "part of the blood", "clumps": "part of the volume of the clumps",
          "Hd": "discharge haematocrit Hd", "skimming": "Hd over that of the feed",
          "residence": "residence time"}


@dataclass
class Value:
    mean: float
    error: float = math.nan
    change: float = math.nan    # of the mean from the third to the last quarter of the run
    unit: str = ""

    def shown(self, number):
        """A number with the digits that the error leaves, in the unit of the value."""
        factor, unit = fitting(self.unit, np.fmax(abs(self.mean), self.error))
        error = self.error*factor
        digits = f".{min(max(1 - math.floor(math.log10(error)), 0), 8)}f" if error > 0 else ".4g"
        return f"{number*factor:{digits}}", unit

    def text(self):
        if not math.isfinite(self.mean):
            return "-"
        (mean, unit), (error, _) = self.shown(self.mean), self.shown(self.error)
        return mean + (f" ± {error}" if self.error > 0 else "") + (f" {unit}" if unit else "")

    def changeText(self):
        text, unit = self.shown(self.change)
        sign = "+" if self.change > 0 else ""
        return f"{sign}{text} {unit}".strip() if math.isfinite(self.change) else ""


def difference(one, other):
    """Of the second value from the first, and that over its standard error."""
    if one is None or other is None:
        return ""
    result = Value(other.mean - one.mean, math.hypot(one.error, other.error), unit=one.unit)
    return result.text() + (f", {abs(result.mean)/result.error:.1f} errors"
                            if result.error > 0 else "")


def series(rows, column):
    """Rows with the mean over the clumps at each time."""
    return [{"time": time, column: np.mean(finite)} for time, part in groups(rows, "time").items()
            if (finite := [row[column] for row in part if math.isfinite(row[column])])]


def value(rows, column, unit):
    """Mean over time of the mean over clumps, with its standard error from blocks."""
    rows = series(rows, column)
    if not rows:
        return Value(math.nan, unit=unit)
    mean, error, ofHalf = statistics(rows, column, BLOCKS)
    if max(abs(row[column] - mean) for row in rows) <= FLAT*abs(mean):
        return Value(mean, unit=unit)
    middle = (rows[0]["time"] + rows[-1]["time"])/2
    early, late = ([row[column] for row in rows if (row["time"] > middle) == after]
                   for after in (False, True))
    change = np.mean(late) - np.mean(early) if early and late else math.nan
    return Value(mean, float(np.fmax(error, ofHalf)), change, unit)


def numbers(run, types):
    """The key numbers of a run, {words: (value, column)}: means over the second half, in the order
    of WORDS; of each type where the page has several."""
    result = {}
    for table in run.tables.values():
        if table.has("event") or table.has("patch") or table.has("bin"):
            continue
        none = rounded(table, run.largestRadius)
        rows, _ = table.secondHalf()
        kinds = groups(rows, "type") if table.has("clump", "type") else {"": rows}
        for column in table.columns:
            base, _, kind = column.partition("_")
            if base not in WORDS or column in none or kind and len(types) < 2:
                continue
            for name, part in kinds.items():
                of = kind or (name if len(types) > 1 else "")
                words = WORDS[base] + (f", {of}" if of else "")
                result[words] = value(part, column, table.unit.get(column, "")), column
    order = list(WORDS)
    return dict(sorted(result.items(), key=lambda item: order.index(item[1][1].split("_")[0])))


def branches(run):
    """What went through each patch in the end, {patch: {words: value}}. The error of the part of
    the clumps is that of a binomial distribution (Agresti and Coull 1998)."""
    table = next((t for t in run.tables.values() if t.has("patch", "flow", "skimming")), None)
    if not table:
        return {}
    last = {row["patch"]: row for row in table.rows if row["patch"] != "all"}
    result = {}
    left = sum(row["left"] for row in last.values() if math.isfinite(row["clumps"]))
    for patch, row in last.items():
        timed, part = row["timed"], (row["left"] + 2)/(left + 4)
        errors = {"clumps": math.sqrt(part*(1 - part)/(left + 4)),
                  "residence": row["residenceDeviation"]/math.sqrt(timed) if timed else math.nan}
        result[patch] = {words: Value(row[column], errors.get(column, math.nan),
                                      unit=table.unit.get(column, ""))
                         for column, words in BRANCH.items()}
    return result


def balance(run):
    """Rows of clumps by type: at the start, through each patch, at the end; the first has the
    names of the columns. What is not known is left out."""
    table = next((t for t in run.tables.values() if t.has("event", "patch", "type")), None)
    passed = [(row["type"], row["event"], row["patch"]) for row in table.rows] if table \
        else run.log.passages()
    columns = {}
    if run.frames and run.frames[0][0] == 0:
        columns["at the start"] = run.inside(run.frames[0][1])
    for event, patch in sorted({passage[1:] for passage in passed}):
        columns[f"{event} through {patch}"] = Counter(
            kind for kind, *through in passed if through == [event, patch])
    if run.frames:
        columns["at the end"] = run.inside(run.frames[-1][1])
    rows = [[name, *(number[name] for number in columns.values())] for name in run.allTypes()]
    return [["clumps", *columns], *rows] if columns else [[]]
