"""Blood of membranes in shear against the narrow band of bloodViscosity, and in a tube against the
fits of Pries et al. (1992), beside rings in the same box; the processor time of a red cell."""

from blood import whole_blood, wide_tubes
from results import QUICK, Results, find, read

runs = read("data.csv")
results = Results()
RATE, DIAMETER, PER_SECOND = 200, 20, 100    # shear [1/s]; tube [um], way in diameters per second
FITS = "Pries, Neuhaus, Gaehtgens 1992, at the tube haematocrit"

# Misses that the README explains, by flow, kind, haematocrit, mesh cell [um] and quantity
KNOWN = {("shear", "membrane", 0.3, 1, "muRel"): 2.98602}


def key(run):
    """What a run is known by."""
    return run["flow"], run["kind"], run["H"], run["mesh_um"]


def cost(run):
    """Processor time of a red cell and simulated millisecond [s]."""
    time = run["length"]/(RATE if run["flow"] == "shear" else PER_SECOND)
    return run["seconds"]/run["cells"]/(1e3*time)


def compare(name, run):
    """Viscosity and, in a tube, the ratio of haematocrits beside those of blood."""
    if run["flow"] == "shear":
        low, high = wide_tubes(run["H"]), whole_blood(run["H"], RATE)
        results.add(f"{name}: relative viscosity", run["muRel"], "-", (low + high)/2,
                    round((high - low)/2, 4), "wide tubes at high shear (Pries) to Quemada",
                    KNOWN.get((*key(run), "muRel")))
    else:
        goal = next(row for row in read(find("../bloodTube/reference/tube_targets_pries.csv"))
                    if row["D_um"] == DIAMETER and abs(row["Ht"] - run["H"]) < 1e-6)
        results.add(f"{name}: relative viscosity", run["muRel"], "-", goal["mu_rel"], "10%", FITS,
                    KNOWN.get((*key(run), "muRel")))
        results.add(f"{name}: tube over discharge haematocrit", run["HtHd"], "-",
                    goal["Ht_over_Hd"], 0.05, FITS, KNOWN.get((*key(run), "HtHd")))
        results.report(f"{name}: cell-free layer", 1e6*run["layer_m"], "um", "cellFreeLayer")
    results.report(f"{name}: standard error", run["muRel_error"], "-", "blocks")


for run in runs:
    name = f"{run['flow']}, {100*run['H']:g} %, {run['kind']}, mesh cells of {run['mesh_um']:g} um"
    if not QUICK:
        compare(name, run)
    results.add(f"{name}: outer correctors", run["correctors"], "-", 0, 8, "mean of all steps")
    results.add(f"{name}: cells lost", run["cells"] - run["left"], "-", 0, 0, "none may be")
    results.report(f"{name}: processor time", 1e3*cost(run), "ms per cell and ms", "this machine")
    ring = [other for other in runs if key(other)[:3] == (run["flow"], "ring", run["H"])]
    if ring and run["kind"] == "membrane":
        results.report(f"{name}: time of a membrane over a ring's", cost(run)/cost(ring[0]), "-",
                       "the same box")
results.write()
