#!/usr/bin/python3
"""Reads and evaluates what a run writes: the tables in postProcessing and the files in VTK/clumps.

    from clumps import read
    run = read("case")
    print(run)                                      # tables, columns, units, types, times
    time, force = run["clumpForce"]["time"], run["clumpForce"]["Fx"]
    Hd, error = run.means("haematocrit", first=0.02)["Hd"]

This file needs numpy alone and can be copied. As a command, with clumpArguments.py beside it:

    clumps.py show <case>
    clumps.py table [-last] [-clump N] [-type NAME] <case> <table>:<column> ...
    clumps.py means [-from T] [-to T] [-blocks N] [-type NAME] [-by COLUMN] <case> <table>
                    [<column> ...]
    clumps.py diffusion [-from T] [-to T] [-direction x|y|z] [-type NAME] <case>

    clumps.py table -last -clump 0 . clumpForce:time Fx clumpShape:L1
    clumps.py means -from 0.02 . apparentViscosity muRel
    clumps.py means -from 0.02 -by bin . clumpProfiles s H U

show prints which tables and columns there are. table prints columns as comma separated lines,
numbers as they stand in the tables: all rows, or those of clump N, or of the clump type NAME, and
with -last the last one of them. The columns may come from tables that have the same rows, and a
column without a table is of the one before.

means prints means over time and their standard errors; without columns of all that hold numbers.
-by averages the rows of every value of a column separately, the bins of a profile for example; rows
of clumps of several types need -type NAME or -by type. The interval from T to T (default: all rows)
is divided into N blocks of equal length (default 8). The mean is that of all rows, its standard
error

    error = sqrt(sum_k (m_k - m)^2/(N (N - 1)))

with the means m_k of the blocks. This is right if the blocks are longer than the time over which
the values are correlated. The column "ofHalf" is the same with N/2 blocks of twice the length: if
it is much larger than "error", the blocks are too short, and the larger one is the better estimate.
Rows with nan are left out.

diffusion prints the mean square displacement over the lag, and at the end the diffusivity D:

    msd(lag) = mean of (y(t + lag) - y(t))^2 over all clumps and times t        [m2]
    msd(lag) = a + 2 D lag                                                      [m2/s]

with the straight line fitted to the lags from an eighth to a half of the interval, where the
displacements of neighbouring clumps have lost their memory (in shear: a strain of some units). The
error of D is the standard error over eight groups of clumps. -direction (default y) is the one
across the flow, in which the displacement is measured. Write clumpForce, or vtkClumps where there
is no such table, at equal intervals of time, five or more of them in the shortest lag of interest.

The tables of this library have the names in the first line that is not a comment. Those of OpenFOAM
have them in the last comment line; a value in parentheses below `volAverage(U)` has the names
`volAverage(U) x` and so on, and `Time` is `time`. A table of a restart replaces the rows of
the runs before after the time at which it has started; of those of rbcIbFoam -postProcess only the
rows of further times count.
"""

import base64
import bisect
import json
import math
import os
import re
import signal
import sys
from collections import namedtuple
from xml.etree import ElementTree

import numpy as np


class CaseError(LookupError):
    """What was asked for is not in the case; the text says what is there."""


# Tables

class Table(list):
    """Rows of a table, dictionaries by the names of the columns: table[-1]["Fx"] is a number,
    table["Fx"] a column as an array, table.units["Fx"] its unit, "" without one."""

    def __init__(self, rows, name, units):
        super().__init__(rows)
        self.name, self.units = name, units

    @property
    def columns(self):
        return list(self[0]) if self else []

    def __getitem__(self, key):
        if not isinstance(key, str):
            found = super().__getitem__(key)
            return Table(found, self.name, self.units) if isinstance(key, slice) else found
        if self and key not in self[0]:
            raise CaseError(f"{self.name} has no column '{key}'; there are "
                            + ", ".join(self.columns))
        return np.array([row[key] for row in self])

    def frame(self):
        """The table as a pandas.DataFrame; units in its attrs."""
        import pandas
        result = pandas.DataFrame(list(self))
        result.attrs["units"] = self.units
        return result


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
    """Rows of a table of OpenFOAM; those of probes have their numbers in the line above."""
    names = []
    for line in file_lines:
        if line.startswith("#"):
            above = names
            names = [name.strip() for name in line.lstrip("# ").split("\t")]
            names = ["time" if name == "Time" else name for name in names]
            if names == ["time"] and above and above[0].startswith("Probe "):
                names += [f"Probe {number}" for number in above[0].split()[1:]]
            continue
        row = {}
        for name, cell in zip(names, re.findall(r"\([^)]*\)|[^\s()]+", line)):
            if cell.startswith("("):
                row.update(zip((f"{name} {c}" for c in "xyz"), cell.strip("()").split()))
            else:
                row[name] = cell
        yield row


