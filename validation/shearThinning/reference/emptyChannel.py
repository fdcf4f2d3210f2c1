#!/usr/bin/env python3
"""Error [%] of the gradient that holds a mean velocity in a plane channel without a sphere, in a
power law of the index n, over the number of mesh cells across: a finite-volume solution with the
linear interpolation of the viscosity to the faces, as on the meshes of the validation.

    python3 emptyChannel.py
"""

import sys


def tridiagonal(lower, diagonal, upper, right):
    """The solution of a tridiagonal system."""
    size = len(diagonal)
    diagonal, right = diagonal[:], right[:]
    for i in range(1, size):
        factor = lower[i]/diagonal[i - 1]
        diagonal[i] -= factor*upper[i - 1]
        right[i] -= factor*right[i - 1]
    for i in reversed(range(size)):
        right[i] = (right[i] - (upper[i]*right[i + 1] if i + 1 < size else 0))/diagonal[i]
    return right


def mean_velocity(cells, n):
    """For a height, a gradient and a consistency of one."""
    h, nu = 1/cells, [1.0]*cells
    for _ in range(2000):
        between = [(a + b)/2/h for a, b in zip(nu, nu[1:])]
        faces = [2*nu[0]/h, *between, 2*nu[-1]/h]
        u = tridiagonal([0, *(-f for f in between)], [a + b for a, b in zip(faces, faces[1:])],
                        [*(-f for f in between), 0], [h]*cells)
        on_faces = [0, *((a + b)/2 for a, b in zip(u, u[1:])), 0]
        rates = [abs(b - a)/h for a, b in zip(on_faces, on_faces[1:])]
        new = [min(max(rate, 1e-30)**(n - 1), 1e4) for rate in rates]
        nu = [(a*b)**0.5 for a, b in zip(nu, new)]
    return sum(u)/cells


if __name__ == "__main__":
    if sys.argv[1:]:
        sys.exit(__doc__)
    print("n," + ",".join(str(cells) for cells in (3, 4, 5, 6, 8, 12, 16)))
    for n in 1, 0.8, 0.5:
        exact = 0.5**(1/n + 1)*n/(2*n + 1)
        print(n, *(f"{100*((exact/mean_velocity(cells, n))**n - 1):.1f}"
                   for cells in (3, 4, 5, 6, 8, 12, 16)), sep=",")
