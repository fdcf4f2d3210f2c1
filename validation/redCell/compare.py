"""A red cell that is stretched, let go, tank-treads, tumbles and passes a tube, against
measurements.

The recovery of length over width r from r_m to r_inf is that of Hochmuth et al. with one relaxation
time t_c, r(t) = r_inf (L + exp(-t/t_c))/(L - exp(-t/t_c)), L = (r_m + r_inf)/(r_m - r_inf)."""

from math import exp

from results import QUICK, Results, find, plt, read, save

MILLS = "Mills et al. 2004, within the error bars (reference/mills2004_healthy_stretch.csv)"
FISCHER = "Fischer, mean of 12 donors at 28.9 mPa s (reference/tankTreading_fischer.csv)"
TST = "Tran-Son-Tay et al. 1984, 35 mPa s (reference/tankTreading_tranSonTay1984.csv)"

HOCHMUTH = "Hochmuth, Worthy, Evans 1979, mean of two cells (creep/reference)"
FISCHER_KORZENIEWSKI = "Fischer and Korzeniewski 2013 (reference/tt_tb_threshold.csv)"

# Recorded misses
KNOWN = {("f", 8.21, 162): 0.04896, ("f", 8.21, 642): 0.04678, ("t_c", 0.42): 0.086,
         ("turns", 12, 162): 0.838889}

results = Results()
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4))

measured = read("reference/mills2004_healthy_stretch.csv")
runs = {}
for r in read("stretch.csv"):
    runs.setdefault((r["strain"], int(r["subdivisions"])), []).append(r)


def at(force, column):
    """A measured column at a force, between the nearest ones."""
    rows = [(m["force_pN"], m[column]) for m in measured]
    for (f0, v0), (f1, v1) in zip(rows, rows[1:]):
        if f0 <= force <= f1:
            return v0 + (v1 - v0)*(force - f0)/(f1 - f0)
    return rows[-1][1]


for (strain, subdivisions), rows in runs.items():
    nodes = 10*4**subdivisions + 2
    for r in rows:
        for kind in ("axial", "transverse"):
            name = f"{kind} diameter at {r['force_pN']:g} pN, {strain}, {nodes} nodes"
            bar = 0.5*(at(r["force_pN"], kind + "_hi") - at(r["force_pN"], kind + "_lo"))
            results.add(name, r[kind + "_um"], "um", at(r["force_pN"], kind + "_um"),
                        round(bar, 3), MILLS, KNOWN.get((strain, kind, r["force_pN"])))
    results.add(f"volume, stretched, {strain}, {nodes} nodes", rows[-1]["volume"], "-", 1, 1e-6,
                "volume at rest")
    for kind in ("axial", "transverse"):
        left.plot([0] + [r["force_pN"] for r in rows], [7.82] + [r[kind + "_um"] for r in rows],
                  ".-", label=f"{strain}, {kind}")
for kind in ("axial", "transverse"):
    low = [m[kind + "_um"] - m[kind + "_lo"] for m in measured]
    high = [m[kind + "_hi"] - m[kind + "_um"] for m in measured]
    left.errorbar([m["force_pN"] for m in measured], [m[kind + "_um"] for m in measured],
                  [low, high], fmt="k.", capsize=2, lw=0.7)
left.set_xlabel("force [pN]")
left.set_ylabel("diameter [um]")
left.legend(fontsize=7)



def relaxation(times, ratios):
    """t_c [s] and r_inf of least squares, on a grid."""
    r_m = ratios[0]

    def misfit(t_c, r_inf):
        L = (r_m + r_inf)/(r_m - r_inf)
        return sum((r_inf*(L + exp(-t/t_c))/(L - exp(-t/t_c)) - r)**2
                   for t, r in zip(times, ratios))

    grid = [(0.001*k, 0.01*j) for k in range(30, 301) for j in range(95, 126)]
    return min(grid, key=lambda p: misfit(*p))


