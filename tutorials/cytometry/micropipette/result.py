"""The tongue in the pipette, the pressure across it, the tension that the membrane outside hands on
over the lip, and what flows past the cell."""

import math

import matplotlib.pyplot as plt
import numpy as np
from clumps import frames, membranes
from law import Tongue, length as lengthAt, root

SUCTION = 10                        # [Pa], 0.orig/p
RADIUS, LIP, END = 1e-6, 0.5e-6, 5e-6       # of the pipette [m]
CELL = 3.6e-6, 1.8e-6               # half its width and thickness [m]
PROBE = 4.5e-6                      # in the pipette, system/controlDict [m]
VISCOSITY, DENSITY = 1.2e-3, 1025
MODULUS, BENDING, AREA = 5e-6, 2e-19, 5e-4      # constant/clumpProperties [N/m], [J], [N/m]


def columns(name):
    """The rows of a table of OpenFOAM, without parentheses"""
    with open("postProcessing/" + name) as file:
        return [[float(x) for x in line.split()] for line in file if not line.startswith("#")]


def frame(nodes, triangles):
    """Edges of the triangles in two directions of their planes, these directions and the normals,
    with the area as magnitude"""
    a, b = (nodes[triangles[:, k]] - nodes[triangles[:, 0]] for k in (1, 2))
    normal = np.cross(a, b)
    first = a/np.linalg.norm(a, axis=1)[:, None]
    second = np.cross(normal, first)
    second /= np.linalg.norm(second, axis=1)[:, None]
    directions = np.stack([first, second], axis=1)
    return directions @ np.stack([a, b], axis=2), directions, 0.5*normal


def meridianTension(start, x, triangles, mouth):
    """int (T1 - T2) dr/r over the membrane before the pipette, from the radius of the mouth to the
    equator: the tension that shear of the membrane there holds at the mouth [N/m]"""
    edges0 = frame(start, triangles)[0]
    edges, directions, normal = frame(x, triangles)
    F = edges @ np.linalg.inv(edges0)
    B = F @ np.swapaxes(F, 1, 2)
    centre = x[triangles].mean(axis=1)
    r = np.hypot(*centre.T[1:])
    around = np.stack([0*r, -centre[:, 2]/r, centre[:, 1]/r], axis=1)
    area = np.linalg.norm(normal, axis=1)
    along = np.cross(around, normal/area[:, None])
    along /= np.linalg.norm(along, axis=1)[:, None]

    def square(direction):
        v = np.einsum("nij,nj->ni", directions, direction)
        return np.einsum("ni,nij,nj->n", v, B, v)

    # Only the stress of shear differs in the two directions
    difference = MODULUS*(square(along) - square(around))/np.linalg.det(F)
    slope = np.einsum("nj,nj->n", along[:, 1:], centre[:, 1:])/r
    outside = (normal[:, 0] > 0) & (r > mouth)
    return abs((difference*slope*area/(2*np.pi*r**2))[outside].sum())


def energies(start, x, triangles):
    """Of the strain, of the area of the triangles and of bending, the latter by the weights of the
    cotangents [J]"""
    F = frame(x, triangles)[0] @ np.linalg.inv(frame(start, triangles)[0])
    areas = np.linalg.norm(frame(start, triangles)[2], axis=1)
    J = np.linalg.det(F)
    strain = (0.5*MODULUS*((F**2).sum(axis=(1, 2)) + 1/J**2 - 3)*areas).sum()

    curvature, shares = np.zeros_like(x), np.zeros(len(x))
    for k in range(3):
        i, j, l = (triangles[:, (k + n) % 3] for n in range(3))
        a, b = x[i] - x[l], x[j] - x[l]
        twice = np.linalg.norm(np.cross(a, b), axis=1)
        side = 0.5*((a*b).sum(axis=1)/twice)[:, None]*(x[j] - x[i])
        np.add.at(curvature, i, side)
        np.add.at(curvature, j, -side)
        np.add.at(shares, i, twice/6)
    bending = 0.5*BENDING*((curvature**2).sum(axis=1)/shares).sum()
    return np.array([strain, (0.5*AREA*(J - 1)**2*areas).sum(), bending])


