"""Runs pisoFoam and rbcIbFoam in turns and writes their time per step to data.csv (see Allrun).

Time is processor time of serial runs, so that other work on the machine matters less; a run of 10
steps is taken off
one of 50, so that start-up does not count.
"""

import resource
import subprocess
import sys
from results import write_table

LATTICES = {'1': '(1 1 1)', '8': '(2 2 2)', '32': '(4 2 4)', '8-uncarried': '(2 2 2)',
            '8-iterated': '(2 2 2)'}


def set_entry(case, file, entry, value):
    subprocess.run(['foamDictionary', '-entry', entry, '-set', value, '%s/%s' % (case, file)],
                   stdout=subprocess.DEVNULL, check=True)


def processor_time(case, solver, steps):
    set_entry(case, 'system/controlDict', 'endTime', '%de-6' % steps)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open('%s/log.%s' % (case, solver), 'w') as log:
        if subprocess.run([solver, '-case', case], stdout=log, stderr=log).returncode != 0:
            sys.exit('%s failed, see %s' % (solver, log.name))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def step(case):
    solver = 'pisoFoam' if case == 'pisoFoam' else 'rbcIbFoam'
    return (processor_time(case, solver, 50) - processor_time(case, solver, 10))/40


cases = ['pisoFoam'] + list(LATTICES)
for name, lattice in LATTICES.items():
    set_entry(name, 'constant/clumpProperties', 'placement/number', lattice)

rows = []
for _ in range(int(sys.argv[1])):
    for name in cases:
        clumps, _, kind = name.partition('-')
        solver, clumps = ('pisoFoam', 0) if name == 'pisoFoam' else ('rbcIbFoam', clumps)
        rows.append([solver, clumps, kind or 'one', '%.5f' % step(name)])
        print(*rows[-1], flush=True)
write_table('data.csv', ['solver', 'clumps', 'correctors', 'step_s'], rows)
