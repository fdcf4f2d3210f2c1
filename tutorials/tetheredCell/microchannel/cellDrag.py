"""The drag on the tethered cell as the case gives it, and an independent reference for it.

The reference is the drag of the undeformed ring in unbounded fluid, edgewise, from reference/
(computed by a boundary integral method). slitMobility.py transfers it to the present shape of the
cell, the bead in front of it, the walls and the periodic images. A factor corrects for what
Rotne-Prager mobilities miss on the undeformed ring.
"""

import csv
import os
import numpy as np
import clumpSpheres
from slitMobility import Slit, drag

mu = 1.2e-3            # Pa s, so um/s and pN go together through pN s/um^2 = Pa s
height, length, width = 50.0, 50.0, 25.0


def spheres(case='.'):
    """Centres, radii [um] and clump numbers at the last time the case wrote."""
    s = clumpSpheres.spheres(clumpSpheres.frames(case)[-1][1])
    return 1e6*s['x'], 1e6*s['radius'], s['clump']


def table_value(shape, column):
    here = os.path.dirname(os.path.abspath(__file__))
    with open(here + '/reference/stokes_drag_rings_tori_biconcave_computed.csv') as f:
        rows = csv.DictReader(line for line in f if not line.startswith('#'))
        return next(float(r[column]) for r in rows if r['shape'].startswith(shape))


def reference(x, a, cell, u_mean):
    """Returns the drag [pN] on the spheres of the cell at the mean velocity u_mean [um/s], the drag
    over speed of the undeformed ring in unbounded fluid, and the factor that makes Rotne-Prager
    mobilities exact for it. cell: which of the spheres x, a belong to the cell."""
    angles = 2*np.pi*np.arange(10)/10
    ring = 1.955*np.column_stack([np.cos(angles), np.sin(angles), 0*angles])
    exact = table_value('ring 10 spheres a=1.955;R=1.955', 'FUx_pN_s_um')
    approximate = drag(ring, np.full(10, 1.955), mu, lambda y, r: 1.0).sum()
    factor = exact/approximate

    def poiseuille(y, r):
        # with the curvature over a sphere (Faxen)
        h = height/2
        return 1.5*u_mean*(1 - ((y - h)/h)**2 - (r/h)**2/3)

    forces = drag(x, a, mu, poiseuille, Slit(mu, length, height, width).correction)
    return factor*forces[cell].sum(), exact, factor