if not QUICK:
    fitted, = read("fitted.csv")
    results.report("shear modulus fitted by calibrateClump", 1e6*fitted["modulus_N_m"], "uN/m",
                   f"+- {1e6*fitted['error_N_m']:.2g}")
    results.add("diameters with that: largest residual", fitted["largest_z"], "error bars", 0, 1,
                MILLS)

    curves = {}
    for m in read(find("../creep/reference/recovery_hochmuth1979_henon1999.csv")):
        curves.setdefault(m["set"], []).append((m["t_s"], m["ratio"]))
    cells = [curves["hochmuth01"], curves["hochmuth02"]]
    measuredTimes = [relaxation(*zip(*cell)) for cell in cells]
    recoveries = {}
    for m in read("recovery.csv"):
        if m["time_s"] < 0.4:
            recoveries.setdefault(m["viscosity"], []).append((m["time_s"], m["ratio"]))
    for viscosity, own in recoveries.items():
        t_c, r_inf = relaxation(*zip(*own))
        name = f"a membrane viscosity of {viscosity:g} uN s/m"
        results.add(f"relaxation time after release from 60 pN with {name}", t_c, "s",
                    round(sum(t for t, _ in measuredTimes)/2, 4), "15%", HOCHMUTH,
                    KNOWN.get(("t_c", viscosity)))
        results.report(f"length over width long after with {name}", r_inf, "-", "fitted with it")
    for n, (t, r) in enumerate(measuredTimes, 1):
        results.report(f"relaxation time of cell {n} of Hochmuth et al.", t, "s",
                       f"length over width long after: {r:g}")

    # The lowest and the highest rate at which cells of a donor begin to tank-tread
    rates = [m["shear_rate_1_s"] for m in read("reference/tt_tb_threshold.csv")
             if m["source"] == "Fischer2013" and m["eta_mPas"] == 23.9]
    for r in read("transition.csv"):
        nodes = 10*4**int(r["subdivisions"]) + 2
        turned = f"at {r['rate']:g} 1/s and {r['mu_mPas']:g} mPa s, {nodes} nodes: turns of the"
        name = f"{turned} cell"
        turns = abs(r["axis_deg"])/360
        if r["rate"] < min(rates):
            results.add(name, max(0.5 - turns, 0), "below a half", 0, 0, FISCHER_KORZENIEWSKI)
        elif r["rate"] > max(rates):
            results.add(name, max(turns - 0.125, 0), "above an eighth", 0, 0,
                        FISCHER_KORZENIEWSKI, KNOWN.get(("turns", r["rate"], nodes)))
        else:
            results.report(name, turns, "-", "in the second half; between the rates of donors")
        results.report(f"{turned} membrane", abs(r["membrane_deg"])/360, "-", "the same")

    ends = {r["run"]: r for r in read("tube.csv")}
    for run, r in ends.items():
        name = f"in a tube of 10 um, {run}"
        results.add(f"speed over mean velocity {name}", r["speed"], "-", 1.4, 0.2,
                    "1.3 to 1.5 for red blood cells in such tubes")
        for column, what in (("off_axis_um", "distance from the axis"), ("Lx_um", "length"),
                             ("hollow_um", "hollow at the rear")):
            results.report(f"{what} {name}", r[column], "um", f"after {r['time_s']:g} s")
        results.add(f"volume {name}", r["volume"], "-", 1, 1e-6, "volume at rest")


fischer = {m["mean_shear_rate"]: (m["mean_f_over_g"], m["sd"])
           for m in read("reference/tankTreading_fischer.csv")}
tst = {m["gdot_1_s"]: m["f_rad_s"]/(2*3.14159265)/m["gdot_1_s"]
       for m in read("reference/tankTreading_tranSonTay1984.csv")}
for r in read("data.csv"):
    nodes = 10*4**int(r["subdivisions"]) + 2
    name = (f"at {r['rate']:g} 1/s and {r['mu_mPas']:g} mPa s, {nodes} nodes, mesh cells of "
            f"{1/r['cells_per_um']:g} um")
    reference = fischer[r["rate"]][0] if r["mu_mPas"] == 28.9 else tst[r["rate"]]
    results.add(f"tank-treading frequency over shear rate {name}", r["f_over_rate"], "-",
                reference, "15%", FISCHER if r["mu_mPas"] == 28.9 else TST,
                KNOWN.get(("f", r["rate"], nodes)))
    results.report(f"inclination {name}", r["inclination_deg"], "degrees", "mean of a half turn")
    results.report(f"length {name}", r["L_um"], "um", "mean of a half turn")
    results.add(f"volume, tank-treading {name}", r["volume"], "-", 1, 1e-6, "volume at rest")
    results.report(f"outer correctors {name}", r["correctors"], "-", "mean of the steps")
for mu, mark in (28.9, "s-"), (35, "o-"):
    rows = [r for r in read("data.csv") if r["mu_mPas"] == mu and r["subdivisions"] == 2]
    right.semilogx([r["rate"] for r in rows], [r["f_over_rate"] for r in rows], mark,
                   label=f"{mu:g} mPa s")
fine = [r for r in read("data.csv") if r["subdivisions"] == 3]
if fine:
    right.semilogx([r["rate"] for r in fine], [r["f_over_rate"] for r in fine], "d",
                   label=f"{fine[0]['mu_mPas']:g} mPa s, 642 nodes")
right.errorbar(list(fischer), [f for f, _ in fischer.values()], [sd for _, sd in fischer.values()],
               fmt="k.-", capsize=2, lw=0.7, label="Fischer, 28.9 mPa s")
right.semilogx(list(tst), list(tst.values()), "kx-", lw=0.7, label="Tran-Son-Tay, 35 mPa s")
right.set_xlabel("shear rate [1/s]")
right.set_ylabel("tank-treading frequency over shear rate")
right.legend(fontsize=7)
save(figure, "redCell.png")
results.write()
