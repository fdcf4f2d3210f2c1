"""What holds in every scene, whatever its features."""

import os
import re

import numpy as np

import solutes
from clumps import table
from features import BODIES, END, FEATURES, FLIGHT, LENGTHS, OFFSET, RADIUS, SPEED, Scene
from known import KNOWN


def rows(case, name):
    """A table of a case; empty where it was not written"""
    folder = os.path.join(case, "postProcessing", name)
    return table(case, name) if os.path.isdir(folder) else []


def column(data, *names):
    return np.array([[row[name] for name in names] for row in data], dtype=float)


def peak(case):
    """Largest velocity of the fluid in each step"""
    path = os.path.join(case, "postProcessing", "peak")
    lines = [line for start in sorted(os.listdir(path), key=float)
             for line in open(os.path.join(path, start, "fieldMinMax.dat"))]
    names = [name.strip() for name in lines[1].split("\t")]
    return np.array([float(line.split("\t")[names.index("max")])
                     for line in lines if line[0] != "#"])


def correctors(case):
    """Numbers of outer correctors by the name of the time"""
    with open(os.path.join(case, "log.rbcIbFoam")) as file:
        return dict(re.findall(r"^Time = (\S+)$.*?^Outer correctors: (\d+)", file.read(),
                               re.M | re.S))


AREA = LENGTHS[1]*LENGTHS[2]*1e-12


