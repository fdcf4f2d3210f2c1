"""Effective aspect ratio of bodies of revolution in Stokes shear, without a mesh.

Bretherton (1962): any body of revolution turns in shear as a spheroid with the aspect ratio r_e.
Held with its axis
along the gradient and along the flow it feels torques in the ratio r_e^2 (Cox 1971). The torques
come from a single
layer of regularised Stokeslets (Cortez, Fauci & Medovikov 2005) on the surface, extrapolated
linearly to zero
spacing. Spheroids, whose r_e is known, show the error.

    python3 aspectRatio.py      # writes reference/effectiveAspectRatio.csv, half a minute
"""

import numpy as np


def sphere_points(n):
    """Points spread evenly over the unit sphere (a Fibonacci lattice)."""
    i = np.arange(n) + 0.5
    z = 1 - 2*i/n
    s = np.sqrt(1 - z*z)
    angle = np.pi*(1 + np.sqrt(5))*i
    return np.column_stack([s*np.cos(angle), s*np.sin(angle), z])


def ring(spheres, R, r, n):
    """Points on the union of equal spheres on a circle around z; their spacing."""
    angles = 2*np.pi*np.arange(spheres)/spheres
    centres = R*np.column_stack([np.cos(angles), np.sin(angles), 0*angles])
    points = np.concatenate([c + r*sphere_points(n) for c in centres])
    distance = np.linalg.norm(points[:, None] - centres[None], axis=2)
    points = points[(distance > r*(1 - 1e-9)).all(axis=1)]
    return points, r*np.sqrt(4*np.pi/n)


def spheroid(q, n):
    """Equatorial radius 1, polar radius q; spread evenly enough for q not too small."""
    p = sphere_points(n)*[1, 1, q]
    e = np.sqrt(1 - q*q)
    area = 2*np.pi*(1 + (1 - e*e)/e*np.arctanh(e))
    return p, np.sqrt(area/n)


def torques(points, spacing):
    """Torques on the body held in two shear flows, its axis z along the gradient and along the
    flow."""
    eps = 0.5*spacing
    n = len(points)
    d = points[:, None] - points[None]
    s = (d**2).sum(axis=2) + eps**2
    S = d[:, :, :, None]*d[:, :, None, :]
    S[:, :, range(3), range(3)] += (s + eps**2)[:, :, None]
    S /= (s**1.5)[:, :, None, None]
    flows = np.zeros((n, 3, 2))
    flows[:, 0, 0] = points[:, 2]       # u_x = z
    flows[:, 2, 1] = points[:, 0]       # u_z = x
    A = S.transpose(0, 2, 1, 3).reshape(3*n, 3*n)
    f = np.linalg.solve(A, flows.reshape(3*n, 2)).reshape(n, 3, 2)
    moment = points[:, 2, None]*f[:, 0] - points[:, 0, None]*f[:, 2]
    return np.abs(moment.sum(axis=0))


def aspect_ratio(body, coarse=700, fine=1400):
    """r_e with the torques of two numbers of points extrapolated to zero spacing."""
    sizes, values = [], []
    for n in coarse, fine:
        points, spacing = body(n)
        sizes.append(spacing)
        values.append(torques(points, spacing))
    along_gradient, along_flow = (sizes[0]*values[1] - sizes[1]*values[0])/(sizes[0] - sizes[1])
    return np.sqrt(along_gradient/along_flow)


if __name__ == "__main__":
    bodies = [
        ("oblate spheroid 0.3", lambda n: spheroid(0.3, n), 0.3),
        ("oblate spheroid 0.5", lambda n: spheroid(0.5, n), 0.5),
        ("ring 10 spheres r=1.955;R=1.955", lambda n: ring(10, 1.955, 1.955, n//4), None),
        ("ring 10 spheres r=1.30;R=2.61", lambda n: ring(10, 2.61, 1.30, n//6), None),
    ]
    with open("reference/effectiveAspectRatio.csv", "w") as out:
        out.write("# COMPUTED by aspectRatio.py: effective aspect ratio in Stokes shear "
                  "(Bretherton 1962) from the torques on"
                  " the held body,\n# regularised Stokeslets, about 700 and 1400 points, "
                  "extrapolated to zero spacing.\n")
        out.write("body,aspect_ratio,exact\n")
        for name, body, exact in bodies:
            line = f"{name},{aspect_ratio(body):.4f},{exact or ''}"
            print(line, len(body(1400)[0]))
            out.write(line + "\n")
