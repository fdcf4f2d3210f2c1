"""Haematocrit and overlaps of the packings against what was asked for."""

from results import Results, read

results = Results()
for row in read("data.csv"):
    results.add(f"{row['case']}: haematocrit", float(row["haematocrit"]), "-", 0.45, 0.01,
                "entry haematocrit; rounded to whole cells")
    results.add(f"{row['case']}: deepest overlap", float(row["deepestOverlap_percent"]),
                "% of the sphere radius", 0, 1e-6, "entry maxOverlap, default 0")
    results.report(f"{row['case']}: processor time", float(row["cpu_s"]), "s", "this machine")
results.write()
