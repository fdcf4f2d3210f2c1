#!/usr/bin/env python3
"""Prints the drag on the tethered cell and its shape, and compares the drag with an independent
reference (cellDrag.py)."""

import sys
import numpy as np
from clumps import table
from cellDrag import mu, reference, spheres
from surfaceDrag import ringDrag

u_mean = 1000.0        # um/s


def last(name, clump_type):
    return table('.', name, type=clump_type)[-1]


force, shape, bead = (last(*what) for what in (
    ('clumpForce', 'healthy'), ('clumpShape', 'healthy'), ('clumpForce', 'bead')))
x, a, clump = spheres()
F = 1e12*force['Fx']
axial, transverse = 1e6*shape['L1'], 1e6*shape['L2']
F_reference = reference(x, a, clump == 1, u_mean)

settling = 1e6*np.linalg.norm([force[c] for c in ('Ux', 'Uy', 'Uz')])
print('time                           %8.3f s' % force['time'])
print('drag on the cell               %8.2f pN' % F)
print('drag on the bead               %8.2f pN' % (1e12*bead['Fx']))
print('F_D/u, u = 1 mm/s mean         %8.4f pN s/um' % (F/u_mean))
print('axial, transverse diameter     %8.2f x %.2f um' % (axial, transverse))
print('speed of the cell              %8.4f um/s' % settling)
print('reference F_D/u                %8.4f pN s/um' % (F_reference/u_mean))
print('deviation                      %8.1f %%' % (100*(F/F_reference - 1)))
print('ring at rest, unbounded        %8.4f pN s/um, by a boundary integral method %.4f'
      % ringDrag(mu))

with open('result.csv', 'w') as f:
    f.write('quantity,value,unit,reference,tolerance,source\n')
    f.write('F_D/u,%.5f,pN s/um,%.5f,2%%,'
            '"points on the surface of the cell and the bead, in the periodic slit"\n'
            % (F/u_mean, F_reference/u_mean))
    f.write('axial diameter,%.3f,um,,,\n' % axial)
    f.write('transverse diameter,%.3f,um,,,\n' % transverse)

sys.exit(0 if abs(F/F_reference - 1) < 0.02 else 1)