def parse(path):
    """Rows of one file as dictionaries of texts, and the units of the columns that have one."""
    with open(path) as file:
        lines = file.readlines()
    data = [line for line in lines if line.strip() and not line.startswith("#")]
    named = data and isinstance(number(data[0].split()[0]), str)
    comments = [line for line in lines if line.startswith("#")] if named else []
    units = dict(re.findall(r"(\w+)\[([^]]*)\]", comments[-1])) if comments else {}
    return list(own(lines) if named else foreign(lines)), units


def ofLaterUse(path):
    """Whether rbcIbFoam -postProcess has written a table."""
    with open(path) as file:
        return file.readline().startswith("# Written by rbcIbFoam -postProcess")


def united(rows, more):
    """Rows, and of more rows those of further times, in the order of time."""
    times = sorted({float(r["time"]) for r in rows})

    def known(time):
        k = bisect.bisect(times, time)
        return any(abs(t - time) <= 1e-9*abs(time) for t in times[max(k - 1, 0):k + 1])

    return sorted(rows + [r for r in more if not known(float(r["time"]))],
                  key=lambda r: float(r["time"]))


def tableNames(case="."):
    """Names of the tables in postProcessing."""
    folder = os.path.join(case, "postProcessing")
    return sorted(os.listdir(folder)) if os.path.isdir(folder) else []


def texts(case, name, **wanted):
    """Rows of a table as texts, of all its starts; wanted: clump=0, type="bead", which may have
    sizes (bead_1, bead_2 ...). And the units."""
    folder = os.path.join(case, "postProcessing", name)
    rows, later, units = [], [], {}
    if not os.path.isdir(folder):
        raise CaseError(f"There is no table {name} in {case}; there are "
                        + (", ".join(tableNames(case)) or "none"))
    for start in sorted(os.listdir(folder), key=float):
        files = [os.path.join(folder, start, file) for file in os.listdir(
            os.path.join(folder, start))]
        for file in sorted(files, key=os.path.getmtime):
            more, theirs = parse(file)
            units.update(theirs)
            if ofLaterUse(file):
                later = united(more, later)
                continue
            if rows:
                # Tables of OpenFOAM do not say that -postProcess has written them
                more = [r for r in more if float(r["time"]) > (1 + 1e-9)*float(start)]
            if more:
                rows = [r for r in rows if float(r["time"]) < (1 + 1e-9)*float(start)]
            rows += more
    if later:
        rows = united(rows, later)
    for key, value in wanted.items():
        if rows and key not in rows[0]:
            raise CaseError(
                f"The table {name} in {case} has no column {key}: its rows are not of clumps")
        there = {r[key]: 0 for r in rows}
        rows = [r for r in rows if r[key] == str(value)] or \
            [r for r in rows if key == "type" and re.fullmatch(re.escape(value) + r"_\d+", r[key])]
        if there and not rows:
            raise CaseError(f"The table {name} in {case} has no row of {key} {value}; there are "
                            + ", ".join(there))
    return rows, units


def table(case, name, **wanted):
    """A Table; wanted: rows with these values, clump=0 or type="bead"."""
    rows, units = texts(case, name, **wanted)
    rows = [{k: number(v) for k, v in row.items()} for row in rows]
    return Table(rows, name, {c: units.get(c, "") for c in rows[0]} if rows else units)


def seconds_of_steps(case):
    """Wall time of every step, from the solver's log."""
    with open(os.path.join(case, "log.rbcIbFoam")) as file:
        log = file.read()
    totals = [float(t) for t in re.findall(r"^ExecutionTime = (\S+) s", log, re.M)]
    if totals:
        return [b - a for a, b in zip([0] + totals, totals)]
    return [float(t) for t in re.findall(r"^Step (\S+) s", log, re.M)]


