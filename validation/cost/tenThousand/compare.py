"""What ten thousand red cells take: memory, and seconds of every program and step."""

from results import Results, read

results = Results()
rows = read("data.csv")
steps = read("steps.csv")
placed = steps[0]["cells"]

for row in rows:
    name = f"{row['program']} on {row['ranks']:g}"
    if row["program"] == "written":
        results.report(f"{name}: a time of the run", row["wall_s"], "s", "at the end")
        continue
    results.report(f"{name}: time", row["wall_s"], "s", "by the clock")
    results.report(f"{name}: memory of the largest rank", row["largestRank_MB"], "MB",
                   "resident, at most")

for ranks in sorted({row["ranks"] for row in steps}):
    own = [row for row in steps if row["ranks"] == ranks]
    solver = next(row for row in rows if row["program"] == "rbcIbFoam" and row["ranks"] == ranks)
    name = f"rbcIbFoam on {ranks:g}"
    seconds = sum(row["wall_s"] for row in own)
    results.report(f"{name}: start", solver["wall_s"] - seconds, "s",
                   "what is not in the steps, with the end")
    results.report(f"{name}: a step", seconds/len(own), "s", f"mean of {len(own)}")
    results.report(f"{name}: outer correctors of a step",
                   sum(row["correctors"] for row in own)/len(own), "-", "mean")
    results.report(f"{name}: memory per red cell", solver["allRanks_MB"]/placed, "MB",
                   "all ranks, with the mesh")
    results.add(f"{name}: red cells left", own[-1]["cells"], "-", placed, 0, "those placed")
results.write()
