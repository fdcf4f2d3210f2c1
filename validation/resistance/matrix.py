"""python3 matrix.py <case> <spacing, radii> <6 pi mu r, N s/m>: asymmetry, smallest and largest
eigenvalue and, with a spacing above zero, the resistance of a row of spheres to stretching, in
6 pi mu r."""

import sys

import numpy as np
from spheres import stretch

R = np.loadtxt(f"{sys.argv[1]}/resistance.csv", delimiter=",")
spacing, unit = float(sys.argv[2]), float(sys.argv[3])
spectrum = np.linalg.eigvalsh(R + R.T)/2/unit
axial = R[0::3, 0::3]/unit
row = stretch(axial, spacing*np.arange(len(axial))) if spacing > 0 else np.nan
asymmetry = np.linalg.norm(R - R.T)/np.linalg.norm(R)
print(f"{asymmetry:.3g},{spectrum[0]:.5g},{spectrum[-1]:.5g},{row:.5g}")
