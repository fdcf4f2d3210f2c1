#!/usr/bin/env python3
"""Runs pisoFoam and rbcIbFoam in turns and compares their median time per step (see Allrun).

Time is processor time of serial runs, so that other work on the machine matters less; a run of 10 steps is taken off
one of 50, so that start-up does not count.
"""

import resource
import statistics
import subprocess
import sys

LATTICES = {'1': '(1 1 1)', '8': '(2 2 2)', '32': '(4 2 4)'}


def set_entry(case, file, entry, value):
    subprocess.run(['foamDictionary', '-entry', entry, '-set', value, 'run/%s/%s' % (case, file)],
                   stdout=subprocess.DEVNULL, check=True)


def processor_time(case, solver, steps):
    set_entry(case, 'system/controlDict', 'endTime', '%de-6' % steps)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open('run/%s/log.%s' % (case, solver), 'w') as log:
        if subprocess.run([solver, '-case', 'run/' + case], stdout=log, stderr=log).returncode != 0:
            sys.exit('%s failed, see %s' % (solver, log.name))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def step(case):
    solver = 'pisoFoam' if case == 'pisoFoam' else 'rbcIbFoam'
    return (processor_time(case, solver, 50) - processor_time(case, solver, 10))/40


rounds = 2 if '-quick' in sys.argv else 5
cases = ['pisoFoam', '1', '8', '32']
measured = {name: [] for name in cases}

for name, lattice in LATTICES.items():
    set_entry(name, 'constant/clumpProperties', 'placement/number', lattice)

for _ in range(rounds):
    for name in cases:
        measured[name].append(step(name))

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
