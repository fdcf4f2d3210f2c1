"""Mutates one file of a case at a time and runs it: rbcIbFoam must end by itself, with status 0,
or with status 1 and an error of its own.

    wholeRun.py <folder with cases> <seconds> <first seed> <folder for findings>

A run that takes longer than some seconds gets SIGTERM, as from a batch system, and must then end
with status 0. A floating point exception in the time loop is counted by itself: valid entries may
ask for a flow that no machine can compute, and the run says so.
"""

import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time

cases, seconds, seed, findings = sys.argv[1], float(sys.argv[2]), int(sys.argv[3]), sys.argv[4]
patience = 5*float(os.environ.get("FUZZ_PATIENCE", 1))

# Files that we read, or read more of than OpenFOAM does, by how often they are chosen
read_by_us = [("constant/clumpProperties", 3), ("system/fvSolution", 3), ("system/controlDict", 4),
              ("constant/fvOptions", 3), ("system/fvSchemes", 1), ("constant/g", 1),
              ("constant/transportProperties", 1), ("constant/turbulenceProperties", 1),
              ("0/U", 2), ("0/p", 2), ("1e-06/U", 1), ("1e-06/p", 1), ("1e-06/phi", 1),
              ("1e-06/uniform", 4), ("1e-06/lagrangian", 4), ("0/lagrangian", 3)]

odd = """-1 0 1 2 3 0.5 1e-300 1e-41 1e-6 1e30 1e300 1e999 nan -1e-6 1000000 -2147483648 ( ) { }
    ; () " $types $.. ".*" [0 1 0 0 0 0 0] /* //""".split() + ["(0 0 0)", "#calc", "yes", "no"]


def files_of(case, name):
    path = os.path.join(case, name)
    if os.path.isdir(path):
        return sorted(os.path.relpath(os.path.join(d, f), case)
                      for d, _, fs in os.walk(path) for f in fs)
    return [name] if os.path.isfile(path) else []


def tokens(text):
    return re.findall(rb"\s+|[\w.+-]+|[^\w\s]", text)


class Mutator:
    def __init__(self, names):
        self.pool = [w.encode() for w in odd]
        for name in names:
            with open(name, "rb") as f:
                self.pool += [t for t in tokens(f.read()[:20000]) if t.strip()]

    def token(self, rng, text):
        t = tokens(text)
        if not t:
            return text
        i, j = rng.randrange(len(t)), rng.randrange(len(t))
        kind = rng.randrange(7)
        if kind == 0:
            del t[i]
        elif kind == 1:
            t.insert(i, t[j])
        elif kind == 2:
            t[i] = rng.choice(self.pool)
        elif kind == 3:
            t.insert(i, b" " + rng.choice(self.pool) + b" ")
        elif kind == 4:
            t[i], t[j] = t[j], t[i]
        elif kind == 5:
            del t[i:i + rng.randrange(30)]
        else:
            t[i] += rng.choice(self.pool)
        return b"".join(t)

    def byte(self, rng, text):
        i = rng.randrange(len(text) + 1)
        kind = rng.randrange(4)
        if kind == 0:
            return text[:i] + text[i + 1:]
        if kind == 1:
            return text[:i] + bytes([rng.randrange(256)]) + text[i:]
        if kind == 2:
            return text[:i] + bytes([rng.randrange(256)]) + text[i + 1:]
        return text[:i] if rng.randrange(10) == 0 else text

    def __call__(self, rng, text):
        """One to four changes, seldom in the header."""
        end = text.find(b"}") + 1
        start = end if rng.randrange(20) else 0
        body = text[start:]
        for _ in range(1 + rng.randrange(4)):
            change = self.token if rng.randrange(3) else self.byte
            body = change(rng, body)
        return text[:start] + body


def outcome(case):
    """(kind, log): accepted, refused, trapped, long, or what is wrong."""
    with open(os.path.join(case, "log"), "wb") as log:
        run = subprocess.Popen(["rbcIbFoam"], cwd=case, env=dict(os.environ, PWD=case),
                               stdout=log, stderr=subprocess.STDOUT)
        stopped = False
        try:
            run.wait(patience)
        except subprocess.TimeoutExpired:
            stopped = True
            run.send_signal(signal.SIGTERM)
            try:
                run.wait(2*patience)
            except subprocess.TimeoutExpired:
                run.kill()
                run.wait()
                return "hangs"
    with open(os.path.join(case, "log"), errors="replace") as log:
        said = log.read()
    if "Sanitizer" in said or "runtime error:" in said:
        return "sanitizer"
    if run.returncode == 0:
        return "long" if stopped else "accepted"
    # The second one is of OpenFOAM, on names of files with blanks
    if run.returncode == 1 and ("FOAM FATAL" in said or "this is considered fatal" in said):
        return "refused"
    if run.returncode == -signal.SIGFPE and "floating point exception in the time step" in said:
        return "trapped"
    return f"status {run.returncode}"


def main():
    bases = sorted(os.path.join(cases, c) for c in os.listdir(cases))
    choices = [(base, name) for base in bases for group, weight in read_by_us
               for name in files_of(base, group)
               for _ in range(max(1, 3*weight//max(1, len(files_of(base, group)))))]
    mutate = Mutator({os.path.join(base, name) for base, name in choices})
    counts = {}
    end = time.time() + seconds
    n = seed
    while time.time() < end:
        rng = random.Random(n)
        base, name = rng.choice(choices)
        work = os.path.join(cases, "..", "mutated")
        shutil.rmtree(work, ignore_errors=True)
        shutil.copytree(base, work, symlinks=True)
        with open(os.path.join(work, name), "rb") as f:
            text = f.read()
        with open(os.path.join(work, name), "wb") as f:
            f.write(mutate(rng, text))
        kind = outcome(work)
        counts[kind] = counts.get(kind, 0) + 1
        if kind not in ("accepted", "refused", "trapped", "long"):
            kept = os.path.join(findings, f"log.fuzz.{n}")
            shutil.rmtree(kept, ignore_errors=True)
            shutil.copytree(work, kept)
            print(f"Input {n}, {os.path.basename(base)}/{name}: {kind}, kept in {kept}", flush=True)
        n += 1
    print(f"Whole runs {seed} to {n - 1}: "
          + ", ".join(f"{v} {k}" for k, v in sorted(counts.items())))
    good = sum(counts.get(k, 0) for k in ("accepted", "refused", "trapped", "long"))
    sys.exit(0 if good == n - seed and counts.get("accepted") and counts.get("refused") else 1)


main()
