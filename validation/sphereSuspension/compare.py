"""The viscosity of suspensions of spheres in shear: Einstein's coefficient of one sphere, and
Krieger and Dougherty's equation."""

from math import pi

from results import Results, plt, read, save

runs = read("data.csv")
results = Results()
SPHERE = pi/6*2.95e-6**3        # [m3]
BOX = 30e-6*20e-6*20e-6
EINSTEIN = 2.5
MAXIMUM = 0.64                  # volume fraction of the closest random packing


def krieger_dougherty(fraction):
    return (1 - fraction/MAXIMUM)**(-EINSTEIN*MAXIMUM)


for run in runs:
    run["fraction"] = run["spheres"]*SPHERE/BOX

for run in (run for run in runs if run["spheres"] == 1):
    results.add(f"one sphere, D/dx {run['D_dx']:g}, {run['place_cells']:g} mesh cells off: "
                "intrinsic viscosity", (run["muRel"] - 1)/run["fraction"], "-", EINSTEIN, "5%",
                "Einstein 1911")

crowds = [run for run in runs if run["spheres"] > 1]
for run in crowds:
    percent = round(100*run["fraction"])
    name = f"{percent} %, D/dx {run['D_dx']:g}{', lubrication' if run['film'] else ''}"
    results.add(f"{name}: relative viscosity", run["muRel"], "-",
                krieger_dougherty(run["fraction"]), "10%", "Krieger and Dougherty 1959")
    results.report(f"{name}: standard error", run["muRel_error"], "-", "blocks")
    results.report(f"{name}: share of contacts and films in the stress", run["contact_share"], "-",
                   "contactStress")
    results.report(f"{name}: deepest overlap", run["overlap"], "sphere radii", "contactStress")

figure, axes = plt.subplots()
fraction = [0.005*k for k in range(71)]
axes.plot(fraction, [krieger_dougherty(f) for f in fraction], "k-", label="Krieger, Dougherty 1959")
axes.plot(fraction, [1 + EINSTEIN*f for f in fraction], "k--", lw=1, label="Einstein 1911")
for film, label, marker, colour in (("", "without lubrication", "o", "C0"),
                                    ("film", "with lubrication", "s", "C3")):
    rows = [run for run in crowds if run["film"] == film and run["D_dx"] == 4]
    axes.errorbar([run["fraction"] for run in rows], [run["muRel"] for run in rows],
                  [run["muRel_error"] for run in rows], fmt=marker, color=colour, label=label)
axes.set_xlabel("volume fraction of spheres")
axes.set_ylabel("relative viscosity")
axes.legend()
save(figure, "sphereSuspension.png")
results.write()
