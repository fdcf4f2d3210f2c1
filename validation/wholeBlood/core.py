"""Shear rate and haematocrit in the middle half between the walls, beyond the layers without cells:

    core.py <case> <from, s>

prints rate [1/s], its standard error by blocks of time, and haematocrit. The rate is that of the
line of least squares through the velocities of the bins there.
"""

import sys

import numpy as np
from clumps import table

GAP = 20e-6         # [m]

times = {}
for row in table(sys.argv[1], "clumpProfiles"):
    if row["time"] >= float(sys.argv[2]) and abs(row["s"] - GAP/2) <= GAP/4:
        times.setdefault(row["time"], []).append((row["s"], row["U"], row["H"]))
profiles = np.array([times[time] for time in sorted(times)])
rates = np.array([np.polyfit(p[:, 0], p[:, 1], 1)[0] for p in profiles])
blocks = np.array([block.mean() for block in np.array_split(rates, min(8, len(rates)))])
error = blocks.std(ddof=1)/len(blocks)**0.5
print("%.5g,%.3g,%.4g" % (rates.mean(), error, profiles[..., 2].mean()))