# Means over time

def blockError(times, values, blocks):
    """Standard error of the mean from the means of blocks of time; nan where a block is empty."""
    if blocks < 2 or not len(times):
        return math.nan
    share = (times - times[0])/(times[-1] - times[0]) if times[-1] > times[0] else 0*times
    block = np.minimum((share*blocks).astype(int), blocks - 1)
    count = np.bincount(block, minlength=blocks)
    if not count.all():
        return math.nan
    means = np.bincount(block, values, blocks)/count
    return means.std(ddof=1)/math.sqrt(blocks)


def statistics(rows, column, blocks):
    """Mean, its standard error, and that with half as many blocks."""
    pairs = sorted((row["time"], row[column]) for row in rows if not math.isnan(row[column]))
    if not pairs:
        return math.nan, math.nan, math.nan
    times, values = np.array(pairs).T
    return (values.mean(), blockError(times, values, blocks),
            blockError(times, values, blocks//2))


def averages(case, name, columns=(), first=-math.inf, last=math.inf, blocks=8, by=None, **wanted):
    """[(value of by, column, mean, error, error of half)] of a table of a case, see texts. Rows of
    several types have no common mean."""
    whole = table(case, name, **wanted)
    rows = [row for row in whole if first <= row["time"] <= last]
    types = sorted({row["type"] for row in rows if "type" in row})
    if len(types) > 1 and not by and not wanted:
        raise CaseError(f"The rows of {name} in {case} are of the types {', '.join(types)}: choose"
                        " one, or group them by type")
    if not rows:
        raise CaseError(f"{case}: no row of {name} in the interval")
    for column in [*columns, *([by] if by else [])]:
        whole[column]       # fails with the names there are
    columns = columns or [key for key, value in rows[0].items()
                          if isinstance(value, float) and key not in ("time", "clump", by)]
    groups = {}
    for row in rows:
        groups.setdefault(row[by] if by else None, []).append(row)
    return [(group, column, *statistics(groups[group], column, blocks))
            for group in groups for column in columns]


# VTK/clumps

def seriesFile(case="."):
    """The list of the times of the spheres, None where there is none."""
    paths = (os.path.join(case, "VTK", "clumps", f"spheres.{kind}.series")
             for kind in ("pvtp", "vtp"))
    return next(filter(os.path.exists, paths), None)


def frames(case="."):
    """The times that were written [s] and their files."""
    series = seriesFile(case)
    folder = os.path.join(case, "VTK", "clumps")
    if not series:
        path = os.path.join(folder, "spheres.vtp.series")
        raise CaseError(f"There is no {path}; the function object vtkClumps writes it")
    with open(series) as file:
        result = [(f["time"], os.path.join(folder, f["name"])) for f in json.load(file)["files"]]
    if not result:
        raise CaseError(f"There is no time in {series}")
    return result


def pieces(path):
    """Roots of the XML trees of a file of vtkClumps, of a .pvtp those of its pieces."""
    root = ElementTree.parse(path).getroot()
    if not path.endswith(".pvtp"):
        return [root]
    folder = os.path.dirname(path)
    return [ElementTree.parse(os.path.join(folder, piece.get("Source"))).getroot()
            for piece in root.iter("Piece")]


def decoded(root, tag):
    """Arrays below a tag of a file of vtkClumps by name: numbers in base64 after their size."""
    order = "<" if root.get("byte_order") == "LittleEndian" else ">"
    size = 8 if root.get("header_type") == "UInt64" else 4
    result = {}
    for part in root.iter(tag):
        for array in part.iter("DataArray"):
            kind = {"F": "f", "I": "i", "U": "u"}[array.get("type")[0]]
            kind = np.dtype(f"{order}{kind}{int(re.sub('[^0-9]', '', array.get('type')))//8}")
            values = np.frombuffer(base64.b64decode(array.text or ""), np.uint8)[size:].view(kind)
            width = int(array.get("NumberOfComponents", 1))
            values = values.astype(float if kind.kind == "f" else int)
            result[array.get("Name")] = values.reshape(-1, width) if width > 1 else values
    return result


def joint(parts, absent):
    """Dictionaries of arrays, one after the other."""
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]} \
        if parts else absent


