"""Resistance of spheres in a row that move along their line of centres in an unbounded Stokes flow.

The stream function is a sum over the spheres of the singular solutions r^(1-n) I_n and r^(3-n) I_n
in spherical coordinates about each centre, with the Gegenbauer functions I_n. Their coefficients
follow from the velocities at points on all surfaces by least squares; that of r I_2 is the force.

    Gluckman, M. J., Pfeffer, R., & Weinbaum, S. (1971). A new technique for treating multiparticle
    slow viscous flow: axisymmetric flow past spheres and spheroids. J. Fluid Mech. 50, 705-740.
"""

import numpy as np
from numpy.polynomial import legendre

TERMS, POINTS = 20, 90


def velocities(x, rho, centre):
    """Axial and radial velocity at points (x, rho), a column for each singular solution."""
    z = x - centre
    r = np.hypot(z, rho)
    cosine, sine = z/r, rho/r
    P = [legendre.legval(cosine, np.eye(TERMS + 2)[n]) for n in range(TERMS + 2)]
    axial, radial = [], []
    for n in range(2, TERMS + 2):
        gegenbauer = (P[n - 2] - P[n])/(2*n - 1)
        for power in 1 - n, 3 - n:
            away = -P[n - 1]*r**(power - 2)
            around = power*r**(power - 2)*gegenbauer/sine
            axial.append(away*cosine - around*sine)
            radial.append(away*sine + around*cosine)
    return np.array(axial).T, np.array(radial).T


def forces(centres, motions):
    """Forces of the spheres on the fluid, in 6 pi mu a times the velocity; centres in radii a. A
    motion gives the axial and radial velocity on sphere k at points (x, rho)."""
    cosine, _ = legendre.leggauss(POINTS)
    rows, given = [], []
    for k, centre in enumerate(centres):
        x, rho = centre + cosine, np.sqrt(1 - cosine**2)
        parts = [velocities(x, rho, other) for other in centres]
        rows += [np.hstack([p[0] for p in parts]), np.hstack([p[1] for p in parts])]
        given.append(np.array([np.hstack(motion(k, x, rho)) for motion in motions]).T)
    A = np.vstack(rows)
    scale = np.abs(A).max(axis=0)
    solution = np.linalg.lstsq(A/scale, np.vstack(given), rcond=None)[0]/scale[:, None]

    # A single sphere has the coefficient -3/2
    return solution[1::2*TERMS]/-1.5


def resistance(centres):
    """Matrix of forces over velocities, in 6 pi mu a; centres in radii a."""
    return forces(centres, [lambda k, x, rho, moved=moved: ((k == moved) + 0*x, 0*rho)
                            for moved in range(len(centres))])


def straining(centres):
    """Forces of a fluid with the velocity (x, -rho/2) on the spheres held in it."""
    return forces(centres, [lambda k, x, rho: (-x, rho/2)])[:, 0]*-1


def stretch(matrix, centres):
    """Resistance to u = x about the middle, a sphere's share of it per velocity."""
    x = np.array(centres) - np.mean(centres)
    return x @ matrix @ x/(x @ x)
