"""Median time per step of rbcIbFoam over that of pisoFoam."""

import statistics
from results import Results, read

rows = read("data.csv")
runs = {(r["clumps"], r["correctors"]) for r in rows}
median = {(n, kind): statistics.median(r["step_s"] for r in rows
                                       if (r["clumps"], r["correctors"]) == (n, kind))
          for n, kind in runs}
plain = median.pop((0, "one"))
results = Results()
KINDS = {"one": "", "uncarried": ", without carryPressure", "iterated": ", default correctors"}
for (n, kind), seconds in sorted(median.items()):
    name = f"{n:g} red cells{KINDS[kind]}"
    results.report(f"time per step with {name} over pisoFoam's", seconds/plain, "-",
                   "the same run")
    if kind == "one":
        results.report(f"time per red cell and step, {name}", 1000*(seconds - plain)/n, "ms",
                       "the same run")
results.write()
