"""A run with its log, its tables and its clumps, each read once."""
import glob
import math
import os
import re
import sys
from collections import Counter
from functools import cached_property

import numpy as np
from clumpDomain import Domain
from clumps import frames, membranes, seriesFile, spheres, table, tableNames, typeNames

from clumpReport.runLog import Log

LARGEST = 100000        # bytes of a dictionary in the page


class Table:
    """Rows of a table with what its comments say about the columns."""

    def __init__(self, case, name):
        rows = table(case, name)
        self.name, self.title, self.unit, self.meanings = name, name, rows.units, []
        # The last row of a table that is being written may be incomplete
        self.rows = [row for row in rows if len(row) == len(rows[0])]
        paths = sorted(glob.glob(os.path.join(glob.escape(case), "postProcessing", name, "*", "*")))
        with open(paths[0]) as file:
            comments = [line[1:].rstrip() for line in file if line.startswith("#")]
        self.meanings = re.findall(r"(?m)^   (\S[^:]*): (.*)$", "\n".join(comments))
        if self.meanings:
            self.title = next(text for text in map(str.strip, comments)
                              if not text.startswith("Written by"))
        self.columns = [c for c in (self.rows[0] if self.rows else ()) if c not in
                        ("time", "clump", "type") and all(isinstance(row.get(c), float)
                                                          for row in self.rows)]

    def has(self, *names):
        return bool(self.rows) and set(names) <= set(self.rows[0])

    def secondHalf(self):
        """Its rows of the second half of the time, and where that begins."""
        half = self.rows[-1]["time"]/2
        return [row for row in self.rows if row["time"] >= half], half


def byType(s, m):
    """(type, (x, y, z and radius of its spheres, nodes, triangles)) of what is there."""
    places = np.column_stack([s["x"], s["radius"]]) if len(s["x"]) else np.empty((0, 4))
    for kind in sorted({*s["type"], *m["type"]}):
        nodes = m["type"] == kind
        corners = m["triangles"][nodes[m["triangles"][:, 0]]]
        yield int(kind), (places[s["type"] == kind], m["x"][nodes], (np.cumsum(nodes) - 1)[corners])


class Run:
    def __init__(self, case):
        path = os.path.join(case, "log.rbcIbFoam")
        if not os.path.exists(path):
            sys.exit(f"There is no {path}: run rbcIbFoam > log.rbcIbFoam in the case")
        self.case, self.log = case, Log(path)
        self.name = os.path.basename(os.path.abspath(case))
        self.read, self.numbers = {}, {}
        self.frames = frames(case) if seriesFile(case) else []
        # Names of the types in the order of their numbers
        self.types = typeNames(self.frames[-1][1]) if self.frames else []
        found = (Table(case, name) for name in tableNames(case))
        self.tables = {t.name: t for t in found if t.rows and "time" in t.rows[0]}

    @cached_property
    def domain(self):
        return Domain(self.case)

    @cached_property
    def largestRadius(self):
        """Of the spheres [m], zero without any."""
        found = self.clumps(self.frames[-1][1]).values() if self.frames else ()
        return max((radius for places, *_ in found for radius in places[:, 3]), default=0)

    def clumps(self, path):
        """Of a file of VTK/clumps, by number of the type: places and radii of the spheres, nodes
        and triangles of membranes."""
        if path not in self.read:
            s, m = spheres(path), membranes(path)
            self.read[path] = dict(byType(s, m))
            self.numbers[path] = Counter(kind for _, kind in {
                pair for part in (s, m) for pair in zip(part["clump"], part["type"])})
        return self.read[path]

    def inside(self, path):
        """Number of clumps by the name of their type in a file of VTK/clumps."""
        self.clumps(path)
        return Counter({self.types[int(kind)]: n for kind, n in self.numbers[path].items()})

    def allTypes(self):
        """Names of the types in the order of their colours."""
        found = {row["type"]: None for t in self.tables.values() if t.has("type")
                 for row in t.rows}
        return list(dict.fromkeys([*self.types, *sorted(found, key=str)]))

    def later(self):
        """A sentence if the tables go on beyond the time of the log's last step."""
        last = max((t.rows[-1]["time"] for t in self.tables.values()), default=-math.inf)
        if self.log.quiet or not self.log.last or last <= (1 + 1e-9)*float(self.log.last):
            return ""
        return f"The tables go on to {last:g} s: they are of a run with another log."

    def settings(self):
        """The dictionaries of the case by their names."""
        result = {}
        for folder in "constant", "system":
            for path in sorted(glob.glob(os.path.join(glob.escape(self.case), folder, "*"))):
                if os.path.isfile(path) and os.path.getsize(path) < LARGEST:
                    with open(path, errors="replace") as file:
                        result[os.path.relpath(path, self.case)] = file.read()
        return result
