"""Forces on a rigid body of spheres, which may overlap, at zero Reynolds number, without a mesh.

Points with the spacing h cover the surface of the body. Each has a force f whose velocity is that
of a regularised Stokeslet (Cortez, Fauci and Medovikov, Phys. Fluids 17 (2005) 031504),

    u(x) = [(r^2 + 2 e^2) f + d (d.f)]/(8 pi mu (r^2 + e^2)^(3/2)),   d = x - y, r = |d|,

with e = 0.35 h, and the forces are such that the fluid rests at all points. The error of first
order in h is extrapolated from two spacings.

    python3 surfaceDrag.py      # a sphere, and a ring against a boundary integral method
"""

import csv
import os
import numpy as np

spacings = 0.31, 0.23           # over the mean radius of the spheres


def surface(x, a, h):
    """Points of the surface of the union of the spheres, and the sphere of each."""
    points, owners = [], []
    for i, (centre, radius) in enumerate(zip(x, a)):
        # Spiral of equal areas
        n = int(np.ceil(4*np.pi*radius**2/h**2))
        k = np.arange(n) + 0.5
        z, angle = 1 - 2*k/n, np.pi*(1 + 5**0.5)*k
        s = np.sqrt(1 - z**2)
        p = centre + radius*np.column_stack([s*np.cos(angle), s*np.sin(angle), z])
        others = np.arange(len(a)) != i
        outside = (np.linalg.norm(p[:, None] - x[others], axis=2) > a[others]).all(axis=1)
        points.append(p[outside])
        owners.append(np.full(outside.sum(), i))
    return np.vstack(points), np.concatenate(owners)


def forces(x, a, mu, flow, correction, h):
    p, owner = surface(x, a, h)
    n = len(p)
    d = p[:, None] - p
    r2, e2 = (d**2).sum(axis=2), (0.35*h)**2
    M = np.einsum('ijk,ijl->ikjl', d, d/((r2 + e2)**1.5)[..., None])
    for k in range(3):
        M[:, k, :, k] += (r2 + 2*e2)/(r2 + e2)**1.5
    M /= 8*np.pi*mu
    M[:, 0, :, 0] += correction(d[..., 0])
    u = np.zeros((n, 3))
    u[:, 0] = flow(p)
    f = np.linalg.solve(M.reshape(3*n, 3*n), u.ravel())[0::3]
    return np.bincount(owner, f, len(a))


def drag(x, a, mu, flow, correction=lambda dx: 0*dx):
    """Forces along x on the spheres at x with radii a, held in the flow along x; correction:
    velocity along x per force along x at the distance dx, besides that of unbounded fluid."""
    coarse, fine = (part*np.mean(a) for part in spacings)
    return (coarse*forces(x, a, mu, flow, correction, fine)
            - fine*forces(x, a, mu, flow, correction, coarse))/(coarse - fine)


def ringDrag(mu):
    """Drag over speed of the undeformed ring, edgewise in unbounded fluid: by drag(), and of the
    table."""
    angles = 2*np.pi*np.arange(10)/10
    ring = 1.955*np.column_stack([np.cos(angles), np.sin(angles), 0*angles])
    here = os.path.dirname(os.path.abspath(__file__))
    with open(here + '/reference/stokes_drag_rings_tori_biconcave_computed.csv') as f:
        rows = csv.DictReader(line for line in f if not line.startswith('#'))
        table = next(float(r['FUx_pN_s_um']) for r in rows
                     if r['shape'].startswith('ring 10 spheres a=1.955;R=1.955'))
    return drag(ring, np.full(10, 1.955), mu, lambda p: np.ones(len(p))).sum(), table


if __name__ == '__main__':
    mu = 1.2e-3
    sphere = drag(np.zeros((1, 3)), np.ones(1), mu, lambda p: np.ones(len(p))).sum()
    print('sphere: %.4f of 6 pi mu a' % (sphere/(6*np.pi*mu)))
    print('ring:   %.4f pN s/um, %.4f by a boundary integral method' % ringDrag(mu))
