"""Time per clump and step of the parts, median of the rounds, and how it grows; time per cell and
simulated millisecond over the haematocrit."""

import os
import statistics
from results import Results, at_one_speed, read

rows = read("data.csv")
results = Results()


def cost(name, number, per):
    return statistics.median(r[name]/r[per] for r in rows if r["number"] == number)


numbers = sorted({r["number"] for r in rows})
for name in "solid fraction", "force integral", "ghosts", "clumps":
    for number in numbers:
        results.report(f"{name}, {number:g} red cells: per red cell and step",
                       cost(name, number, "number")/1000, "ms", "time breakdown")
for number in numbers:
    results.report(f"flow, {number:g} red cells: per mesh cell and step",
                   cost("flow", number, "cells"), "us", "time breakdown")

STEP = 0.5      # ms
SPHERES = 10            # of a red cell
MESH_CELLS = 41*27*27   # of the shear box
runs = read("haematocrits.csv")
at_one_speed(runs, "cpu_ms_per_step")
dense = [row for row in runs if row["type"] == "healthy"]
results.report("unit case", dense[0]["unit_s"], "s", "how fast the machine is")
for row in dense:
    name = f"haematocrit {100*row['haematocrit']:g} %"
    results.report(f"{name}: processor time per cell and simulated ms",
                   row["cpu_ms_per_step"]/row["cells"]/STEP, "ms", "ExecutionTime")
    results.report(f"{name}: outer correctors", row["correctors"], "-", "mean")
    for key, value in row.items():
        if key.endswith("_percent"):
            results.report(f"{name}: share of {key[:-8]}", value, "%", "time breakdown")
    # What decomposePar's weights are made of (clumpWork)
    clumps = sum(row[f"{part}_percent"] for part in
                 ("solid fraction", "force integral", "clumps", "contact", "walls"))
    results.report(f"{name}: work of a sphere in mesh cells",
                   clumps/(row["cells"]*SPHERES)/(row["flow_percent"]/MESH_CELLS), "-",
                   "time breakdown")
for other in runs:
    if other["type"] != "healthy":
        own = next(row for row in dense if row["haematocrit"] == other["haematocrit"])
        ratio = own["cpu_ms_per_step"]/own["cells"]/(other["cpu_ms_per_step"]/other["cells"])
        name = f"haematocrit {100*own['haematocrit']:g} %, {other['type']}"
        results.report(f"{name}: outer correctors", other["correctors"], "-", "mean")
        results.report(f"{name}: time of healthy over its, per red cell", ratio, "-",
                       "ExecutionTime, the same mesh")
few, many = dense[0], dense[-1]
results.report("memory per cell", 1024*(many["memory_MB"] - few["memory_MB"])
               / (many["cells"] - few["cells"]), "kB", "largest resident set, same mesh")

# With red cells minus without, so that the flow's own messages fall out
rows = read("messages.csv")
with_cells = {row["ranks"]: row for row in rows if row["red_cells"] == "yes"}
without = {row["ranks"]: row for row in rows if row["red_cells"] == "no"}
for ranks, row in with_cells.items():
    results.add(f"{ranks:g} ranks: linear iterations of a step, with red cells against without",
                row["linear_iterations"] - without[ranks]["linear_iterations"], "-", 0, 0,
                "three per solution")
for key, unit, scale in ("messages", "-", 1), ("bytes", "kB", 1e-3), ("collectives", "-", 1):
    for ranks in sorted(with_cells):
        results.report(f"{ranks:g} ranks with 24 red cells each: {key} of a rank and step for them",
                       scale*(with_cells[ranks][key] - without[ranks][key]), unit,
                       "calls of MPI, busiest rank")

rows = read("speedUp.csv")
for number in sorted({row["number"] for row in rows}):
    rounds = [row for row in rows if row["number"] == number]
    for name, factor, key in (("speed-up on two ranks", 1, "two_ranks_s"),
                              ("two runs at once, together", 2, "beside_another_s")):
        results.report(f"{number:g} red cells: {name}",
                       statistics.median(factor*row["one_s"]/row[key] for row in rounds), "-",
                       "times one run alone, time breakdown")

if os.path.exists("thousand.csv"):
    one, two = read("thousand.csv")
    results.report("1000 red cells: start-up and first step", one["first_step_s"], "s", "ClockTime")
    for ranks, row in ("one rank", one), ("two ranks", two):
        results.report(f"1000 red cells, {ranks}: a step", row["step_s"], "s", "ClockTime")
        results.report(f"1000 red cells, {ranks}: memory", row["memory_MB"], "MB",
                       "largest resident sets")
results.write()
