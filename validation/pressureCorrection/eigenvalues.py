"""Eigenvalues of one outer corrector, written to data.csv: momentum predictor, consistent pressure
equation, rotational correction p -= c div u*.

The matrix that one outer corrector applies to the pressure, in a box of mesh cells as the solver
discretises it (collocated, linear interpolation, compact Laplacian of p in the face flux), with the
old velocity held. The outer correctors converge where all eigenvalues lie inside the unit circle. c
is that of the class rotationalCorrection, in units of nu.
"""
import itertools

import numpy as np

from results import write_table


class Pass:
    """Widths per direction; sides -x, +x, -y, ... 'wall' (U fixed, p zeroGradient) or 'open' (p
    fixed, U zeroGradient)"""

    def __init__(self, widths, sides, viscous_number):
        dims, shape, dt = len(widths), [len(w) for w in widths], viscous_number
        number = np.arange(np.prod(shape)).reshape(shape)
        size = number.size
        volume = np.ones(size)
        faces, patches = [], []
        for cell in itertools.product(*map(range, shape)):
            volume[number[cell]] = np.prod([w[i] for w, i in zip(widths, cell)])
        for cell in itertools.product(*map(range, shape)):
            own = number[cell]
            for k, w in enumerate(widths):
                width = w[cell[k]]
                area = volume[own]/width
                if cell[k] + 1 < shape[k]:
                    other = list(cell)
                    other[k] += 1
                    nei = number[tuple(other)]
                    distance = 0.5*(width + w[cell[k] + 1])
                    faces.append((own, nei, k, area, 1/distance, 0.5*w[cell[k] + 1]/distance))
                for sign, at in ((-1, 0), (1, shape[k] - 1)):
                    if cell[k] == at:
                        patches.append((own, k, sign, area, 2/width, sides[2*k + (sign > 0)]))

        # Momentum: M = 1/dt - laplacian, diagonal A, neighbours H1; divided by the volume
        neighbours = np.zeros((size, size))
        for own, nei, _, area, coeff, _ in faces:
            neighbours[own, nei] += area*coeff
            neighbours[nei, own] += area*coeff
        diagonal = neighbours.sum(1)
        for own, _, _, area, coeff, side in patches:
            diagonal[own] += area*coeff*(side == "wall")
        A = 1/dt + diagonal/volume
        M = np.diag(A) - neighbours/volume[:, None]
        rAU = 1/A
        rAtU = 1/(A - neighbours.sum(1)/volume)

        # Gradient of p, divergence of an interpolated velocity (zero on walls)
        grad = np.zeros((dims, size, size))
        for own, nei, k, area, _, weight in faces:
            for cell, sign in ((own, 1), (nei, -1)):
                grad[k, cell, own] += sign*area*weight/volume[cell]
                grad[k, cell, nei] += sign*area*(1 - weight)/volume[cell]
        div = grad.copy()
        for own, k, sign, area, _, side in patches:
            (div if side == "open" else grad)[k, own, own] += sign*area/volume[own]

        def laplacian(r):
            L = np.zeros((size, size))
            for own, nei, _, area, coeff, weight in faces:
                a = area*coeff*(weight*r[own] + (1 - weight)*r[nei])
                L[own, own] -= a
                L[own, nei] += a
                L[nei, nei] -= a
                L[nei, own] += a
            for own, _, _, area, coeff, side in patches:
                L[own, own] -= area*coeff*r[own]*(side == "open")
            return L/volume[:, None]

        flux = laplacian(rAtU - rAU)
        for k in range(dims):
            predicted = -np.linalg.solve(M, grad[k])
            flux += div[k] @ (rAU[:, None]*((np.diag(A) - M) @ predicted))
        L = laplacian(rAtU)
        self.excess = flux - L
        self.corrected = np.linalg.solve(L, flux)
        self.G = -np.diag(laplacian(rAU))
        self.beside = np.zeros(size, bool)
        self.beside[[p[0] for p in patches if p[5] == "open"]] = True
        several = len({p[1] for p in patches if p[5] == "open"}) > 1
        usual = (2/3 if several else 1)*np.minimum(1, 1/self.G)
        self.c = {
            "nu": np.eye(size),
            "0 beside the patch": np.diag(1.0 - self.beside),
            "w min(nu, 1/G)": np.diag(usual),
        }

    def largest(self, c):
        """Eigenvalue of the largest magnitude"""
        values = np.linalg.eigvals(self.corrected - self.c[c] @ self.excess)
        return values[np.abs(values).argmax()].real


def even(n):
    return np.ones(n)


def graded(n, ratio):
    w = ratio**(np.arange(n)/(n - 1))
    return w*n/w.sum()


CHANNEL = ("wall", "open") + 4*("wall",)
CASES = {
    "channel, one outlet": ([even(8), even(6), even(6)], CHANNEL),
    "two dimensions": ([even(16), even(10)], CHANNEL[:4]),
    "two outlets": ([even(7), even(6), even(6)], 2*("open",) + 4*("wall",)),
    "graded to the outlet": ([graded(8, 0.1), even(6), even(6)], CHANNEL),
    "graded from the outlet": ([graded(8, 10), even(6), even(6)], CHANNEL),
    "thin layer at the outlet": ([np.append(even(7), 0.1), even(6), even(6)], CHANNEL),
    "flat mesh cells": ([0.2*even(8), even(6), even(6)], CHANNEL),
    "corner of two outlets": ([even(7), even(7), even(6)],
                              ("wall", "open", "wall", "open", "wall", "wall")),
    "open on five sides": ([even(8), even(7), even(7)], ("wall",) + 5*("open",)),
    "open on all sides": ([even(8), even(8), even(8)], 6*("open",)),
}

rows = []
print("largest eigenvalue of one outer corrector with c =")
for name, (widths, sides) in CASES.items():
    for number in (10, 100, 1e3, 1e4):
        one = Pass(widths, sides, number)
        for c in one.c:
            rows.append([name, f"{number:g}", c, f"{one.largest(c):.10g}"])
            print(f"{name}, nu dt/dx2 {number:g}, {c}: {float(rows[-1][-1]):.4f}", flush=True)
write_table("data.csv", ["domain", "viscous_number", "c", "eigenvalue"], rows)
