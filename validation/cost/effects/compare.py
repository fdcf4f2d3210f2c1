"""What effects cost that a scene does not need, and the estimates against the runs."""

import statistics
from results import Results, read

results = Results()
rows = read("data.csv")
seconds = {c: statistics.median(r["seconds"] for r in rows if r["choice"] == c)
           for c in ("auto", "off", "on")}
speed = {c: [r["velocity_m_s"] for r in rows if r["choice"] == c][0] for c in seconds}
charged = statistics.median(r["effects_seconds"] for r in rows if r["choice"] == "on")


def calls(choice, effect):
    """Number of calls in the time breakdown"""
    for line in open(f"breakdown-{choice}"):
        words = line.split()
        if words and words[0] == effect:
            return int(words[2])
    raise SystemExit(f"no {effect} in breakdown-{choice}")


print("choice  processor seconds, median   over off")
for c, s in seconds.items():
    print(f"{c:6s}  {s:24.3f}   {s/seconds['off']:8.4f}")
for effect in "convection", "gravity", "contact", "walls":
    results.add(f"calls of {effect} with auto", calls("auto", effect), "-", 0, 0,
                "time breakdown")
results.add("time with auto over that with off", seconds["auto"]/seconds["off"], "-", 1, "2%",
            "medians of runs in turns")
results.add("velocity of the cell with auto over that with all on", speed["auto"]/speed["on"], "-",
            1, "0.1%",
            "auto changes nothing")
results.add("part of the step without a line in the time breakdown",
            max(r["rest_percent"] for r in rows), "%", 0, 3, "time breakdown")

# The cost of the time breakdown itself: its calls, each with the time breakdownCost measures
price = float(open("breakdown-cost").read())
share = 0
for choice in "auto", "on":
    n = sum(int(words[2])
            for words in (line.split() for line in open(f"breakdown-{choice}").readlines()[2:])
            if len(words) == 5 and words[2].isdigit())
    share = max(share, 100*n*price/seconds[choice])
    print(f"time breakdown, {choice}: {n} calls of {1e9*price:.0f} ns")
results.add("part of the time that the breakdown itself takes", share, "%", 0, 0.5, "calls x price")
extra = seconds["on"] - seconds["off"]
print(f"all on: {extra:.3f} s more than off, of which the time breakdown names {charged:.3f} s in "
      f"{', '.join(('convection', 'gravity', 'contact', 'walls'))}")
for r in read("estimates.csv"):
    if r["case"] == "stretching tutorial":
        print(f"estimate over run, {r['case']}: {r['estimate_s']:.2f} s, {r['run_s']:.2f} s, "
              f"mostly writing")
        continue
    results.add(f"estimate over run: {r['case']}",
                r["estimate_s"]/r["run_s"], "-", 1, "15%", "-estimate")
results.write()
