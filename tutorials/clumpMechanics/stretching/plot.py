"""Axial and transverse diameter over force, with the experiment."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../validation"))
import results as r

HOLD = 2.0
REFERENCE = "../../../validation/stretching/reference/suresh2005_malaria_stretch.csv"
measured = [row for row in r.read_table(REFERENCE) if row["pop"] == "H"]
shape = r.clump_shape()

fig, axes = r.figure(1, 1, 5, 3.8)
ax = axes[0][0]
force = [float(row["force_pN"]) for row in measured]
for quantity, error, column, colour in (
        ("axial", "sdA_um", 0, "C3"), ("transverse", "sdT_um", 1, "C0")):
    value = [float(row[quantity + "_um"]) for row in measured]
    bar = [float(row[error] or 0) for row in measured]
    ax.errorbar(force, value, bar, fmt="o", ms=4, capsize=2, lw=0.8, color="0.45",
                label="Suresh et al. 2005" if column == 0 else None)
    held = [[s for s in shape if s[0] < HOLD*(k + 1) + 1e-6][-1] for k in range(len(force))]
    ax.plot(force, [1e6*s[1][column] for s in held], color=colour, label=quantity)
ax.set(xlabel="force (pN)", ylabel="diameter (um)")
ax.legend()
r.save(fig, "result.png")
print("Wrote result.png")
