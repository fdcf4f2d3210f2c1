"""A chain of spheres in Stokes flow without a mesh: its effective aspect ratio, and the growth of a
small bend in shear.

As in ../tumblingRing/aspectRatio.py regularised Stokeslets on the surface of the union give the
forces f of the fluid with the velocity u on points that move with v, S f = u - v. The chain lies
along the axis of compression of a shear flow of rate 1; in the frame that turns with the
vorticity u = (-x, y, 0)/2. It bends without stretching, so that sphere i turns by the angle

    theta_i = sum_j q_j sin((2j - 1) pi s_i/l),     j = 1, 2, 3

(l: from the first to the last centre), which keeps the ends free of moments. With J the
velocities of the points per velocity of a coordinate (translation, rotation, q) and the elastic
energy E = B/(2 b) sum (theta_i+1 - theta_i)^2 of bonds of length b, virtual power gives

    J^T S^-1 J dq/dt = J^T S^-1 u - dE/dq

The change of dq/dt with q is A - B C. The largest eigenvalue of its part for the bends is the
growth rate of a bend. Lengths are over the radius and forces over 8 pi mu. The values for two
densities of points are extrapolated linearly to zero spacing.

    python3 bending.py      # writes reference/*.csv, two minutes
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../tumblingRing"))
from aspectRatio import aspect_ratio, sphere_points     # noqa: E402

SPHERES, MODES, SMALL = 15, 3, 0.01


def chain(spheres, n):
    """Points on the union of unit spheres a radius apart along x, about n on a lone sphere: from
    the centre of their sphere, and its number."""
    p = np.tile(sphere_points(n), (spheres, 1))
    owner = np.repeat(np.arange(spheres), n)
    x = p[:, 0] + owner
    inside = np.zeros(len(p), bool)
    for k in range(spheres):
        inside |= (x - k)**2 + p[:, 1]**2 + p[:, 2]**2 < 1 - 1e-9
    return p[~inside], owner[~inside], np.sqrt(4*np.pi/n)


def stokeslets(points, spacing):
    """Velocities per force; regularisation as in aspectRatio.py."""
    eps = 0.5*spacing
    d = points[:, None] - points[None]
    s = (d**2).sum(axis=2) + eps**2
    S = d[:, :, :, None]*d[:, :, None, :]
    S[:, :, range(3), range(3)] += (s + eps**2)[:, :, None]
    S /= (s**1.5)[:, :, None, None]
    n = 3*len(points)
    return S.transpose(0, 2, 1, 3).reshape(n, n)


def rates(q, local, owner, spacing, turning):
    """dq/dt without bending stiffness, and the mobility of the coordinates. turning: 1, or 0 for
    spheres that only turn with the whole chain, as with the rotation model wholeClump."""
    s = np.arange(SPHERES) - (SPHERES - 1)/2
    waves = (2*np.arange(MODES) + 1)*np.pi/(SPHERES - 1)
    shape = np.sin(np.outer(s, waves))
    angle = shape @ q
    middle, slope = ((a[1:] + a[:-1])/2 for a in (angle, shape))

    def path(steps):
        x = np.concatenate([np.zeros((1, *steps.shape[1:])), np.cumsum(steps, axis=0)])
        return x - x.mean(axis=0)
    centres = path(np.column_stack([np.cos(middle), np.sin(middle)]))
    moved = [path(-np.sin(middle)[:, None]*slope), path(np.cos(middle)[:, None]*slope)]

    cosine, sine = np.cos(angle)[owner], np.sin(angle)[owner]
    arm = np.column_stack([cosine*local[:, 0] - sine*local[:, 1],
                           sine*local[:, 0] + cosine*local[:, 1]])
    points = np.column_stack([centres[owner] + arm, local[:, 2]])
    J = np.zeros((len(points), 3, 3 + MODES))
    J[:, 0, 0] = J[:, 1, 1] = 1
    J[:, 0, 2], J[:, 1, 2] = -points[:, 1], points[:, 0]
    J[:, 0, 3:] = moved[0][owner] - turning*arm[:, 1, None]*shape[owner]
    J[:, 1, 3:] = moved[1][owner] + turning*arm[:, 0, None]*shape[owner]
    J = J.reshape(-1, 3 + MODES)
    u = (points*[-0.5, 0.5, 0]).reshape(-1, 1)
    forces = np.linalg.solve(stokeslets(points, spacing), np.hstack([J, u]))
    mobility = np.linalg.inv(J.T @ forces[:, :-1])
    return (mobility @ (J.T @ forces[:, -1]))[3:], mobility[3:, 3:], np.diff(shape, axis=0)


def matrices(n, turning):
    """A, C and the spacing of the points."""
    local, owner, spacing = chain(SPHERES, n)
    still, mobility, strain = rates(np.zeros(MODES), local, owner, spacing, turning)
    A = np.array([(rates(SMALL*e, local, owner, spacing, turning)[0] - still)/SMALL
                  for e in np.eye(MODES)]).T
    print(len(local), "points", flush=True)
    return A, mobility @ strain.T @ strain, spacing


def growth(sets, m):
    """Growth rate of a bend over the shear rate, extrapolated; m as in slender.py."""
    L = SPHERES + 1
    (h, g), (k, f) = ((spacing, np.linalg.eigvals(A - L**4/((2*np.log(L) - 1)*m)*C).real.max())
                      for A, C, spacing in sets)
    return (h*f - k*g)/(h - k)


if __name__ == "__main__":
    header = f"# COMPUTED by bending.py for {SPHERES} spheres a radius apart\n"
    own, whole = ([matrices(n, turning) for n in (70, 140)] for turning in (1, 0))
    with open("reference/bending.csv", "w") as out:
        out.write(header + "stiffness,growth,growth_whole_clump\n")
        for m in np.arange(60, 401, 10):
            out.write(f"{m:g},{growth(own, m):.4f},{growth(whole, m):.4f}\n")

    def body(n):
        """As aspect_ratio wants it: along z, n points in all or so."""
        local, owner, spacing = chain(SPHERES, n//8)
        return (local + np.outer(owner - (SPHERES - 1)/2, [1, 0, 0]))[:, [1, 2, 0]], spacing
    with open("reference/aspectRatio.csv", "w") as out:
        ratio = aspect_ratio(body)
        out.write(header + f"spheres,aspect_ratio\n{SPHERES},{ratio:.4f}\n")
        print("aspect ratio", ratio)
