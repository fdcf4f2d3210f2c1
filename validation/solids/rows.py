"""Rows of data.csv of a run, every 0.2 shear times."""
import sys
from math import degrees, pi

from clumps import table

case, parameters, shear, R, correctors, seconds = sys.argv[1:]
radius = float(R)
for row in table(case, "clumpShape"):
    t = row["time"]*float(shear)
    if abs(t/0.2 - round(t/0.2)) < 1e-6:
        print(f"{parameters},{round(t, 6):g},{row['TaylorDeformation']:.5f},"
              f"{degrees(row['inclination']):.3f},"
              f"{row['volume']/(4/3*pi*radius**3):.10f},{correctors},{seconds}")
