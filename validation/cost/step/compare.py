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
one, most = median[(1, "one")], median[(32, "one")]
results.report("time per further red cell and step", 1000*(most - one)/31, "ms",
               "32 red cells less one")
results.write()
