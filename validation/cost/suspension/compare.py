"""Time per clump and step of the parts, median of the rounds, and how it grows."""

import statistics
from results import Results, read

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
results.write()