class Judge:
    def __init__(self, scene):
        self.scene, self.row, self.density = scene, scene.row, scene.density
        self.findings, self.known, self.all = [], [], []
        self.volume = np.prod(LENGTHS)*1e-18
        self.rho, self.drag = scene.rho, scene.drag()
        self.gravity = (self.row["gravity"] == "on")*np.array(scene.gravity)
        weight = np.abs(self.weight(3)).sum()
        # The speeds that the scene is driven with: streams, pulled and heavy spheres, and the
        # stream of a weight that nothing holds
        driven = self.row["driving"] in ("gradient", "movingWall", "inlet")
        flight = max(np.linalg.norm(velocity) for _, velocity in scene.starts)
        if flight > 0:
            # In a gas, in which they do not reach the speed at which it carries their weight
            self.speed = SPEED*driven + flight + np.linalg.norm(self.gravity)*END
            return
        self.speed = SPEED*driven + scene.pull/self.drag + weight/self.drag
        if self.row["boundaries"] == "periodic":
            self.speed += weight*END/(self.rho*self.volume)

    def weight(self, spheres):
        """Weight less buoyancy of a number of spheres [N]"""
        return spheres*4/3*np.pi*RADIUS**3*(self.density - self.rho)*self.gravity

    def body(self, type_):
        """And whether it is whole; small spheres that enter have a type of their own"""
        name, *piece = type_.split(".")
        return dict(self.scene.types).get(name, "sphere"), not piece

    def check(self, name, value, limit, note=""):
        text = "%s: %.3g, limit %.3g %s" % (name, value, limit, note)
        self.all.append(text)
        if not value <= limit:          # nan, too
            known = any(name.startswith(check) and value <= most and
                        all(self.row[factor] in levels for factor, levels in where.items())
                        for where, check, most, _ in KNOWN)
            (self.known if known else self.findings).append(text)

    def fail(self, text):
        self.findings.append(text)

    def run(self, case):
        """Invariants of one run"""
        self.log(case)
        force, shape = rows(case, "clumpForce"), rows(case, "clumpShape")
        self.bounded(case, force)
        self.fluxes(case)
        self.balance(case)
        self.count(case, force)
        self.volumes(shape)
        self.pulled(shape)
        self.unturned(shape)
        self.rebound(force)
        self.momentum(case, force, shape)
        if solutes.possible(self.scene):
            solutes.judge(self.check, case)

    def log(self, case):
        """Neither the watchdog nor the coupling complains. The coarse mesh and the weight across
        the plane of symmetry are ours; and OpenFOAM takes a particle that rounding leaves on a
        face of cyclicAMI for one outside, and puts it inside"""
        own = ["accuracyLevel", "across the plane of symmetry", "crossed between cyclicAMI"]
        with open(os.path.join(case, "log.rbcIbFoam")) as file:
            text = file.read()
        said = [part.split("\n\n")[0] for part in text.split("--> FOAM Warning :")[1:]]
        said = [part for part in said
                if not any(words in part for words in own)]
        self.check("warnings", len(said), 0, " ".join(" ".join(said).split())[:300])

    def bounded(self, case, force):
        self.check("fluid over driving speed", peak(case).max()/self.speed, 5)
        clumps = np.linalg.norm(column(force, "Ux", "Uy", "Uz"), axis=1)
        self.check("clump over driving speed", clumps.max()/self.speed, 5)

    def fluxes(self, case):
        """What flows in flows out, and meanVelocityGradient reaches its mean"""
        flux = np.array([column(rows(case, "flux_" + side), "sum(phi)")[:, 0]
                         for side, kind in self.scene.patches.items() if kind == "patch"])
        if len(flux):
            size = np.maximum(np.abs(flux).sum(axis=0), 1e-3*self.speed*AREA)
            self.check("net flux over flux", np.abs(flux.sum(axis=0)/size).max(), 1e-6)
        if self.row["driving"] in ("gradient", "noMean"):
            mean = column(rows(case, "mean"), "volAverage(U) x")[:, 0]
            wanted = SPEED*(self.row["driving"] == "gradient")
            self.check("mean velocity less Ubar, over the driving speed",
                       np.abs(mean - wanted).max()/self.speed, 1e-6)

    def balance(self, case):
        """momentumBalance, which holds on a static mesh"""
        if self.row["mesh"] == "refined":
            return
        data = rows(case, "momentumBalance")
        for name in "thirdLawError", "clumpsError":
            self.check(name, column(data, name).max(), 1e-12)
        # The rest converges with the outer correctors, for a Newtonian fluid
        if self.row["outer"] == "tolerance" and self.row["viscosity"] == "Newtonian":
            self.check("totalError", column(data, "totalError").max(), 0.05)

    def count(self, case, force):
        """placed + entered = inside + left; only open patches let clumps out"""
        part = case if self.row["ranks"] == "1" else os.path.join(case, "processor0")
        last = max((name for name in os.listdir(part) if name[0].isdigit()), key=float)
        self.check("end time missed by", abs(float(last) - END)/END, 1e-6)
        with open(os.path.join(part, last, "uniform", "clumpsCount")) as file:
            text = file.read()

        def number(entry):
            return sum(map(int, re.findall(r"\b%s\s+(\d+);" % entry, text)))

        def numbers(group):
            block = re.search(r"^%s\n\{(.*?)^\}" % group, text, re.S | re.M)
            return sum(map(int, re.findall(r"\s(\d+);", block.group(1)))) if block else 0
        placed, entered, left = number("placed"), numbers("entered"), numbers("left")
        broken = number("brokenOff")
        inside = sum(abs(row["time"]/END - 1) < 1e-6 for row in force)
        self.check("clumps missing", abs(placed + entered + broken - left - inside), 0,
                   f"{placed} placed, {entered} entered, {broken} broken off, {left} left, "
                   f"{inside} inside")
        self.check("clumps placed, difference", abs(placed - len(self.scene.starts)), 0)
        # More viscous liquids, and locked interiors, carry more of what pulls on the bonds; a rod
        # that bounces breaks at a wall, unless a film stops it
        strained = self.row["bodies"] != "bouncing" or (
            self.row["boundaries"] != "periodic"
            and self.row["contact"] not in ("off", "lubricated"))
        if self.row["bonds"] == "whole":
            self.check("pieces of bonds that cannot break", broken, 0)
        elif self.row["viscosity"] == "Newtonian" and self.row["dilation"] == "yes" and strained:
            self.check("bonds that did not break", not rows(case, "brokenBonds"), 0)
        if "patch" not in self.scene.patches.values():
            self.check("clumps that left without an open patch", left, 0)
        if self.row["injection"] == "again":
            self.check("clumps that entered but had not left", entered - left, 0)
        elif self.row["injection"] != "no":
            self.check("clumps that did not enter", entered == 0, 0)

    def volumes(self, shape):
        """Constant of spheres; what is conserved within 1 %; of other shapes within a half"""
        first, worst = {}, {}
        for row in shape:
            body, whole = self.body(row["type"])
            model = (BODIES[body][4] + ";").split(";")[0]*(
                whole and self.row["conservation"] == "one")
            kind, limit = ("volume of spheres", 1e-6) if body == "sphere" else \
                ("volume of membranes", 1e-6) if body in ("capsule", "solid") else \
                ("conserved volume", 0.01) if model == "unionVolume" else \
                ("conserved area", 0.01) if model == "enclosedArea" else ("volume", 0.5)
            value = row["area" if "area" in kind else "volume"]
            change = abs(value/first.setdefault((row["clump"], row["type"]), value) - 1)
            worst[kind, limit] = max(worst.get((kind, limit), 0), change)
        for (kind, limit), value in worst.items():
            self.check("change of the " + kind, value, limit)

    def pulled(self, shape):
        """The drag of the fluid slows a body that is pulled apart: in a fluid at rest its ends
        move apart no faster than three times as two free spheres"""
        if self.row["driving"] not in ("none", "noMean") or not self.scene.pull:
            return
        before, fastest = {}, 0
        for row in shape:
            key = row["clump"], row["type"]
            if key in before and row["L1"] > 1.5*row["L3"]:
                time, length = before[key]
                fastest = max(fastest, (row["L1"] - length)/(row["time"] - time))
            before[key] = row["time"], row["L1"]
        self.check("elongation over that of free spheres",
                   fastest/(2*self.scene.pull/self.drag), 3)

    def unturned(self, shape):
        """Neither the fluid nor contact turns a sphere where rotation is off; friction and the
        bonds of surfaces do"""
        if self.row["rotation"] != "off" or self.row["contact"] in ("rough", "bonded"):
            return
        omega = column([row for row in shape if self.body(row["type"]) == ("sphere", True)
                        and row["type"] != "mover"],
                       "omegax", "omegay", "omegaz")
        self.check("rotation of spheres over the driving speed over their radius",
                   np.abs(omega).max(initial=0)*RADIUS/self.speed, 1e-12)

    def rebound(self, force):
        """The two spheres that meet in a gas part with the restitution of their contact"""
        if self.row["bodies"] != "bouncing" or self.row["contact"] == "off" or \
                self.row["viscosity"] != "Newtonian":
            return
        across = OFFSET*1e-6/(2*RADIUS)
        along = np.array([np.sqrt(1 - across**2), across, 0])
        left, right = (column([row for row in force if row["type"] == name], "Ux", "Uy", "Uz")
                       for name in ("left", "right"))
        n = min(len(left), len(right))
        speeds = (right[:n] - left[:n]) @ along
        # A step may end while they touch; the walls are more than two steps away
        turned = np.argmax(speeds > 0)
        parting = speeds[turned:turned + 3].max()
        # 2 % of the contact, and what the gas takes up in two of the longest steps, with twice the
        # drag of single spheres
        taken = 2*2*1.3e-4*self.drag/(4/3*np.pi*RADIUS**3*self.density)
        self.check("restitution less 0.5", abs(parting/(2*FLIGHT*along[0]) - 0.5),
                   0.5*(0.02 + taken))

    def momentum(self, case, force, shape):
        """Of a periodic box: the impulse of the weights, to 0.1 % of that of all forces"""
        if self.row["boundaries"] != "periodic" or self.row["driving"] != "none" \
                or self.row["injection"] != "no":
            return
        volume = {}
        for row in shape:
            volume.setdefault((row["clump"], row["type"]), row["volume"])
        first = {key: value for key, value in volume.items() if key in {
            (row["clump"], row["type"]) for row in shape if row["time"] == shape[0]["time"]}}
        # The solver's volume of a union that deforms, and with it the buoyancy, is within 0.1 %
        exact = self.row["bodies"] in ("spheres", "capsules", "solids")
        size = len(self.scene.starts)*self.scene.pull + sum(first.values())*abs(
            self.density - exact*self.rho)*np.linalg.norm(self.gravity)
        velocities = dict(self.scene.starts)
        starts = np.array([value*(self.density - self.rho)*np.array(
            velocities[type_.split(".")[0]]) for (_, type_), value in first.items()])
        start, moving = starts.sum(axis=0), np.linalg.norm(starts, axis=1).sum()
        with open(os.path.join(case, "log.rbcIbFoam")) as file:
            atRest = self.volume*float(re.search(r"fraction of the clumps\D* (\S+)",
                                                 file.read()).group(1))
        impulse, before, worst, present = np.zeros(3), 0, 0, atRest
        for row in rows(case, "mean"):
            if self.gravity.any():
                # The mass is that of the volume at rest, the buoyancy that of the one at the
                # start of the step
                impulse += (row["time"] - before)*self.gravity*(
                    self.density*atRest - self.rho*present)
                if self.row["bodies"] != "spheres":
                    present = sum(r["volume"] for r in shape
                                  if abs(r["time"] - row["time"]) < 1e-9)
            before = row["time"]
            total = self.rho*self.volume*np.array([row["volAverage(U) " + c] for c in "xyz"])
            for clump in (r for r in force if abs(r["time"] - row["time"]) < 1e-9):
                total += volume[clump["clump"], clump["type"]]*(self.density - self.rho)*column(
                    [clump], "Ux", "Uy", "Uz")[0]
            worst = max(worst, np.linalg.norm(total - start - impulse)/(
                size*row["time"] + moving))
        self.check("momentum less impulse, over the impulse of all forces", worst, 1e-3)

    def differences(self, one, other):
        """Largest differences between the tables of two runs, over their scales and limits"""
        # The momentum equation is iterated to 1e-3 where a viscosity is inside membranes
        limit = 1e-4 if self.row["bodies"] in (
            "capsules", "capsuleAndRing", "solids") else 1e-6
        # Round-off may decide on another outer corrector; from then on they differ by the tolerance
        ones, others = correctors(one), correctors(other)
        until = min((float(time) for time, n in others.items() if ones.get(time, n) != n),
                    default=2*END)
        result = {}

        def compare(a, b, names, scale, limit, what):
            if len(a):
                result[what] = np.abs(column(a, *names) - column(b, *names)).max()/scale/limit

        scales = {"clumpForce": (("x", "y", "z"), RADIUS, ("Ux", "Uy", "Uz"), self.speed),
                  "clumpShape": (("L1", "L2", "L3"), RADIUS,
                                 ("omegax", "omegay", "omegaz"), self.speed/RADIUS),
                  "mean": (["volAverage(U) " + c for c in "xyz"], self.speed)}
        for name, pairs in scales.items():
            a, b = self.common(rows(one, name), rows(other, name), until)
            for names, scale in zip(pairs[::2], pairs[1::2]):
                compare(a, b, names, scale, limit, name + " " + names[0])
        a, b = self.common(rows(one, "clumpForce"), rows(other, "clumpForce"), until)
        if a:
            # The forces on the nodes of a capsule add up to round-off
            size = max(np.abs(column(a, "Fx", "Fy", "Fz")).max(), self.drag*self.speed)
            compare(a, b, ("Fx", "Fy", "Fz"), size, 10*limit, "force")
        # Of a restart there are the later steps only
        times = [[row["time"] for row in rows(case, "mean")] for case in (one, other)]
        first = times[1][0]*(1 - 1e-6)
        result["steps"] = abs(sum(time > first for time in times[0]) - len(times[1]))
        n = sum(time < until for time in times[1])
        if n and not result["steps"]:
            a, b = peak(one)[-len(times[1]):], peak(other)
            result["largest velocity"] = np.abs(a - b)[:n].max()/self.speed/limit
        return result

    def common(self, a, b, until):
        """Rows of the same times and clumps, from the first time of b to where they part"""
        a, b = ([row for row in data if b[0]["time"]*(1 - 1e-6) < row["time"] < until]
                for data in (a, b))
        keys = [[(row["time"], row.get("clump")) for row in data] for data in (a, b)]
        n = next((i for i, (k, l) in enumerate(zip(*keys)) if k != l), min(map(len, keys)))
        return a[:n], b[:n]

    def agree(self, name, one, other, nudged):
        """Two runs agree, or differ no more than tenfold what one of them does from another
        that starts a billionth of a radius away (nudged, run where that is asked)"""
        apart = self.differences(one, other)
        moved = self.differences(one, nudged()) if max(apart.values()) > 1 else {}
        # Steps that adjust may differ in number where velocities do
        if max(moved.values(), default=0) > 1:
            moved["steps"] = np.inf
        for what, value in apart.items():
            self.check(f"{name}: {what}", value, max(1, 10*moved.get(what, 0)))


