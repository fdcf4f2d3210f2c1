#!/usr/bin/env python3
"""Runs pisoFoam and rbcIbFoam in turns and compares their median time per step (see Allrun)."""

import statistics
import subprocess
import sys
import time

LATTICES = {'1': '(1 1 1)', '8': '(2 2 2)', '32': '(4 2 4)'}


def steps(case, solver):
    """Seconds between the steps a run announces, the first five left out."""
    stamps = []
    process = subprocess.Popen([solver, '-case', case], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    tail = []
    for line in process.stdout:
        tail = tail[-15:] + [line]
        if line.startswith('Time = '):
            stamps.append(time.perf_counter())
    if process.wait() != 0 or len(stamps) < 10:
        sys.exit('%s failed in %s:\n%s' % (solver, case, ''.join(tail)))
    return [b - a for a, b in zip(stamps, stamps[1:])][5:]


rounds = 1 if '-quick' in sys.argv else 3
cases = ['pisoFoam', '1', '8', '32']
measured = {name: [] for name in cases}

for name, lattice in LATTICES.items():
    subprocess.run(['foamDictionary', '-entry', 'placement/number', '-set', lattice,
                    'run/%s/constant/clumpProperties' % name], stdout=subprocess.DEVNULL, check=True)

for _ in range(rounds):
    for name in cases:
        measured[name] += steps('run/' + name, 'pisoFoam' if name == 'pisoFoam' else 'rbcIbFoam')

plain = statistics.median(measured['pisoFoam'])
with open('data.csv', 'w') as data, open('results.csv', 'w') as results:
    data.write('solver,cells,step_s\n')
    results.write('quantity,value,unit,reference,tolerance,source\n')
    print('pisoFoam %.4f s per step' % plain)
    for name in cases:
        solver, cells = ('pisoFoam', '0') if name == 'pisoFoam' else ('rbcIbFoam', name)
        for seconds in measured[name]:
            data.write('%s,%s,%.5f\n' % (solver, cells, seconds))
        if name != 'pisoFoam':
            median = statistics.median(measured[name])
            each = 1000*(median - plain)/int(name)
            print('rbcIbFoam, %2s cells: %.4f s per step, ratio %.3f, %.2f ms per cell' % (name, median, median/plain, each))
            results.write('ratio with %s cells,%.4f,,,,"time per step over pisoFoam, same run"\n' % (name, median/plain))