def typeNames(path):
    """Names of the types, in the order of the numbers in the array `type`."""
    # In a .pvtp they are in the first piece, as the codes of their letters
    for array in pieces(path)[0].iter("Array"):
        if array.get("Name") == "typeNames":
            return bytes(map(int, array.text.split())).decode().split("\0")[:-1]
    return []


def spheres(path):
    """Centres `x` and every array of a file by name, without rows where there are no spheres."""
    return joint([{**decoded(root, "PointData"), "x": decoded(root, "Points")["Points"].reshape(
        -1, 3)} for root in pieces(path)], {})


def membranes(path):
    """Nodes `x`, corners `triangles` and every array of the membranes at the time of a file of
    spheres, without rows where there are none."""
    folder, name = os.path.split(path)
    path = os.path.join(folder, name.replace("spheres", "membranes"))
    parts, before = [], 0
    for root in pieces(path) if os.path.exists(path) else []:
        x = decoded(root, "Points")["Points"].reshape(-1, 3)
        corners = decoded(root, "Polys")["connectivity"].reshape(-1, 3)
        parts.append({**decoded(root, "PointData"), "x": x, "triangles": before + corners})
        before += len(x)
    return joint(parts, {
        "x": np.empty((0, 3)), "triangles": np.empty((0, 3), dtype=int),
        "clump": np.empty(0), "type": np.empty(0), "U": np.empty((0, 3))})


def drawSpheres(axes, path):
    """Draws the spheres of a file in um as they are seen along z, the lower ones lighter."""
    import matplotlib.pyplot as plt
    s = spheres(path)
    if not len(s["x"]):
        return
    height = 1e6*s["x"][:, 2]
    for k in height.argsort():
        axes.add_patch(plt.Circle(1e6*s["x"][k, :2], 1e6*s["radius"][k], lw=0.3, ec="k",
                                  fc=plt.cm.Reds(0.45 + 0.04*(height[k] - height.min()))))


# Paths

def meshList(path):
    """Points of a file of the mesh as an array, or faces as a list of arrays of their corners."""
    with open(path, "rb") as file:
        data = file.read()
    header = re.search(rb"FoamFile\s*\{[^}]*\}", data)
    faces = b"face" in re.search(rb"class\s+(\w+)", header.group()).group(1)
    start = re.compile(rb"(\d+)\s*\(")
    if not re.search(rb"format\s+binary", header.group()):
        body = data[start.search(data, header.end()).end():]
        rows = [text.split() for text in re.findall(rb"\(([^()]*)\)", body)]
        return [np.array(row, dtype=int) for row in rows] if faces else np.array(rows, dtype=float)
    found = re.search((b"label" if faces else b"scalar") + rb"=(\d+)", header.group())
    bits = int(found.group(1)) if found else 32 if faces else 64
    kind = np.dtype(f"{'i' if faces else 'f'}{bits//8}")

    def numbers(place, width=1):
        """Of the list that begins behind a place, and the place behind them."""
        head = start.search(data, place)
        count = width*int(head.group(1))
        return np.frombuffer(data, kind, count, head.end()), head.end() + count*kind.itemsize

    if not faces:
        return numbers(header.end(), 3)[0].reshape(-1, 3)
    first, place = numbers(header.end())
    return np.split(numbers(place)[0], first[1:-1])


def periods(case="."):
    """Lengths of the periods along x, y and z [m], zero where the mesh is not periodic."""
    folder = os.path.join(case, "constant", "polyMesh")
    if not os.path.exists(os.path.join(folder, "boundary")):
        raise CaseError(f"There is no mesh in {folder}, from which the periods come")
    with open(os.path.join(folder, "boundary")) as file:
        boundary = re.findall(r"(\w+)\s*\{([^{}]*)\}", file.read())
    cyclic = []
    for _, text in boundary:
        entries = dict(re.findall(r"(\w+)\s+(\S+);", text))
        if entries.get("type") in ("cyclic", "cyclicAMI"):
            cyclic.append((int(entries["startFace"]), int(entries["nFaces"])))
    if not cyclic:
        return np.zeros(3)
    x = meshList(os.path.join(folder, "points"))
    faces = meshList(os.path.join(folder, "faces"))
    corners = [np.unique(np.concatenate(faces[a:a + n])) for a, n in cyclic if n]
    found = np.zeros(3)
    for k in range(3):
        ends = [x[c, k].mean() for c in corners
                if np.ptp(x[c, k]) < 1e-6*np.ptp(x, axis=0).max()]
        found[k] = np.ptp(ends) if ends else 0
    return found


