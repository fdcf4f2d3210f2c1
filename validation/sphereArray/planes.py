"""Flow between two planes h cells apart at any offset to the cells, walls by the rule of the forcing `sharp` in one
dimension: errors of a pressure-driven and of a shear flow, without and with the curvature 2/h of a parabola."""

import numpy as np


def velocities(h, offset, kappa, driving, speed):
    """Cell centres from the lower plane, solution of u'' = -driving between 0 and speed."""
    y = np.arange(offset, h, 1)
    matrix = np.zeros((y.size, y.size))
    source = np.full(y.size, float(driving))
    for i in range(y.size):
        for other, a, wall in (i - 1, y[i], 0), (i + 1, h - y[i], speed):
            if 0 <= other < y.size:
                conductance = 1
                matrix[i, other] -= 1
            else:
                b = a - 1
                conductance = 1 + (np.expm1(-kappa*b)/-np.expm1(-kappa*a) if kappa else -b/a)
                source[i] += conductance*wall
            matrix[i, i] += conductance
    return y, np.linalg.solve(matrix, source)


offsets = (np.arange(400) + 0.5)/400
print("h/dx  curvature  flow: mean error and deviation in %  shear: largest error in % of the speed (mean)")
for h in 1.4, 2, 4, 8:
    for kappa in 0, 2/h:
        flows, shears = [], []
        for offset in offsets:
            y, u = velocities(h, offset, kappa, 1, 0)
            flows.append(100*(u.sum()/(h**3/12) - 1))
            y, u = velocities(h, offset, kappa, 0, 1)
            shears.append(100*abs(u - y/h).max())
        print(f"{h:4g}  {kappa:9.2f}  {np.mean(flows):17.1f} {np.std(flows):6.1f}  {np.mean(shears):28.1f}")
