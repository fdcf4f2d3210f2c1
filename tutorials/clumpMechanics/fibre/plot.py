"""Deflection of the fibre over time, with the elastica."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../validation"))
import results as r

# Tip deflection of a cantilever of length L under P L^2/EI = 1 (Bisshopp & Drucker 1945), by the
# shooting method
ELASTICA = 0.30172
LENGTH = 16.0
RADIUS = 1.0
shape = r.clump_shape()

fig, axes = r.figure(1, 1, 5, 3.6)
ax = axes[0][0]
ax.plot([1e3*s[0] for s in shape], [1e6*s[1][1] - 2*RADIUS for s in shape], label="fibre")
ax.axhline(ELASTICA*LENGTH, color="0.4", ls="--", label="elastica")
ax.set(xlabel="time (ms)", ylabel="deflection (um)")
ax.legend()
r.save(fig, "result.png")
print(f"Deflection {1e6*shape[-1][1][1] - 2*RADIUS:.4f} um, elastica {ELASTICA*LENGTH:.4f} um; "
      "wrote result.png")
