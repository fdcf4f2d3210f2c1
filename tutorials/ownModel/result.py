"""Time constant of the elongation, and that of the theory."""
from math import exp
from clumps import table

FORCE = 2e-12           # N, constant/clumpProperties
STIFFNESS = 1e-5        # N/m, E A/L
DAMPING = 1e-6          # N s/m

shape = table(".", "clumpShape")
elongation = [row["Lx"] - 4e-6 for row in shape]
final = elongation[-1]
time = next(row["time"] for row, x in zip(shape, elongation) if x >= (1 - exp(-1))*final)
print(f"elongation {1e6*final:.4f} um, theory F/K {1e6*FORCE/STIFFNESS:.4f} um")
print(f"time constant {1e3*time:.0f} ms, theory c/K {1e3*DAMPING/STIFFNESS:.0f} ms")