def unwrapped(x, period):
    """Positions (..., times, 3) without the jumps at periodic boundaries, at which a step of more
    than half a period is one; period: lengths along x, y and z, zero where there is none."""
    period = np.asarray(period, dtype=float)
    jumps = np.nan_to_num(np.round(np.diff(x, axis=-2)/np.where(period > 0, period, math.inf)))
    result = np.array(x, dtype=float)
    result[..., 1:, :] -= period*np.cumsum(jumps, axis=-2)
    return result


def msd(x, lag):
    """Mean square displacement of positions (clumps, times) over a number of rows."""
    return np.mean((x[:, lag:] - x[:, :-lag])**2)


def diffusivity(x, step):
    """Half the slope of the mean square displacement of positions (clumps, times) that are a step
    of time apart [m2/s]."""
    n = x.shape[1] - 1
    lags = sorted({max(1, round(n*k/32)) for k in range(4, 17)})
    if n < 1 or len(lags) < 2:
        raise CaseError("too few times for a straight line")
    return np.polyfit(np.array(lags)*step, [msd(x, lag) for lag in lags], 1)[0]/2


# A run

Trajectories = namedtuple("Trajectories", "time clump x")
Diffusion = namedtuple("Diffusion", "lag msd D error")


class Run:
    """A case and what its runs have written. first and last are times [s], type and clump the name
    of a type and the number of a clump; without them everything counts."""

    def __init__(self, case="."):
        if not os.path.isdir(case):
            raise CaseError(f"There is no folder {case}")
        self.case = case

    @property
    def tables(self):
        return tableNames(self.case)

    def __getitem__(self, name):
        return table(self.case, name)

    def table(self, name, **wanted):
        """A Table, of a clump (clump=0) or a type (type="bead")."""
        return table(self.case, name, **wanted)

    @property
    def frames(self):
        """Times [s] and files of the spheres; pyvista.read opens the files."""
        return frames(self.case)

    @property
    def types(self):
        """Names of the clump types."""
        if seriesFile(self.case):
            return typeNames(self.frames[-1][1])
        return sorted({row["type"] for _, rows in self.readable() for row in rows
                       if "type" in row and row.get("clump") != -1})     # -1: of means

    def readable(self):
        """Names and tables of postProcessing, without what is no table over time."""
        for name in self.tables:
            try:
                rows = self[name]
            except (LookupError, ValueError):
                continue
            if not rows or "time" in rows.columns:
                yield name, rows

    def at(self, time=math.inf):
        """The file of the spheres at the written time that is nearest, the last one without it."""
        written = self.frames
        return min(written, key=lambda f: abs(f[0] - min(time, written[-1][0])))[1]

    def spheres(self, time=math.inf):
        """Arrays of the spheres: x, radius, U, clump, type ..., see at."""
        return spheres(self.at(time))

    def membranes(self, time=math.inf):
        """Arrays of the nodes of the membranes, and their triangles, see at."""
        return membranes(self.at(time))

    def series(self, name, *columns, **wanted):
        """Times, numbers of the clumps, and a column of a table as an array (clumps, times), nan
        where a clump has no row; several columns as (clumps, times, columns)."""
        rows = self.table(name, **wanted)
        times, i = np.unique(rows["time"], return_inverse=True)
        clumps, j = np.unique(rows["clump"], return_inverse=True)
        values = np.full((len(clumps), len(times), len(columns)), math.nan)
        values[j, i] = np.transpose([rows[column] for column in columns])
        return times, clumps.astype(int), values if len(columns) > 1 else values[..., 0]

    def shapes(self, column="TaylorDeformation", **wanted):
        """A series of clumpShape."""
        return self.series("clumpShape", column, **wanted)

    def trajectories(self, first=-math.inf, last=math.inf, type=None):
        """Times, numbers of the clumps and positions x (clumps, times, 3) [m] without jumps at
        periodic boundaries: the centres of mass in the table clumpForce, or else the mean of the
        spheres or nodes in VTK/clumps, between whose times no clump may go half a period, and which
        are relative to the mesh where it slides along the flow."""
        if "clumpForce" in self.tables:
            time, clump, x = self.series("clumpForce", *"xyz", **({"type": type} if type else {}))
        else:
            time, clump, x = self.centres(type)
        inside = (first <= time) & (time <= last)
        if not inside.any():
            raise CaseError(f"{self.case}: no clumps in the interval")
        there = ~np.isnan(x[:, inside]).all(axis=(1, 2))
        return Trajectories(time[inside], clump[there], x[:, inside][there])

    def centres(self, type=None):
        """Times, numbers and centres of the clumps in VTK/clumps."""
        if type and type not in self.types:
            raise CaseError(f"{self.case} has no type {type}; there are {', '.join(self.types)}")
        found = []
        for time, path in self.frames:
            places = {}
            for part in spheres(path), membranes(path):
                for clump in np.unique(part["clump"]):
                    own = part["clump"] == clump
                    if not type or typeNames(path)[int(part["type"][own][0])] == type:
                        places[int(clump)] = part["x"][own].mean(axis=0)
            found.append((time, places))
        clumps = np.array(sorted({clump for _, places in found for clump in places}), dtype=int)
        x = np.array([[places.get(clump, [math.nan]*3) for _, places in found]
                      for clump in clumps]).reshape(len(clumps), len(found), 3)
        return np.array([time for time, _ in found]), clumps, unwrapped(x, periods(self.case))

    def diffusion(self, direction="y", first=-math.inf, last=math.inf, type=None):
        """Lags [s], mean square displacements [m2], diffusivity D and its standard error [m2/s] of
        the clumps that are there at all times; nan without eight clumps. See the top."""
        time, _, x = self.trajectories(first, last, type)
        x = x[:, :, "xyz".index(direction)]
        x = x[~np.isnan(x).any(axis=1)]
        if not len(x):
            raise CaseError(f"{self.case}: no clump is there at all times")
        if len(time) > 2 and np.ptp(np.diff(time)) > 0.1*np.diff(time).mean():
            raise CaseError(f"{self.case}: the times are not at equal intervals")
        step = (time[-1] - time[0])/max(len(time) - 1, 1)
        D = diffusivity(x, step)
        groups = [x[k::8] for k in range(8)]
        error = math.nan
        if all(map(len, groups)):
            error = math.sqrt(sum((diffusivity(g, step) - D)**2 for g in groups)/(8*7))
        counts = sorted({max(1, round((len(time) - 1)*k/32)) for k in range(1, 17)})
        return Diffusion(np.array(counts)*step, np.array([msd(x, n) for n in counts]), D, error)

    def means(self, name, first=-math.inf, last=math.inf, blocks=8, **wanted):
        """Mean over time and its standard error of every column of numbers of a table, by name, of
        a clump (clump=0) or a type (type="bead"). The error is the larger one of those with so many
        blocks of time and with half of them."""
        return {column: (mean, np.fmax(*errors)) for _, column, mean, *errors in
                averages(self.case, name, (), first, last, blocks, **wanted)}

    def profile(self, column, first=-math.inf, last=math.inf, name="clumpProfiles"):
        """Positions of the bins [m], means over time of a column and their standard errors, those
        of means."""
        found = averages(self.case, name, ("s", column), first, last, by="bin")
        s = np.array([row[2] for row in found[::2]])
        mean, error, ofHalf = np.array([row[2:] for row in found[1::2]]).T
        return s, mean, np.fmax(error, ofHalf)

    def __repr__(self):
        lines = [f"{os.path.abspath(self.case)}: types {', '.join(self.types) or 'unknown'}"]
        for name, rows in self.readable():
            lines.append(f"{name}: {len(rows)} rows; " + ", ".join(
                column + (f" [{rows.units[column]}]" if rows.units[column] else "")
                for column in rows.columns))
        if seriesFile(self.case):
            times = [time for time, _ in self.frames]
            lines.append(f"VTK/clumps: {len(times)} times from {times[0]:g} s to {times[-1]:g} s")
        return "\n".join(lines)