def tongueVolume(x, triangles):
    """Behind the face of the pipette [m3]"""
    corners = x[triangles]
    near = np.hypot(*corners.mean(axis=1).T[1:]) < RADIUS + LIP
    along = frame(x, triangles)[2][:, 0]
    return (np.maximum(corners[:, :, 0], 0).mean(axis=1)*along)[near].sum()


# The flux through an open pipette: Poiseuille, and half of what two mouths resist (Dagan et al.
# 1982)
free = SUCTION/(VISCOSITY*(8*END/(math.pi*RADIUS**4) + 1.5/RADIUS**3))

lengths, stored = [], []
for time, path in frames():
    m = membranes(path)
    x, triangles = m["x"], m["triangles"]
    if not lengths:
        start = x
    r = np.hypot(x[:, 1], x[:, 2])
    lengths.append((1e3*time, 1e6*x[r < 0.5*RADIUS, 0].max()))
    stored.append((tongueVolume(x, triangles), energies(start, x, triangles)))

# The pressure falls evenly along the pipette from the tip of the tongue to the suction
length = 1e-6*lengths[-1][1]
before, near_end = columns("pressure/0/p")[-1][1:]
slope = (DENSITY*near_end + SUCTION)/(END - PROBE)
across = DENSITY*before + SUCTION - slope*(END - length)
leak = columns("flux/0/surfaceFieldValue.dat")[-1][1]
earlier = [l for t, l in lengths if t < lengths[-1][0] - 1]
print("tongue: %.2f um long, a millisecond before %.2f um" % (lengths[-1][1], earlier[-1]))
print("pressure across the cell: %.1f Pa of %g" % (across, SUCTION))

# Contact keeps a gap: the membrane is in a narrower bore, with a wider lip
beside = (x[:, 0] < 0.5*LIP) & (r < RADIUS + LIP)
gap = np.hypot(x[:, 0] - LIP, r - RADIUS - LIP)[beside].min() - LIP
bore, lip = RADIUS - gap, LIP + gap
tip = length + gap
if tip < bore + lip:
    tongue = Tongue(bore, lip, root(
        lambda phi: Tongue(bore, lip, phi).length - tip, 0.1, 0.5*math.pi))
else:
    tongue = Tongue(bore, lip, 0.5*math.pi, tip - bore - lip)
tension = meridianTension(start, x, triangles, tongue.r[0])
film = math.pi*(RADIUS + LIP)*gap**3*across/(6*VISCOSITY*0.5*math.pi*LIP)
print("leak: %.0f %% of the flux through the open pipette; that of a film of %.2f um along the lip:"
      " %.1f %%" % (100*leak/free, 1e6*gap, 100*film/free))
print("tension at the mouth: %.1f uN/m by the pressure, %.1f uN/m by shear of the membrane "
      "outside" % (1e6*0.5*across*tongue.radius, 1e6*tension))
# What the membrane stores over the volume of the tongue, while it grows by the last tenth
first = next(n for n, (t, l) in enumerate(lengths) if l > 0.9*lengths[-1][1])
(V0, E0), (V1, E1) = stored[first - 1], stored[-1]
resisted = (E1 - E0)/(V1 - V0)
print("strain, area and bending take up %.1f, %.1f and %.1f Pa from %.2f to %.2f um" % (
    *resisted, lengths[first - 1][1], lengths[-1][1]))


def lawful(pressure, *cell):
    """Length over radius of a membrane without bending"""
    return (lengthAt(pressure/MODULUS, bore, lip, *cell) - gap)/RADIUS


print("length over radius %.2f; of such a cell without bending %.2f, at the pressure less that of "
      "bending %.2f; by Evans %.2f" % (
          length/RADIUS, lawful(across, CELL), lawful(across - resisted[2], CELL), lawful(across)))

figure, axes = plt.subplots(figsize=(5, 3.4))
axes.plot(*zip(*lengths), "o-", color="firebrick")
axes.set(xlabel="time [ms]", ylabel="length of the tongue [um]")
figure.tight_layout()
figure.savefig("result.png", dpi=110)
