"""Velocity of a settling capsule over that of the bead on the same mesh."""

from results import Results, read

results = Results()
runs = read("data.csv")

# Misses that the README explains, by viscosity ratio and mesh cells per diameter
KNOWN = {(5, 6): 0.886737, (20, 6): 0.770746, (20, 10.8): 0.872482}

for run in runs:
    bead = next(r for r in runs if (r["kind"], r["D_dx"]) == ("bead", run["D_dx"]))
    name = f"{run['kind']}, viscosity ratio {run['ratio']:g}, D/dx {run['D_dx']:g}"
    if run["kind"] == "capsule":
        results.add(f"{name}: velocity over that of a bead",
                    run["velocity_m_s"]/bead["velocity_m_s"], "-", 1, 0.02,
                    "a rigid sphere of the same volume and weight",
                    KNOWN.get((run["ratio"], run["D_dx"])))
    else:
        results.report(f"{name}: velocity", 1e3*run["velocity_m_s"], "mm/s", "the bead")
results.write()
