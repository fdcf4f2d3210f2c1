"""How far from the corner of the electrodes the beads are, and where theory has them."""
from math import hypot, pi
from clumps import table

VOLTAGE, ANGLE = 10, 0.5            # V, rad, between the electrodes
PERMITTIVITY, FACTOR = 6.95e-10, -0.47
VISCOSITY = 1e-3                    # Pa s
RADII = (2e-6, 3e-6, 3e-6)          # m, in the order of constant/clumpProperties

# E = V/(r a), F = 2 pi eps R^3 K dE^2/dr, dr/dt = F/(6 pi mu R): r^4 = r_0^4 - 4 c t
for clump, radius in enumerate(RADII):
    path = [(row["time"], hypot(row["x"], row["y"]))
            for row in table(".", "clumpForce", clump=clump)]
    c = 2*PERMITTIVITY*FACTOR*radius**2*(VOLTAGE/ANGLE)**2/(3*VISCOSITY)
    (t0, r0), (t, r) = path[0], path[-1]
    theory = (r0**4 - 4*c*(t - t0))**0.25
    print(f"bead {clump}, {1e6*radius:.0f} um: {1e6*r:.2f} um from the corner, "
          f"theory {1e6*theory:.2f} um")
