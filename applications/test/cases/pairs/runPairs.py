"""Runs the rows of the covering array of features.py, and judges each by invariants.

    runPairs.py <folder> quick          the first rows, which cover the most pairs
    runPairs.py <folder> all
    runPairs.py <folder> <row> [<factor>=<level> ...]   one row, changed; its cases are kept
    runPairs.py <folder> reduce <row> [...]     with the plainest levels that fail as it does

A row on several ranks is compared with a serial run of the same scene, a row that is disturbed
with the undisturbed run: kill (-9) and go on, restart at half time, and the same on another number
of ranks.
"""

import functools
import os
import re
import shutil
import signal
import subprocess
import sys
import time

from coveringArray import CoveringArray
from features import END, FEATURES, FORBIDDEN, Scene
from invariants import Judge, resistance
from known import FOUND

QUICK = 8
OTHER = {1: 2, 2: 3, 3: 1}              # ranks after a restart on another number of them
CLASSES = {"U": "volVectorField", "g": "uniformDimensionedVectorField",
           **dict.fromkeys(("p", "evenSolute", "loadedSolute"), "volScalarField")}


class Failed(Exception):
    pass


def essence(log):
    """Of the end of a run that failed"""
    start = log.find("--> FOAM FATAL")
    said = re.sub(r"^\[\d+\] ?", "", log[start:] if start >= 0 else log, flags=re.M)
    if start >= 0:
        return "        " + said.split("From function")[0].strip()[:600].replace("\n", "\n        ")
    end = said[-6000:]
    frames = re.findall(r"Assertion.*|exited on signal.*|(?<=  )Foam::\w[\w:]*(?=\()", end)
    return "        " + (" < ".join(frames[:12]) or end[-300:])[:600]


class Case:
    def __init__(self, folder, ranks):
        self.folder, self.ranks = folder, ranks

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, scene):
        for name, text in scene.files.items():
            os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
            with open(self.path(name), "w") as file:
                kind = CLASSES.get(os.path.basename(name), "dictionary")
                file.write("FoamFile { version 2.0; format ascii; class %s; object %s; }\n%s"
                           % (kind, os.path.basename(name), text))
        for utility in scene.utilities:
            self.run(*utility.split())
        if self.ranks > 1:
            self.run("decomposePar")
        return self

    def copy(self, folder, ranks=None):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.folder, folder)
        return Case(folder, ranks or self.ranks)

    def set(self, name, text):
        """Text at the end of a file, which overrides what stands before."""
        with open(self.path(name), "a") as file:
            file.write(text + "\n")

    def start(self, log, command):
        return subprocess.Popen(command, cwd=self.folder, env=dict(os.environ, PWD=self.folder),
                                stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT)

    def run(self, *command):
        """A utility, or with a log that is added to, the solver."""
        log = self.path("log." + ("rbcIbFoam" if command[0] == "mpirun" else command[0]))
        with open(log, "a") as file:
            process = self.start(file, command)
            try:
                process.wait(300)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
                raise Failed("%s takes more than five minutes in %s"
                             % (" ".join(command), self.folder))
        if process.returncode:
            with open(log, errors="replace") as file:
                text = file.read()
            raise Failed("ends with status %d: %s in %s\n%s" % (
                process.returncode, " ".join(command), self.folder, essence(text)))

    def solver(self):
        return ["rbcIbFoam"] if self.ranks == 1 else \
            ["mpirun", "-np", str(self.ranks), "rbcIbFoam", "-parallel"]

    def solve(self):
        self.run(*self.solver())
        return self

    def parts(self):
        return ["."] if self.ranks == 1 else ["processor%d" % i for i in range(self.ranks)]

    def times(self):
        names = [n for n in os.listdir(self.path(self.parts()[0])) if n[0].isdigit()]
        return sorted(names, key=float)

    def removeAfter(self, limit):
        for part in self.parts():
            for name in os.listdir(self.path(part)):
                if name[0].isdigit() and float(name) > limit:
                    shutil.rmtree(self.path(part, name))

    def solveUntilKilled(self, when):
        """kill -9 of one process of the solver in the first step after a time."""
        log = self.path("log.rbcIbFoam")
        with open(log, "w") as file:
            process = self.start(file, self.solver())
            reached = 0
            with open(log) as lines:
                while process.poll() is None and reached < when:
                    line = lines.readline()
                    if line.startswith("Time = "):
                        reached = float(line.split()[2])
                    elif not line:
                        time.sleep(0.02)
            for pid in solversOf(process.pid)[-1:]:
                os.kill(pid, signal.SIGKILL)
            process.wait()
        if not process.returncode:
            raise Failed("not killed in " + self.folder)


def solversOf(first):
    """rbcIbFoam among a process and its children"""
    found = []
    for entry in os.listdir("/proc"):
        try:
            with open(f"/proc/{entry}/stat") as file:
                pid, rest = file.read().split(" (", 1)
            name, rest = rest.rsplit(") ", 1)
            if name == "rbcIbFoam" and first in (int(pid), int(rest.split()[1])):
                found.append(int(pid))
        except (OSError, ValueError):
            pass
    return sorted(found)


