"""Axial and transverse diameter over force, with the experiment."""
import csv
from clumps import table
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

HOLD = 2.0      # s, time per force
with open("suresh2005_malaria_stretch.csv") as file:
    rows = csv.DictReader(line for line in file if not line.startswith("#"))
    measured = [row for row in rows if row["pop"] == "H"]
force = [float(row["force_pN"]) for row in measured]

shape = table(".", "clumpShape")
held = [[row for row in shape if row["time"] < HOLD*(k + 1) + 1e-6][-1] for k in range(len(force))]

figure, axes = plt.subplots(figsize=(5, 3.8))
for quantity, error, column, colour in (
        ("axial", "sdA_um", "Lx", "C3"), ("transverse", "sdT_um", "Ly", "C0")):
    value = [float(row[quantity + "_um"]) for row in measured]
    bar = [float(row[error] or 0) for row in measured]
    axes.errorbar(force, value, bar, fmt="o", ms=4, capsize=2, lw=0.8, color="0.45",
                  label="Suresh et al. 2005" if column == "Lx" else None)
    axes.plot(force, [1e6*row[column] for row in held], color=colour, label=quantity)
axes.set(xlabel="force (pN)", ylabel="diameter (um)")
axes.legend()
figure.tight_layout()
figure.savefig("result.png", dpi=120)
print(f"diameters at {force[-1]:g} pN: axial {1e6*held[-1]['Lx']:.2f} um, transverse "
      f"{1e6*held[-1]['Ly']:.2f} um; measured {measured[-1]['axial_um']} and "
      f"{measured[-1]['transverse_um']} um")
print("Picture: result.png")
