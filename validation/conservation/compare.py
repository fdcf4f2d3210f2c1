"""Third law, continuity, agreement of ranks and of the force integrals."""

import math
import re
from statistics import median_high as median
from clumps import table
from results import Results, plt, read, save

BOX = 20e-6


def continuity(case):
    """Mean continuity error of every step, the last of each."""
    steps, error = [], 0
    with open(f"{case}/log.rbcIbFoam") as file:
        for line in file:
            if line.startswith("time step continuity errors"):
                error = float(re.search(r"sum local = (\S+),", line).group(1))
            if line.startswith("Step "):
                steps.append(error)
    return steps


def clumps(case):
    """Force and position of every clump and step."""
    return [[row[c] for c in ("Fx", "Fy", "Fz", "x", "y", "z")]
            for row in table(case, "clumpForce")]


results = Results()
figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4))

for ranks in "124":
    balance = [row["thirdLawError"] for row in table(ranks, "momentumBalance")]
    results.add(f"third law, {ranks} ranks, largest of {len(balance)} steps", max(balance), "", 0,
                "1e-15",
                "Newton: what the clumps gain the fluid loses")
    left.semilogy(range(1, len(balance) + 1), balance,
                  label=f"third law / sum of all forces, ranks: {ranks}")

for case, name in ("none", "a force instead of cells"), ("1", "two cells"):
    left.semilogy(range(1, len(continuity(case)) + 1), continuity(case), ls="--",
                  label=f"mean |div u - dilation| dt, {name}")
# After 75 steps the flow without cells is steady, and its solver has nothing left to do
# With cells the mesh slides, and there may be less to correct in a step
results.add("continuity error, cells over no cells, medians, if above 1",
            max(median(continuity("1"))/median(continuity("none")[:40]), 1),
            "", 1, "30%", "same solvers, a force on one mesh cell instead of the cells")

serial = clumps("1")
size = max(abs(f) for row in serial for f in row[:3])
moved = sum(abs(b[k] - a[k]) > BOX/2 for a, b in zip(serial, serial[2:]) for k in (3, 5))
print(f"periodic boundaries crossed: {moved}")
for ranks in "24":
    other = clumps(ranks)
    force = max(abs(a - b) for r, s in zip(serial, other) for a, b in zip(r[:3], s[:3]))/size

    def apart(a, b):
        d = abs(a - b)
        return min(d, BOX - d)/BOX
    position = max(apart(a, b) for r, s in zip(serial, other) for a, b in zip(r[3:], s[3:]))
    assert len(serial) == len(other)
    results.add(f"force on {ranks} ranks against one", force, "", 0, "1e-10",
                "the same run in serial")
    results.add(f"position on {ranks} ranks against one", position, "", 0, "5e-11",
                "the same run in serial")

# Momentum over the outer iterations: identities hold in every step, the rest goes to zero
terms = read("balance.csv")
for r in terms:
    name = f"{r['domain']}, {r['ranks']:g} ranks, {r['passes']:g} outer iterations"
    print(f"{name}: third law {r['thirdLaw']:.0e}, clumps {r['clumps']:.0e}, fluid "
          f"{r['fluid']:.0e}, "
          f"not received {r['coupling']:.0e}, total {r['total']:.0e}")
    for column in "thirdLaw", "clumps":
        results.add(f"{name}: {column}", r[column], "", 0, "5e-16", "an identity of every step")
most = max(r["passes"] for r in terms)
for r in terms:
    if r["passes"] == most and r["ranks"] == 1:
        first = next(q for q in terms if q["domain"] == r["domain"] and q["passes"] == 1)
        if most == 16:
            for column, limit in ("fluid", "1e-5"), ("coupling", "1e-5"):
                results.add(f"{r['domain']}: {column} after {most:g} outer iterations", r[column],
                            "", 0, limit,
                            "zero when the step is iterated to convergence")
        results.add(f"{r['domain']}: total after {most:g} outer iterations over that after one",
                    r["total"]/first["total"],
                    "", 0, "3e-2" if most == 16 else "0.3",
                    "zero when the step is iterated to convergence")

for r in read("closed.csv"):
    name = f"closed system, {r['passes']:g} outer iterations"
    results.add(f"{name}: mean stream over the fastest clump",
                r["meanVelocity_m_s"]/r["fastest_m_s"], "", 0, "1e-5", "opposite forces")
    results.add(f"{name}: total momentum over the impulse of the forces", r["integralError"], "", 0,
                "1e-12", "opposite forces")
for r in read("start.csv"):
    # Basset's force at short times: 6 a^2 sqrt(pi rho mu/t) on a sphere that starts at once
    radius, rho, mu, time = 1e-3, 1e3, 1e-3, 2e-4
    mass = (r["density_kg_m3"] + 0.5*rho)*4/3*math.pi*radius**3
    lost = 12*radius**2*math.sqrt(math.pi*rho*mu*time)/mass
    ratio = r["density_kg_m3"]/rho
    results.add(f"sphere of {ratio:g} times the density of the fluid, velocity after two steps",
                r["keptVelocity"], "", ratio/(ratio + 0.5)*(1 - lost), "8%",
                "added mass and Basset's force")

data = read("data.csv")
finest = max(r["D_dx"] for r in data)
for integral, mark in ("momentumExchange", "o-"), ("stressDivergence", "s--"):
    rows = [r for r in data if r["force"] == integral]
    right.plot([r["D_dx"] for r in rows], [1e6*r["drag_N_s_m"] for r in rows], mark, label=integral)
for resolution in sorted({r["D_dx"] for r in data}):
    exchange, stress = ([r["drag_N_s_m"] for r in data if r["D_dx"] == resolution
                         and r["force"] == f][0]
                        for f in ("momentumExchange", "stressDivergence"))
    print(f"Eq. 6 over momentum exchange, D/dx {resolution:g}: {stress/exchange:.4f}")
    if resolution == finest:
        results.add(f"Eq. 6 over momentum exchange, D/dx {resolution:g}", stress/exchange, "", 1,
                    "0.1%", "the other force integral")

left.set_xlabel("step")
left.set_ylabel("error of a step")
left.set_ylim(1e-24, None)
left.legend(fontsize=8, loc="lower center")
right.set_xlabel("sphere diameter / mesh cell width")
right.set_ylabel("drag / mean velocity [pN s/um]")
right.legend()
save(figure, "conservation.png")
results.write()
