"""Growth of a small bend of a fibre in shear by slender-body theory.

A fibre of length L lies along the axis of compression of a shear flow of rate G, its angle to the
flow -45 degrees. In the frame that turns with the vorticity the flow along and across it is (-G
s/2, G h/2) at the arc length s from its middle and the deflection h. The local theory (Batchelor
1970, Cox 1970) gives the force of the fluid per length

    f = z (I - tt/2) (u - v),       z = 8 pi mu/c,      c = -ln((r/L)^2 e)

with the tangent t and the radius r. Along the fibre T' + f_t = 0 with T = 0 at the ends: the
tension T = -z G (L^2/4 - s^2)/8 is a compression. Across it, (T h')' - B h'''' + f_n = 0 with the
bending stiffness B. With lengths over L and times over 1/G, and to first order in h,

    dh/dt = h/2 + s h'/2 - (1/4 - s^2) h''/8 - h''''/m,     m = z G L^4/B = 8 pi mu G L^4/(c B)

with h'' = h''' = 0 at the ends. Besides the translation (growth 1/2, with the flow) and the turn
(growth 1) its modes are bends. The first of them grows above m = 306.4, as Liu et al. (2018) find.

    Liu, Y., Chakrabarti, B., Saintillan, D., Lindner, A., & du Roure, O. (2018). Morphological
    transitions of elastic filaments in shear flow. PNAS 115, 9438-9443.
    Becker, L. E., & Shelley, M. J. (2001). Instability of elastic filaments in shear flow yields
    first-normal-stress differences. Phys. Rev. Lett. 87, 198301.
    Batchelor, G. K. (1970). Slender-body theory for particles of arbitrary cross-section in Stokes
    flow. J. Fluid Mech. 44, 419-440.
"""

import numpy as np
from numpy.polynomial import legendre

TERMS = 20


def operators():
    """Matrices of mass, flow and bending between even Legendre polynomials on -1/2 < s < 1/2."""
    x, weight = legendre.leggauss(2*TERMS)
    s, weight = x/2, weight/2
    unit = np.eye(2*TERMS)[0:2*TERMS:2]
    h, h1, h2 = (np.array([legendre.legval(x, legendre.legder(p, k)) for p in unit])*2**k
                 for k in range(3))
    mass = h*weight @ h.T
    flow = h*weight @ (h/2 + s*h1/2 - (0.25 - s*s)*h2/8).T
    bending = h2*weight @ h2.T
    return mass, flow, bending


def growth(m):
    """Growth rate of the first bend over the shear rate: all modes but the translation."""
    mass, flow, bending = operators()
    rates = np.linalg.eigvals(np.linalg.solve(mass, flow - bending/m)).real
    return max(np.delete(rates, np.argmin(abs(rates - 0.5))))


def threshold():
    """The m above which it grows."""
    low, high = 100, 1000
    while high - low > 1e-3:
        m = (low + high)/2
        low, high = (low, m) if growth(m) > 0 else (m, high)
    return high
