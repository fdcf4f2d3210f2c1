"""Median time per step of rbcIbFoam over that of pisoFoam."""

import statistics
from results import Results, read

rows = read("data.csv")
median = {n: statistics.median(r["step_s"] for r in rows if r["clumps"] == n)
          for n in {r["clumps"] for r in rows}}
plain = median.pop(0)
results = Results()
for n, seconds in sorted(median.items()):
    results.report(f"time per step with {n:g} red cells over pisoFoam's", seconds/plain, "-",
                   "the same run")
    results.report(f"time per red cell and step, {n:g} red cells", 1000*(seconds - plain)/n, "ms",
                   "the same run")
results.write()
