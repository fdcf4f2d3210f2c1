"""Developed flow in a square duct, as a field of OpenFOAM on standard output:

    python3 ductFlow.py <width> <largest velocity> <velocity of the walls> <nx> <n>

The duct lies along x, with nx cells along it and n across; mesh cells in the order of blockMesh.
"""

import math
import sys

width, largest, walls = (float(a) for a in sys.argv[1:4])
nx, n = (int(a) for a in sys.argv[4:])


def profile(y, z):
    """Of a pressure gradient mu; Fourier series, y and z from the middle over the width."""
    return sum((-1)**((k - 1)//2)/k**3*(1 - math.cosh(k*math.pi*z)/math.cosh(k*math.pi/2))
               * math.cos(k*math.pi*y) for k in range(1, 60, 2))


middle = profile(0, 0)
places = [(j + 0.5)/n - 0.5 for j in range(n)]
print(f"internalField nonuniform List<vector>\n{nx*n*n}\n(")
for z in places:
    for y in places:
        u = walls + largest*profile(y, z)/middle
        print(f"({u:.10g} 0 0)\n"*nx, end="")
print(");")
