"""Velocity of a settling capsule over that of the bead on the same mesh."""

from results import Results, read

results = Results()
runs = read("data.csv")

for run in runs:
    bead = next(r for r in runs if r["kind"] == "bead"
                and (r["mesh"], r["D_dx"]) == (run["mesh"], run["D_dx"]))
    name = f"{run['kind']}, viscosity ratio {run['ratio']:g}, D/dx {run['D_dx']:g}"
    if run["mesh"] != "uniform":
        name += f", {run['mesh']}"
    if run["kind"] == "capsule":
        results.add(f"{name}: velocity over that of a bead",
                    run["velocity_m_s"]/bead["velocity_m_s"], "-", 1, 0.02,
                    "a rigid sphere of the same volume and weight")
    else:
        results.report(f"{name}: velocity", 1e3*run["velocity_m_s"], "mm/s", "the bead")
results.write()
