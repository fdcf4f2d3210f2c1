"""Blood in shear: the relative viscosity lies between that in wide tubes at high shear, without
aggregation (Pries et al. 1992), and the smaller one of two fits to whole blood (Quemada)."""

from blood import fits, whole_blood, wide_tubes
from results import QUICK, Results, plt, read, save

runs = read("data.csv")
results = Results()
RADIUS = 3.8e-6         # of a red cell [m]
UNION = 60.05e-18       # volume of its ten spheres [m3]
VOLUME = 30e-6*20e-6*20e-6  # of the box [m3]

# Misses that the README explains: (H, rate): value
KNOWN = {(0.2, 200): 1.6661, (0.2, 500): 1.65055, (0.3, 200): 2.13242, (0.3, 500): 2.06684}
if QUICK:
    KNOWN = {(0.2, 200): 1.65866, (0.3, 500): 2.08479}      # means over shorter times


def steps(run):
    """Per unit of strain."""
    return round(1/(run["rate"]*run["deltaT_s"]))


main = [run for run in runs if run["D_dx"] == 3.2 and steps(run) == 10]
for run in main:
    name = f"{100*run['H']:g} %, {run['rate']:g} 1/s"
    low, high = wide_tubes(run["H"]), whole_blood(run["H"], run["rate"])
    results.add(f"{name}: relative viscosity", run["muRel"], "-", (low + high)/2,
                round((high - low)/2, 4), "wide tubes at high shear (Pries) to Quemada",
                KNOWN.get((run["H"], run["rate"])))
    results.report(f"{name}: standard error", run["muRel_error"], "-", "blocks")
    results.report(f"{name}: share of the contacts in the stress",
                   run["contact_Pa"]/run["tau_Pa"], "-", "contactStress")
    results.report(f"{name}: diffusion across, over rate and radius squared",
                   run["diffusion_m2_s"]/(run["rate"]*RADIUS**2), "-", "clumps.py diffusion")
    results.add(f"{name}: deepest overlap", run["overlap"], "sphere radii", 0, 0.05,
                "mean over time of the deepest")
    change = 100*(run["phi"]*VOLUME/(run["cells"]*UNION) - 1)
    results.report(f"{name}: change of the mean volume of the spheres' union", change, "%",
                   "cells at rest")
    results.add(f"{name}: loss of that volume", max(-change, 0), "%", 0, 1, "compression resists")
    results.add(f"{name}: cells lost", run["cells"] - run["left"], "-", 0, 0, "none may be")
    results.report(f"{name}: processor time",
                   run["seconds"]/run["cells"]/(1e3*run["strain"]/run["rate"]),
                   "s per cell and ms", "this machine")

for H in sorted({run["H"] for run in main}):
    rates = sorted((run for run in main if run["H"] == H), key=lambda run: run["rate"])
    for slow, fast in zip(rates, rates[1:]):
        thinning = slow["muRel"] - fast["muRel"]
        error = (slow["muRel_error"]**2 + fast["muRel_error"]**2)**0.5
        results.add(f"{100*H:g} %, {slow['rate']:g} to {fast['rate']:g} 1/s: thinning is positive",
                    min(thinning, 0), "-", 0, round(2*error, 4), "shear thinning, two errors")

for name, limit, chosen in (
        ("half the time step", 0.03, lambda run: steps(run) == 20),
        ("D/dx 3", 0.05, lambda run: run["D_dx"] == 3),
        ("D/dx 4", 0.05, lambda run: run["D_dx"] == 4),
        ("D/dx 6", 0.05, lambda run: run["D_dx"] == 6)):
    for run in filter(chosen, runs):
        base = next(other for other in main
                    if other["H"] == run["H"] and other["rate"] == run["rate"])
        results.change(f"{name}: change of the viscosity", run, base, "muRel", limit)

figure, axes = plt.subplots()
for k, H in enumerate(sorted({run["H"] for run in main})):
    rows = [row for row in fits() if row["H"] == H and row["shear_1_per_s"] >= 50]
    rate = [row["shear_1_per_s"] for row in rows]
    axes.fill_between(rate, [wide_tubes(H)]*len(rate), [whole_blood(H, r) for r in rate],
                      color=f"C{k}", alpha=0.2, lw=0)
    own = [run for run in main if run["H"] == H]
    axes.errorbar([run["rate"] for run in own], [run["muRel"] for run in own],
                  [run["muRel_error"] for run in own], fmt="o", color=f"C{k}",
                  label=f"{100*H:g} %")
axes.set_xscale("log")
axes.set_xlabel("shear rate [1/s]")
axes.set_ylabel("relative viscosity")
axes.legend(title="haematocrit")
save(figure, "bloodViscosity.png")
results.write()
