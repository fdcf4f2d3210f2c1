"""Deflection of the fibre over time, with the elastica."""
from clumps import table
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# Tip deflection of a cantilever of length L under P L^2/EI = 1 (Bisshopp & Drucker 1945), by the
# shooting method
ELASTICA = 0.30172
LENGTH = 16.0           # um
RADIUS = 1.0            # um

shape = table(".", "clumpShape")
deflection = [1e6*row["Ly"] - 2*RADIUS for row in shape]

figure, axes = plt.subplots(figsize=(5, 3.6))
axes.plot([1e3*row["time"] for row in shape], deflection, label="fibre")
axes.axhline(ELASTICA*LENGTH, color="0.4", ls="--", label="elastica")
axes.set(xlabel="time (ms)", ylabel="deflection (um)")
axes.legend()
figure.tight_layout()
figure.savefig("result.png", dpi=120)
print(f"deflection {deflection[-1]:.4f} um, elastica {ELASTICA*LENGTH:.4f} um")
print("Picture: result.png")
