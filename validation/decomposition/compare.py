#!/usr/bin/env python3
"""Largest difference of force and position of the cell over all steps, relative to drag and cell size."""

import sys
import numpy as np

CELL = 7.82e-6


def cell(split):
    rows = [line.split() for line in open('run/%s/postProcessing/clumpForce/0/clumpForce.dat' % split)]
    return np.array([[float(c) for c in r[3:6] + r[9:12]] for r in rows if len(r) > 2 and r[2] == 'healthy'])


serial = cell('1-1-1')
worst = 0
with open('data.csv', 'w') as data, open('results.csv', 'w') as results:
    data.write('split,step,force_difference,position_difference\n')
    results.write('quantity,value,unit,reference,tolerance,source\n')
    for split in ('4-1-1', '2-1-2'):
        other = cell(split)
        assert other.shape == serial.shape and len(serial) >= 10, (other.shape, serial.shape)
        force = np.abs(other - serial)[:, :3].max(axis=1)/abs(serial[-1, 0])
        position = np.abs(other - serial)[:, 3:].max(axis=1)/CELL
        for step, (f, x) in enumerate(zip(force, position), 1):
            data.write('%s,%d,%.3e,%.3e\n' % (split, step, f, x))
        for name, value in (('force', force.max()), ('position', position.max())):
            print('split %s, %d steps: largest difference of %s %.1e' % (split, len(serial), name, value))
            results.write('%s split %s,%.3e,,0,1e-6,serial run\n' % (name, split, value))
            worst = max(worst, value)

sys.exit(0 if worst < 1e-6 else 1)
