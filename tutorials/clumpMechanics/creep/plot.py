"""Normalised creep compliance (Eq. 14 of the paper) over time."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../validation"))
import results as r

shape = r.clump_shape()
rest = 7.82e-6
final = shape[-1][1][0]

fig, axes = r.figure(1, 1, 5, 3.6)
ax = axes[0][0]
ax.plot([s[0] for s in shape], [(final - s[1][0])/(final - rest) for s in shape])
ax.set(xlabel="time (s)", ylabel="normalised creep compliance")
r.save(fig, "result.png")
print("Wrote result.png")