def sameBits(one, other):
    """Files of the later times that differ, but for the run's own clock"""
    for part in one.parts():
        for name in one.times()[1:]:
            root = one.path(part, name)
            for folder, _, files in os.walk(root):
                if "functionObjects" in folder:
                    continue
                for file in files:
                    path = os.path.relpath(os.path.join(folder, file), one.folder)
                    try:
                        with open(one.path(path), "rb") as a, open(other.path(path), "rb") as b:
                            if a.read() != b.read():
                                yield path
                    except FileNotFoundError:
                        # A mesh that has not changed since the restart is not written again
                        if os.path.basename(folder) != "polyMesh":
                            yield path


def disturbed(kind, case, fresh):
    """The run of a scene that is disturbed; fresh: the case before it ran"""
    folder = os.path.join(os.path.dirname(case.folder), kind)
    if kind == "kill":
        result = fresh.copy(folder)
        result.solveUntilKilled(0.62*END)
        return result.solve()
    result = case.copy(folder)
    result.removeAfter(0.51*END)
    if kind == "otherRanks":
        if result.ranks > 1:
            if os.path.exists(result.path("constant/dynamicMeshDict")):
                result.run("reconstructParMesh", "-latestTime")
            result.run("reconstructPar", "-latestTime")
            for part in result.parts():
                shutil.rmtree(result.path(part))
        result.ranks = n = OTHER[case.ranks]
        result.set("system/decomposeParDict", f"numberOfSubdomains {n}; coeffs {{ n ({n} 1 1); }}")
        if n > 1:
            result.run("decomposePar", "-latestTime")
    shutil.rmtree(result.path("postProcessing"))
    return result.solve()


def runRow(row, folder):
    """Runs and judges a row; the findings, and all that was judged"""
    shutil.rmtree(folder, ignore_errors=True)
    scene = Scene(row)
    judge = Judge(scene)
    kind, ranks = row["disturbance"], int(row["ranks"])

    @functools.lru_cache
    def nudged():
        place = os.path.join(folder, "nudged")
        return Case(place, 1).write(Scene(row, nudge=1e-9)).solve().folder

    try:
        case = Case(os.path.join(folder, "run"), ranks).write(scene)
        fresh = case.copy(os.path.join(folder, "fresh")) if kind == "kill" else None
        case.solve()
        judge.run(case.folder)
        if ranks > 1:
            serial = Case(os.path.join(folder, "serial"), 1).write(scene).solve()
            judge.agree("serial equals parallel", serial.folder, case.folder, nudged)
        if kind != "none":
            other = disturbed(kind, case, fresh)
            if kind == "otherRanks":
                judge.agree("restart on %d ranks" % other.ranks, case.folder, other.folder,
                            nudged)
            else:
                files = list(sameBits(case, other))
                judge.check(kind + ": files that differ", len(files), 0, " ".join(files[:3]))
    except Failed as failure:
        judge.fail(str(failure))
    return judge


def reduced(row, folder, allowed):
    """The row with the first, plainest level of each factor that a failure of it does not need"""
    def failures(row):
        return {text.split(":")[0] for text in runRow(row, folder).findings}

    sought = sorted(failures(row))[:1]
    for factor in reversed(list(FEATURES)):
        other = dict(row, **{factor: next(iter(FEATURES[factor]))})
        if other != row and allowed(other) and failures(other).issuperset(sought):
            row = other
    return row


def main(folder, what, *changes):
    begin = time.time()
    array = CoveringArray({f: list(levels) for f, levels in FEATURES.items()}, FORBIDDEN)
    reducing = what == "reduce"
    if reducing:
        what, *changes = changes
    one = what.isdigit()
    numbers = [int(what)] if one else \
        range(1, (QUICK if what == "quick" else len(array.rows)) + 1)
    covered = set().union(*(array.pairs(array.rows[n - 1]) for n in numbers)) & array.feasible
    print("%d of %d rows, which cover %d of %d feasible pairs of features"
          % (len(numbers), len(array.rows), len(covered), len(array.feasible)), flush=True)
    bad = 0

    def report(name, judge):
        nonlocal bad
        bad += bool(judge.findings)
        print("%s %s" % ("FAILED" if judge.findings else "passed", name))
        print("".join("    %s\n" % text for text in (judge.all if one else []) + judge.findings
                      + ["known miss, " + known for known in judge.known]), end="", flush=True)

    for number in numbers:
        start = time.time()
        row = dict(array.rows[number - 1], **dict(change.split("=") for change in changes))
        place = os.path.join(folder, "row%d" % number)
        if reducing:
            row = reduced(row, place, array.allowed)
        judge = runRow(row, place)
        report("row %d, %.1f s: %s" % (number, time.time() - start, " ".join(
            "%s=%s" % item for item in row.items())), judge)
        if not one:
            shutil.rmtree(place)
    for found in [] if one else FOUND:
        start = time.time()
        row = {factor: found.get(factor, next(iter(FEATURES[factor]))) for factor in FEATURES}
        judge = runRow(row, os.path.join(folder, "found"))
        report("found, %.1f s: %s" % (time.time() - start, " ".join(
            "%s=%s" % item for item in found.items())), judge)
    bodies = ["dumbbell"] if what == "quick" else [
        b for b in FEATURES["bodies"] if b not in ("several", "bouncing")]
    for body, judge in [] if one else resistance(folder, bodies, Case):
        report("resistance of " + body, judge)
    print("%d rows, %d failures, %.0f s" % (len(numbers), bad, time.time() - begin))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