def resistance(folder, bodies, Case):
    """The resistance matrix of a body: symmetric, positive definite, also when pulled apart. Its
    columns take the same steps where those of the case adjust"""
    for body in bodies:
        row = {factor: next(iter(levels)) for factor, levels in FEATURES.items()}
        scene = Scene(dict(row, bodies=body, outer="3", step="adjustable"), withSolutes=False)
        case = Case(os.path.join(folder, body), 1).write(scene)
        case.run("clumpResistance", "0", "-steps", "5")
        judge = Judge(scene)
        R = np.loadtxt(case.path("resistance.csv"), delimiter=",")/judge.drag
        judge.check("asymmetry", np.abs(R - R.T).max()/np.abs(R).max(), 1e-3)
        low = np.linalg.eigvalsh(0.5*(R + R.T))[0]
        judge.check("1 over the smallest eigenvalue/(6 pi mu r)", 1/max(low, 1e-30), 100)
        _, _, plus, minus, _ = BODIES.get(body, BODIES["sphere"])
        if plus:
            apart = np.zeros(len(R))
            apart[3*plus[0]], apart[3*minus[0]] = np.sqrt(0.5), -np.sqrt(0.5)
            judge.check("1 over the drag/(6 pi mu r) of ends pulled apart",
                        1/max(apart @ R @ apart, 1e-30), 10)
        yield body, judge
