"""Residuals in error bars and the spread over the numbers of spheres; figure of the curves."""
import os
import re

from results import Results, plt, read, save, write_table

SIZES = [8, 10, 12, 16]
POPULATIONS = {"healthy": "healthy", "ringStage": "ring stage", "trophozoite": "trophozoite",
               "schizont": "schizont"}
SURESH = "Suresh et al. 2005"
VOLUME = 94
MODULI = ["1e-5", "2e-5", "5e-5", "1e-4"]


def curve(case, kind="evaluated"):
    """{N: [(force pN, axial um, transverse um)]}"""
    result = {}
    for row in read(f"{case}.{kind}/curve.csv"):
        result.setdefault(SIZES[int(row["variant"])], []).append(
            (1e12*float(row["force"]), 1e6*float(row["axial"]), 1e6*float(row["transverse"])))
    return result


def spread(curves):
    """Largest difference between the numbers of spheres, %, and its force"""
    return max((100*(max(values)/min(values) - 1), curves[8][k][0]) for k in range(len(curves[8]))
               for q in (1, 2)
               for values in [[curves[n][k][q] for n in SIZES]])


def residuals(folder):
    return [(int(row["variant"]), row["quantity"], 1e12*float(row["force"]),
             1e6*float(row["measured"]),
             1e6*float(row["error"]), float(row["z"])) for row in read(folder + "/residuals.csv")]


def worst(folder):
    return max(abs(row[-1]) for row in residuals(folder))


def found(pattern, log):
    return re.search(pattern, open(log).read()).group(1)


def seconds(log):
    return float(found(r"curves in (\S+) s", log))


out = Results()
data = []
for case, name in POPULATIONS.items():
    for row in residuals(case + ".evaluated"):
        data.append([name, SIZES[row[0]], *row[1:]])
    out.add(f"{name}: largest residual, N = 8, 10, 12, 16, one set", worst(case + ".evaluated"),
            "error bars", 0, 0.8, SURESH)

    out.add(f"{name}: largest difference between N = 8, 10, 12 and 16", spread(curve(case))[0],
            "%", 0, 5, "each other")

    unstable = int(found(r"unstable states (\d+)", f"log.{case}"))
    out.add(f"{name}: states that buckle", unstable, "-", 0, 0, "second variation of the energy")

    if os.path.exists(f"{case}.fit"):
        largest = spread(curve(case, "fit"))
        print(f"{name}, fitted anew: difference between N %.2f %% at %.0f pN" % largest)
        out.add(f"{name}: fitted anew, largest residual", worst(case + ".fit"), "error bars", 0,
                0.8, SURESH)
        out.add(f"{name}: processor time of that fit", seconds(f"log.{case}.fit"), "s", 0, 30,
                "wanted")
        for v, n in enumerate(SIZES):
            out.add(f"{name}: fitted for N = {n} alone, largest residual", worst(f"{case}.fit{v}"),
                    "error bars", 0, 0.7,
                    SURESH)

out.add("healthy set against an independent experiment", worst("mills.evaluated"), "error bars", 0,
        1.0,
        "Mills et al. 2004")
volumes = [1e18*float(v)
           for v in found(r"volume \[m3\] (.*)", "log.unionHealthy").split()]
out.add("union of 94 um3: volume, N of the largest deviation",
        max(volumes, key=lambda v: abs(v - VOLUME)), "um3", VOLUME, "0.1%", "Evans & Fung 1972")
out.add("union of 94 um3, its own set: largest residual, N = 8, 10, 12, 16",
        worst("unionHealthy.evaluated"), "error bars", 0, 0.8, SURESH)
out.add("geometry of the paper, its own set: largest residual, N = 8, 10, 12, 16",
        worst("paperHealthy.evaluated"),
        "error bars", 0, 0.8, SURESH)
if os.path.exists("conserved-5e-5.fit"):
    out.add("healthy, area modulus 50 uN/m, fitted anew: largest residual",
            worst("conserved-5e-5.fit"), "error bars", 0,
            0.8, SURESH)
for case in ("mills", "unionHealthy", "paperHealthy", "printed",
             *("conserved-" + m for m in MODULI)):
    for row in residuals(case + ".evaluated"):
        data.append([case, SIZES[row[0]], *row[1:]])
print("Largest residual of the printed law", worst("printed.evaluated"))
print("areaModulus [N/m], largest residual [error bars], for N = 8, 10, 12, 16, unstable states")
for m, case in (("0", "healthy"), *((m, "conserved-" + m) for m in MODULI)):
    single = [max(abs(row[-1]) for row in residuals(case + ".evaluated") if row[0] == v)
              for v in range(len(SIZES))]
    print(m, worst(case + ".evaluated"), *single, found(r"unstable states (\d+)", "log." + case))
write_table("data.csv", ["population", "N", "quantity", "force_pN", "measured_um", "error_um", "z"],
            data)

# Figure
fig, axes = plt.subplots(2, 3, figsize=(12, 6.8), squeeze=False)
styles = {8: ":", 10: "-", 12: "-.", 16: "--"}
colours = {"axial": "C3", "transverse": "C0"}


def draw(ax, case, title):
    points = [p for p in residuals(case + ".evaluated") if p[0] == 0]
    for q, quantity in enumerate(("axial", "transverse")):
        rows = [p for p in points if p[1] == quantity]
        ax.errorbar([p[2] for p in rows], [p[3] for p in rows], [p[4] for p in rows], fmt="o", ms=3,
                    lw=0.8,
                    capsize=2, color="0.45", label="experiment" if q == 0 else None)
        for n, points_n in curve(case).items():
            ax.plot([p[0] for p in points_n], [p[1 + q] for p in points_n], styles[n],
                    color=colours[quantity],
                    label=f"{quantity}, N = {n}")
    ax.set(title=title, xlabel="force [pN]", ylabel="diameter [um]", ylim=(2, 19))


for ax, (case, name) in zip(axes.flat, POPULATIONS.items()):
    draw(ax, case, name)
draw(axes[1][1], "printed", "healthy, law as printed")
draw(axes[1][2], "conserved-5e-5", "healthy, area held by 50 uN/m")
axes[1][0].legend(fontsize=7, ncol=2, loc="upper left")
save(fig, "stretching.png")
out.write()
