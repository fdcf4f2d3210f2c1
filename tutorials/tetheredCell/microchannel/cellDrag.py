"""The drag on the tethered cell as the case gives it, and an independent reference for it.

The reference is the force on the spheres of the cell as they are at the end, with the bead in front
of them, between the walls and beside the periodic images, at zero Reynolds number and without a
mesh (surfaceDrag.py, slitMobility.py).
"""

import clumps
from slitMobility import Slit
from surfaceDrag import drag

mu = 1.2e-3            # Pa s, so um/s and pN go together through pN s/um^2 = Pa s
height, length, width = 50.0, 50.0, 25.0


def spheres(case='.'):
    """Centres, radii [um] and clump numbers at the last time the case wrote."""
    s = clumps.spheres(clumps.frames(case)[-1][1])
    return 1e6*s['x'], 1e6*s['radius'], s['clump']


def reference(x, a, cell, u_mean):
    """Drag [pN] on the spheres of the cell at the mean velocity u_mean [um/s]. cell: which of the
    spheres x, a belong to the cell."""
    def poiseuille(p):
        return 1.5*u_mean*(1 - (2*p[:, 1]/height - 1)**2)

    return drag(x, a, mu, poiseuille, Slit(mu, length, height, width).correction)[cell].sum()
