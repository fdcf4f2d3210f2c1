"""None is lost: what has entered is inside or has left, and a run that was killed counts as the
uninterrupted one does."""

from results import Results, read

results = Results()
data = read("data.csv")
runs = {name: {r["time_s"]: r for r in data if r["run"] == name} for name in ("whole", "restarted")}

for name, rows in runs.items():
    results.add(f"{name}: largest difference of entered and inside + left, at {len(rows)} times",
                max(abs(r["entered"] - r["inside"] - r["left"]) for r in rows.values()),
                "clumps", 0, 0, "none is lost")

results.add("times at which the restarted run wrote, of those of the whole run",
            len(set(runs["whole"]) & set(runs["restarted"])), "", len(runs["whole"]), 0,
            "the same times")

# Until red cells that meet have amplified the rounding of sums over processors
certain = 0.5
last = runs["whole"][max(runs["whole"])]
for what in "entered", "left":
    off = {t: abs(r[what] - runs["whole"].get(t, r)[what]) for t, r in runs["restarted"].items()}
    results.add(f"{what}, restarted against whole: largest difference up to {certain:g} s",
                max(n for t, n in off.items() if t < 1.001*certain), "clumps", 0, 0,
                "the whole run")
    results.add(f"{what}, restarted against whole: largest difference at any time",
                max(off.values())/last["entered"], "of all", 0, 0.02, "the whole run")

results.report("entered in the whole run", last["entered"], "clumps", "this run")
results.report("left in the whole run", last["left"], "clumps", "this run")
results.write()
