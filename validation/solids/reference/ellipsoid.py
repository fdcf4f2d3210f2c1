"""A solid ellipsoid in a linear flow, exactly: a neo-Hookean, incompressible sphere in a Newtonian
fluid without boundaries and inertia.

    ellipsoid.py shear|extension <capillary number> <viscosity ratio> <end> [<step>]

prints time, the Taylor deformation in the plane of flow and gradient, the angle to the flow in
degrees and the longest and shortest stretch, times in 1/(rate), the capillary number mu rate/G.

A sphere |X| < R remains an ellipsoid, x = F X. The stress that its inside has beyond that of the
fluid outside is uniform,

    tau = G (F F^T - I) + 2 (lambda - 1) mu D,      D = (L + L^T)/2,    dF/dt = L F,

and a uniform stress in an ellipsoid changes the gradient of a Stokes flow in it uniformly,

    L_ij = L0_ij - T_ijkl tau_kl,
    T_ijkl = 1/(4 pi mu) integral over the unit sphere of
             w_j w_l (delta_ik - w_i w_k)/|F^T w|^3,

because the flow of a body force div tau has the Fourier transform -k_j k_l (delta_ik - k_i k_k/k^2)
tau_kl/(mu k^2) (Eshelby 1957 for a matrix that is incompressible; Roscoe 1967, Gao and Hu 2009). A
sphere has T tau = tau/(5 mu).
"""

import sys

import numpy as np

ANGLES = 24, 48         # of the quadrature: from the pole, around it


def directions():
    """Unit vectors and their weights, one in sum."""
    z, wz = np.polynomial.legendre.leggauss(ANGLES[0])
    phi = 2*np.pi*(np.arange(ANGLES[1]) + 0.5)/ANGLES[1]
    r = np.sqrt(1 - z*z)
    w = np.stack([np.outer(r, np.cos(phi)), np.outer(r, np.sin(phi)),
                  np.outer(z, np.ones_like(phi))], axis=-1).reshape(-1, 3)
    return w, np.repeat(wz/2/ANGLES[1], ANGLES[1])


UNIT, WEIGHTS = directions()
PROJECTION = np.eye(3) - UNIT[:, :, None]*UNIT[:, None, :]


def response(F):
    """T, for a viscosity of one."""
    weight = WEIGHTS/np.linalg.norm(UNIT @ F, axis=1)**3
    return np.einsum("n,nj,nl,nik->ijkl", weight, UNIT, UNIT, PROJECTION, optimize=True)


def gradient(F, flow, Ca, ratio):
    """L of the inside, over the rate of the flow."""
    T = response(F)
    elastic = (F @ F.T - np.eye(3))/Ca
    right = flow - np.einsum("ijkl,kl", T, elastic)
    if ratio == 1:
        return right
    sym = 0.5*(T + T.transpose(0, 1, 3, 2))
    matrix = np.eye(9) + 2*(ratio - 1)*sym.reshape(9, 9)
    return np.linalg.solve(matrix, right.reshape(9)).reshape(3, 3)


FLOWS = {
    "shear": np.array([[0, 1, 0], [0, 0, 0], [0, 0, 0]], float),
    "extension": np.diag([1, -0.5, -0.5]),
}


def state(F):
    """Taylor deformation and angle in the plane x, y, and the extreme stretches."""
    M = F @ F.T
    apart = np.hypot(0.5*(M[0, 0] - M[1, 1]), M[0, 1])
    mean = 0.5*(M[0, 0] + M[1, 1])
    a, b = np.sqrt(mean + apart), np.sqrt(mean - apart)
    stretches = np.sqrt(np.linalg.eigvalsh(M))
    angle = np.degrees(0.5*np.arctan2(2*M[0, 1], M[0, 0] - M[1, 1]))
    return (a - b)/(a + b), angle, stretches[2], stretches[0]


def course(flow, Ca, ratio, end, step=0.01, until=None):
    """Rows of time and state, from rest, by the classical Runge-Kutta method; the flow ends at the
    time until, if there is one, which is a whole number of steps."""
    step = min(step, 0.1*Ca)
    steps = int(round(end/step))
    step = end/steps
    F = np.eye(3)

    def rate(F):
        return gradient(F, FLOWS[flow]*flows, Ca, ratio) @ F

    rows = [(0.0,) + state(F)]
    for n in range(steps):
        flows = until is None or (n + 0.5)*step < until
        k1 = rate(F)
        k2 = rate(F + 0.5*step*k1)
        k3 = rate(F + 0.5*step*k2)
        k4 = rate(F + step*k3)
        F = F + step/6*(k1 + 2*k2 + 2*k3 + k4)
        rows.append(((n + 1)*step,) + state(F))
    return rows


def spheroid(Ca):
    """Its stretch at rest in an extensional flow, by the stresslet of a rigid prolate spheroid
    (Kim and Karrila 1991, table 3.3): G (s^2 - 1/s) = 15/2 mu rate s^3 X^M(e)."""
    low, high = 1 + 1e-6, 3.0
    for _ in range(100):
        s = 0.5*(low + high)
        e = np.sqrt(1 - s**-3)
        L = np.log((1 + e)/(1 - e))
        XM = 8/15*e**5/((3 - e*e)*L - 6*e)
        if s*s - 1/s < 7.5*Ca*s**3*XM:
            low = s
        else:
            high = s
    return s


if __name__ == "__main__":
    which, Ca, ratio, end = sys.argv[1], *map(float, sys.argv[2:5])
    for row in course(which, Ca, ratio, end, *map(float, sys.argv[5:6])):
        print(*(f"{v:.6g}" for v in row), sep=",")
