"""Blood in tubes against the fits of Pries et al. (1992) at the tube haematocrit. The runs of the
longest way are compared with the tube; the others, whose cells have not found their places, must
lie between the tube and blood without a wall layer.

The two fits contradict each other in a core of blood within a layer of plasma, which moves with the
velocity of the fluid: with the fitted viscosity its ratio of tube to discharge haematocrit is
HtHd_twofluid of the targets for an even core, and not less than (1 + sqrt(1 - 1/muRel))/2, that of
a rigid one. With the radius x of the core over that of the tube and m = 1 - 1/muRel, the flow is
proportional to 1 - m, the velocity of a rigid core to 2 (1 - x^2), and m = x^4."""

from blood import wide_tubes
from results import Results, find, plt, read, save

runs = read("data.csv")
targets = read(find("reference/tube_targets_pries.csv"))
results = Results()
SOURCE = "Pries, Neuhaus, Gaehtgens 1992, at the tube haematocrit"
ALLOWED = {20: "8%", 10: "10%", 40: "10%"}   # per diameter [um]
ENOUGH = 25         # diameters of way

# Misses that the README explains: (D, H, quantity): value
KNOWN = {(20, 0.1, "HtHd"): 0.729269, (20, 0.2, "HtHd"): 0.794128, (20, 0.3, "HtHd"): 0.81012,
         (20, 0.45, "HtHd"): 0.873437, (10, 0.3, "HtHd"): 0.76653, (40, 0.3, "HtHd"): 0.888782,
         (20, 0.45, "muRel"): 2.18863, (20, 40, "layer"): 0.53585}


def target(run):
    """The row of the diameter and haematocrit, as every table value has one."""
    return next(row for row in targets
                if row["D_um"] == run["D_um"] and abs(row["Ht"] - run["H"]) < 1e-6)


def rigid_core(muRel):
    """Tube over discharge haematocrit of a rigid core in a layer of plasma (see above)."""
    return (1 + (1 - 1/muRel)**0.5)/2


longest = max(run["way_D"] for run in runs)
main = [run for run in runs if run["D_dx"] == 3.2 and run["way_D"] == longest]
for run in main:
    name = f"{run['D_um']:g} um, {100*run['H']:g} %"
    goal = target(run)
    known = {key[2]: value for key, value in KNOWN.items()
             if key[:2] == (run["D_um"], run["H"]) and run["way_D"] >= ENOUGH}
    if run["way_D"] >= ENOUGH:
        results.add(f"{name}: relative viscosity", run["muRel"], "-", goal["mu_rel"],
                    ALLOWED[run["D_um"]], SOURCE, known.get("muRel"))
        results.add(f"{name}: tube over discharge haematocrit", run["HtHd"], "-",
                    goal["Ht_over_Hd"], 0.06, SOURCE, known.get("HtHd"))
        results.add(f"{name}: the same against a core of even haematocrit", run["HtHd"], "-",
                    goal["HtHd_twofluid"], 0.06,
                    "two-fluid model with the viscosity of Pries et al.")
        results.report(f"{name}: the same of a rigid core", rigid_core(goal["mu_rel"]), "-",
                       "least of the two-fluid model with the viscosity of Pries et al.")
    else:
        low, high = goal["mu_rel"], wide_tubes(run["H"])
        results.add(f"{name}, {run['way_D']:g} diameters of way: relative viscosity", run["muRel"],
                    "-", (low + high)/2, round((high - low)/2 + 0.1*high, 4),
                    "between the tube and blood without a wall layer, and 10 %")
        low = goal["Ht_over_Hd"]
        results.add(f"{name}, {run['way_D']:g} diameters of way: tube over discharge haematocrit",
                    run["HtHd"], "-", (low + 1)/2, round((1 - low)/2 + 0.02, 4),
                    "between the tube and an even distribution")
    results.report(f"{name}: standard error of the viscosity", run["muRel_error"], "-", "blocks")
    results.report(f"{name}: cell-free layer", 1e6*run["layer_m"], "um", "cellFreeLayer")
    results.report(f"{name}: plasma layer of the same viscosity", goal["delta_visc_um"], "um",
                   "two-fluid model with the viscosity of Pries et al.")
    results.add(f"{name}: cells lost", run["cells"] - run["left"], "-", 0, 0, "none may be")
    results.add(f"{name}: deepest overlap", run["overlap"], "sphere radii", 0, 0.05,
                "mean over time of the deepest", known.get("overlap"))
    results.report(f"{name}: processor time", run["seconds"]/run["cells"]
                   / (10*run["way_D"]), "s per cell and ms", "this machine")

# Mesh and time step
audits = [run for run in runs if run["way_D"] < longest]
if audits:
    base, half, fine, finest = audits
    results.change("half the time step: change of the viscosity", half, base, "muRel", 0.03)
    results.change("D/dx 4: change of the viscosity", fine, base, "muRel", 0.05)
    results.change("D/dx 6: change of the viscosity", finest, base, "muRel", 0.05)

# The layer is thinner at a higher haematocrit, and thicker in a wider tube
tubes = sorted((run for run in main if run["D_um"] == 20), key=lambda run: run["H"])
for few, many in zip(tubes, tubes[1:]):
    results.add(f"20 um: layer at {100*many['H']:g} % beyond that at {100*few['H']:g} %",
                max(1e6*(many["layer_m"] - few["layer_m"]), 0), "um", 0, 0, "thinner")
order = sorted((run for run in main if run["H"] == 0.3), key=lambda run: run["D_um"])
for thin, wide in zip(order, order[1:]):
    if longest >= ENOUGH:
        results.add(f"30 %: layer in {thin['D_um']:g} um beyond that in {wide['D_um']:g} um",
                    max(1e6*(thin["layer_m"] - wide["layer_m"]), 0), "um", 0, 0,
                    "thicker in the wider", KNOWN.get((thin["D_um"], wide["D_um"], "layer")))

# The Fahraeus-Lindqvist effect
for thin, wide in zip(order, order[1:]):
    results.add(f"viscosity in {thin['D_um']:g} um over that in {wide['D_um']:g} um",
                thin["muRel"]/wide["muRel"], "-", target(thin)["mu_rel"]/target(wide)["mu_rel"],
                0.15, SOURCE)

figure, axes = plt.subplots(1, 2, figsize=(9, 3.8))
rows = [row for row in targets if row["D_um"] == 20]
for panel, key, goal, label in ((axes[0], "muRel", "mu_rel", "relative viscosity"),
                                (axes[1], "HtHd", "Ht_over_Hd", "tube over discharge haematocrit")):
    panel.plot([row["Ht"] for row in rows], [row[goal] for row in rows], "k-", label="Pries 1992")
    panel.errorbar([run["H"] for run in tubes], [run[key] for run in tubes],
                   [run[key + "_error"] for run in tubes], fmt="o", color="C3", label="20 um")
    panel.set_xlabel("tube haematocrit")
    panel.set_ylabel(label)
    panel.legend()
H = [0.05*k for k in range(10)]
axes[0].plot(H, [wide_tubes(h) for h in H], "k--", lw=1, label="large tubes")
axes[0].legend()
save(figure, "bloodTube.png")
results.write()
