"""The tongue in the pipette, the pressure across it and what flows past the cell."""

import math

import matplotlib.pyplot as plt
import numpy as np
from clumps import frames, membranes

SUCTION = 20                        # [Pa], 0.orig/p
RADIUS, LENGTH = 1e-6, 5e-6         # of the pipette [m]
PROBE = 4.5e-6                      # in it, system/controlDict [m]
VISCOSITY, DENSITY = 1.2e-3, 1025
MODULUS, BENDING = 5e-6, 2e-19      # constant/clumpProperties [N/m], [J]


def columns(name):
    """The rows of a table of OpenFOAM, without parentheses"""
    with open("postProcessing/" + name) as file:
        return [[float(x) for x in line.split()] for line in file if not line.startswith("#")]


def evans(pressure):
    """Length over radius of a flat membrane, doc/theory.md, Micropipette"""
    low, high = 0, 100
    for _ in range(100):
        s = 0.5*(low + high)
        low, high = (s, high) if s + math.log(1 + s) < pressure else (low, s)
    return 0.5*(1 + s)


def strainEnergy(start, x, triangles):
    """Of a neo-Hookean membrane [J]"""
    def edges(nodes):
        e = np.stack([nodes[triangles[:, k]] - nodes[triangles[:, 0]] for k in (1, 2)], axis=1)
        return np.einsum("nik,njk->nij", e, e)

    before, after = edges(start), edges(x)
    strain = np.linalg.solve(before, after)
    I1 = np.trace(strain, axis1=1, axis2=2) - 2
    J2 = np.linalg.det(strain)
    return (0.5*MODULUS*(I1 - 1 + 1/J2)*0.5*np.sqrt(np.linalg.det(before))).sum()


def bendingEnergy(x, triangles):
    """By the weights of the cotangents [J]"""
    curvature, areas = np.zeros_like(x), np.zeros(len(x))
    for k in range(3):
        i, j, l = (triangles[:, (k + n) % 3] for n in range(3))
        a, b = x[i] - x[l], x[j] - x[l]
        twice = np.linalg.norm(np.cross(a, b), axis=1)
        side = 0.5*((a*b).sum(axis=1)/twice)[:, None]*(x[j] - x[i])
        np.add.at(curvature, i, side)
        np.add.at(curvature, j, -side)
        np.add.at(areas, i, twice/6)
    return 0.5*BENDING*((curvature**2).sum(axis=1)/areas).sum()


def tongueVolume(x, triangles):
    """Inside the pipette [m3]"""
    corners = x[triangles]
    near = np.hypot(*corners.mean(axis=1).T[1:]) < 1.1*RADIUS
    along = 0.5*np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 0]
    return (np.maximum(corners[:, :, 0], 0).mean(axis=1)*along)[near].sum()


# The flux through an open pipette: Poiseuille, and half of what two mouths resist (Dagan et al.
# 1982)
free = SUCTION/(VISCOSITY*(8*LENGTH/(math.pi*RADIUS**4) + 1.5/RADIUS**3))

rows = []
for time, path in frames():
    m = membranes(path)
    x, triangles = m["x"], m["triangles"]
    if not rows:
        start = x
    r = np.hypot(x[:, 1], x[:, 2])
    rows.append((1e3*time, 1e6*x[r < 0.5*RADIUS, 0].max(), tongueVolume(x, triangles),
                 strainEnergy(start, x, triangles), bendingEnergy(x, triangles)))
lengths = [row[:2] for row in rows]
widest = r[(x[:, 0] > 0) & (r < RADIUS)].max()

# The pressure falls evenly along the pipette from the tip of the tongue to the suction
length = 1e-6*lengths[-1][1]
before, near_end = columns("pressure/0/p")[-1][1:]
slope = (DENSITY*near_end + SUCTION)/(LENGTH - PROBE)
across = DENSITY*before + SUCTION - slope*(LENGTH - length)
leak = columns("flux/0/surfaceFieldValue.dat")[-1][1]
earlier = [l for t, l in lengths if t < lengths[-1][0] - 1]
print("tongue: %.2f um long, a millisecond before %.2f um, %.2f um in radius" % (
    lengths[-1][1], earlier[-1], 1e6*widest))
print("pressure across the cell: %.1f Pa of %g" % (across, SUCTION))
print("leak: %.0f %% of the flux through the open pipette" % (100*leak/free))
print("length over radius %.2f of the tongue, by Evans %.2f of a tongue of this radius" % (
    length/widest, evans(across*widest/MODULUS)))

# Work of the membrane over the volume of the tongue, while it grows
first, last = rows[2], rows[3]
strain, bending = ((last[k] - first[k])/(last[2] - first[2]) for k in (3, 4))
print("strain and bending resist by %.1f and %.1f Pa from %.2f to %.2f um" % (
    strain, bending, first[1], last[1]))

figure, axes = plt.subplots(figsize=(5, 3.4))
axes.plot(*zip(*lengths), "o-", color="firebrick")
axes.set(xlabel="time [ms]", ylabel="length of the tongue [um]")
figure.tight_layout()
figure.savefig("result.png", dpi=110)