def read(case="."):
    """The Run of a case."""
    return Run(case)


# Commands

def printTable(given, wrong):
    wanted = {key: value for key, value in (("clump", given.clump), ("type", given.type)) if value}
    case, columns, name = given.case, [], None
    for word in given.columns:
        name, _, column = word.rpartition(":") if ":" in word else (name, "", word)
        if not name:
            wrong(f"argument table:column: {word} is no column of a table; for all columns"
                  f" of a table read its file in {case}/postProcessing")
        columns.append((name, column))
    tables = {name: texts(case, name, **wanted)[0] for name, _ in columns}
    if len({len(rows) for rows in tables.values()}) != 1:
        sys.exit(f"{case}: the tables {', '.join(tables)} have different numbers of rows")
    count = len(next(iter(tables.values())))
    if count == 0:
        sys.exit(f"{case}: no row" + "".join(f" of {key} {value}" for key, value in wanted.items())
                 + f" in {', '.join(tables)}")
    for i in range(count - 1 if given.last else 0, count):
        try:
            print(",".join(tables[name][i][column] for name, column in columns))
        except KeyError as error:
            sys.exit(f"{case}: no column {error} in {', '.join(tables)}; there are "
                     + "; ".join(", ".join(rows[i]) for rows in tables.values()))


def printMeans(given, _):
    by = given.by
    found = averages(given.case, given.table, given.columns, given.first, given.to, given.blocks,
                     by, **({"type": given.type} if given.type else {}))
    if any(math.isnan(error) and not math.isnan(middle) for _, _, middle, error, _ in found):
        print(f"Without an error (nan): fewer rows than the {given.blocks} blocks, or one of "
              "them is empty; see -blocks", file=sys.stderr)
    print("\t".join(([by] if by else []) + ["column", "mean", "error", "ofHalf"]))
    for group, *cells in found:
        head = [f"{group:g}" if isinstance(group, float) else str(group)] if by else []
        print("\t".join(head + [cells[0]] + [f"{value:.6g}" for value in cells[1:]]))


