#!/usr/bin/env python3
"""Largest difference of force and position of the cell over all steps, relative to drag and cell size."""

import sys
import numpy as np

CELL = 7.82e-6


def cell(ranks):
    rows = [line.split() for line in open('run/%d/postProcessing/clumpForce/0/clumpForce.dat' % ranks)]
    return np.array([[float(c) for c in r[3:6] + r[9:12]] for r in rows if len(r) > 2 and r[2] == 'healthy'])


serial = cell(1)
worst = 0
with open('data.csv', 'w') as data, open('results.csv', 'w') as results:
    data.write('ranks,step,force_difference,position_difference\n')
    results.write('quantity,value,unit,reference,tolerance,source\n')
    for ranks in (4,):
        other = cell(ranks)
        assert other.shape == serial.shape and len(serial) >= 10, (other.shape, serial.shape)
        force = np.abs(other - serial)[:, :3].max(axis=1)/abs(serial[-1, 0])
        position = np.abs(other - serial)[:, 3:].max(axis=1)/CELL
        for step, (f, x) in enumerate(zip(force, position), 1):
            data.write('%d,%d,%.3e,%.3e\n' % (ranks, step, f, x))
        for name, value in (('force', force.max()), ('position', position.max())):
            print('%d ranks, %d steps: largest difference of %s %.1e' % (ranks, len(serial), name, value))
            results.write('%s on %d ranks,%.3e,,0,1e-6,serial run\n' % (name, ranks, value))
            worst = max(worst, value)

sys.exit(0 if worst < 1e-6 else 1)
