"""Blood of membranes in shear against the narrow band of bloodViscosity, its change with the mesh,
and the processor time of a red cell beside that of a ring."""

from blood import whole_blood, wide_tubes
from results import QUICK, Results, read

runs = read("data.csv")
results = Results()
H, RATE = 0.3, 200
LOW, HIGH = wide_tubes(H), whole_blood(H, RATE)

# Misses that the README explains, by mesh cell [um]
KNOWN = {1: 2.98602}


def cost(run):
    """Processor time of a red cell and simulated millisecond [s]."""
    return run["seconds"]/run["cells"]/(1e3*run["strain"]/RATE)


for run in runs:
    name = f"{run['kind']}, mesh cells of {run['mesh_um']:g} um"
    if not QUICK:
        known = KNOWN.get(run["mesh_um"]) if run["kind"] == "membrane" else None
        results.add(f"{name}: relative viscosity", run["muRel"], "-", (LOW + HIGH)/2,
                    round((HIGH - LOW)/2, 4), "wide tubes at high shear (Pries) to Quemada", known)
        results.report(f"{name}: standard error", run["muRel_error"], "-", "blocks")
    results.add(f"{name}: outer correctors", run["correctors"], "-", 0, 8, "mean of all steps")
    results.add(f"{name}: cells lost", run["cells"] - run["left"], "-", 0, 0, "none may be")
    results.report(f"{name}: processor time", 1e3*cost(run), "ms per cell and ms", "this machine")
if not QUICK:
    ring = next(run for run in runs if run["kind"] == "ring")
    for run in runs:
        if run["kind"] == "membrane":
            results.report(f"mesh cells of {run['mesh_um']:g} um: time of a membrane over a ring's",
                           cost(run)/cost(ring), "-", "the same box")
results.write()