def printDiffusion(given, _):
    found = read(given.case).diffusion(given.direction, given.first, given.to, given.type)
    print("lag\tmsd")
    for pair in zip(found.lag, found.msd):
        print("\t".join(f"{value:.6g}" for value in pair))
    print(f"D = {found.D:.4g} m2/s, "
          + ("no standard error: it needs eight clumps" if math.isnan(found.error)
             else f"standard error {found.error:.2g}"))


def main(arguments):
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)       # of a reader that has enough, as head
    sys.dont_write_bytecode = True
    from clumpArguments import parser
    options = parser(__doc__)
    commands = options.add_subparsers(dest="command", required=True, metavar="command")

    def command(name, action, *flags):
        """A command with a case; flags: those for a type and an interval of time."""
        result = commands.add_parser(name, prog=f"clumps.py {name}", add_help=False,
                                     allow_abbrev=False)
        result.set_defaults(action=action, wrong=result.error)
        if "type" in flags:
            result.add_argument("-type")
        if "interval" in flags:
            result.add_argument("-from", dest="first", type=float, default=-math.inf)
            result.add_argument("-to", type=float, default=math.inf)
        result.add_argument("case")
        return result

    command("show", lambda given, _: print(read(given.case)))
    one = command("table", printTable, "type")
    one.add_argument("-last", action="store_true")
    one.add_argument("-clump")
    one.add_argument("columns", nargs="+", metavar="table:column")
    one = command("means", printMeans, "type", "interval")
    one.add_argument("-blocks", type=int, choices=range(2, 10001), metavar="2 to 10000", default=8)
    one.add_argument("-by")
    one.add_argument("table")
    one.add_argument("columns", nargs="*")
    one = command("diffusion", printDiffusion, "type", "interval")
    one.add_argument("-direction", choices="xyz", default="y")
    if {"-h", "-help", "--help"} & set(arguments):
        arguments = ["-help"]       # of all commands
    given = options.parse_args(arguments)
    given.action(given, given.wrong)


if __name__ == "__main__":
    main(sys.argv[1:])
