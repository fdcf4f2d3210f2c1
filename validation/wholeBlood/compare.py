"""Blood at low shear rates: with the attraction of red cells in plasma it has a yield stress,
without it none, and at 100 1/s both flow alike. Viscosities are those in the middle half between
the walls, the stress over the shear rate there, and are compared at the haematocrit there with the
correlation of Apostolidis & Beris (2014), and with the yield stress of 17 donors, who have twice as
much."""

import math

import numpy as np
from results import QUICK, Results, find, plt, read, save

PLASMA = 1.2e-3         # viscosity [Pa s]
PLASMA_RINGS = 0.28e-6  # energy per area between rings [J/m2]
FIBRINOGEN = 0.25       # [g/dl], with 2.67 uJ/m2
T = 310.15              # [K]
SCATTER = 0.21          # of the viscosities that the correlation is a fit to
# Misses that the README explains: (rate, steps per strain): value
KNOWN = {(100, 10): 4.88045, (1, 100): 93.7462}
SOURCE = "Apostolidis & Beris 2014 at that haematocrit, to the donors' yield stress"


def casson(H):
    """Yield stress [Pa] and viscosity [Pa s] of the correlation (see reference/yield_stress_*)."""
    cf = FIBRINOGEN
    critical = 0.3126*cf**2 - 0.468*cf + 0.1764
    tau = 0.1*((H - critical)*(0.5084*cf + 0.4517))**2
    mu = 1.67e-3*(1 + 2.0703*H + 3.7222*H**2)*math.exp(-7.0276*(1 - 296.16/T))
    return tau, mu


donors = [d for d in read(find("reference/yield_stress_donors.csv")) if d["outlier"] == "no"]
DONORS = np.mean([d["tau_y_mPa"]/d["tau_y_AB_mPa"] for d in donors])


def viscosity(tau, mu, rate):
    """Of Casson's fluid over that of plasma."""
    return (math.sqrt(tau) + math.sqrt(mu*rate))**2/rate/PLASMA


results = Results()
runs = read("data.csv")
for run in runs:
    name = "H %g, %.2g uJ/m2, %g 1/s, %g steps per strain" % (
        run["H"], 1e6*run["energy_J_m2"], run["rate"], run["steps_per_strain"])
    run["flows"] = run["core_rate"] > 3*run["core_rate_error"]
    results.report(name + ": shear rate in the middle", run["core_rate"], "1/s", "profile")
    results.report(name + ": haematocrit in the middle", run["core_H"], "-", "profile")
    results.report(name + ": stress", 1e3*run["tau_Pa"], "mPa", "walls")
    results.report(name + ": relative viscosity between the walls", run["muRel"], "-", "walls")
    results.report(name + ": its part of contacts", run["contact_Pa"]/run["tau_Pa"], "-",
                   "contactStress")
    tau, mu = casson(run["core_H"])
    if run["flows"]:
        run["core"] = run["tau_Pa"]/run["core_rate"]/PLASMA
        run["core_error"] = run["core"]*math.hypot(run["tau_Pa_error"]/run["tau_Pa"],
                                                   run["core_rate_error"]/run["core_rate"])
        quantity = name + ": relative viscosity in the middle"
        if run["energy_J_m2"] == PLASMA_RINGS and not QUICK:
            low, high = (viscosity(f*tau, mu, run["core_rate"]) for f in (1, DONORS))
            low *= 1 - SCATTER
            results.add(quantity, run["core"], "-", (low + high)/2, round((high - low)/2, 4),
                        SOURCE, KNOWN.get((run["rate"], run["steps_per_strain"])))
        else:
            results.report(quantity, run["core"], "-", SOURCE)
        results.report(quantity + ", standard error", run["core_error"], "-", "blocks")
    else:
        results.add(name + ": stress at which the middle does not flow", 1e3*run["tau_Pa"], "mPa",
                    500*tau, round(500*tau, 4), "below the yield stress of the correlation")
    results.add(name + ": red cells lost", run["cells"] - run["left"], "-", 0, 0, "none may be")
    results.report(name + ": processor time", run["seconds"], "s", "this machine")


def curve(energy, H=0.45, of=runs):
    """Runs over the rate, those with the usual step."""
    found = {run["rate"]: run for run in of if (run["energy_J_m2"], run["H"]) == (energy, H)
             and not (run["rate"] == 1 and run["steps_per_strain"] != 50)}
    return [found[rate] for rate in sorted(found)]


def fit(of):
    """Yield stress [Pa] by Casson's law up to 10 1/s in the middle."""
    slow = [run for run in of if run["flows"] and run["core_rate"] <= 10]
    root = np.polyfit([math.sqrt(run["core_rate"]) for run in slow],
                      [math.sqrt(run["tau_Pa"]) for run in slow], 1)[1]
    return max(root, 0)**2


if not QUICK:
    with_, without = curve(PLASMA_RINGS), curve(0)
    H = np.mean([run["core_H"] for run in with_ if run["rate"] <= 10])
    scale = casson(H)[0]/casson(0.43)[0]
    results.report("haematocrit in the middle, mean of the slow runs", H, "-", "profile")
    results.add("yield stress with attraction over that haematocrit's share", 1e3*fit(with_)/scale,
                "mPa", 7, 2, "donors at H 0.43 and 2.5 g/l", 3.74767)
    results.report("the same of the correlation", 1e3*casson(0.43)[0], "mPa",
                   "Apostolidis & Beris 2014")
    results.add("yield stress without attraction", 1e3*fit(without), "mPa", 0, 1,
                "Merrill et al. 1965: none")
    fast = [next(run for run in of if run["rate"] == 100) for of in (with_, without)]
    results.add("viscosity at 100 1/s with attraction over without",
                fast[0]["muRel"]/fast[1]["muRel"], "-", 1, 0.2, "aggregates are broken")
    half, whole = (next(run for run in runs if (run["H"], run["rate"], run["energy_J_m2"]) ==
                        (0.45, 1, PLASMA_RINGS) and run["steps_per_strain"] == n)
                   for n in (100, 50))
    results.add("half the step at 1 1/s: stress", half["tau_Pa"]/whole["tau_Pa"], "-", 1, 0.1,
                "the longer step")

figure, axes = plt.subplots()
rates = np.logspace(-1.5, 2.5)
for H, shade in ((0.45, "0.8"), (0.53, "0.9")):
    tau, mu = casson(H)
    axes.fill_between(rates, [viscosity(tau, mu, r) for r in rates],
                      [viscosity(DONORS*tau, mu, r) for r in rates], color=shade, lw=0,
                      label=f"correlation to donors, H {H}")
for energy, label in ((PLASMA_RINGS, "with attraction"), (0, "without")):
    own = [run for run in runs
           if (run["H"], run["energy_J_m2"], run["flows"]) == (0.45, energy, True)]
    axes.errorbar([run["core_rate"] for run in own], [run["core"] for run in own],
                  [run["core_error"] for run in own], fmt="o", label=label)
delaware = read(find("reference/viscosity_delaware_sample.csv"))
axes.plot([r["shear_1_per_s"] for r in delaware], [r["mu_Pa_s"]/PLASMA for r in delaware], ":",
          color="0.4", label="one sample (Delaware)")
axes.set_xscale("log")
axes.set_yscale("log")
axes.set_xlabel("shear rate in the middle [1/s]")
axes.set_ylabel("relative viscosity")
axes.legend()
save(figure, "wholeBlood.png")
results.write()
