"""The force between two plates that press an elastic sphere, by Hertz and by Tatara (1991), see
doc/theory.md, Compression between plates.

    references.py table <Poisson ratio>     indentation and force of Tatara, for calibrateClump
"""

import math
import sys

RADIUS = 8e-6       # [m]
MODULUS = 1000.0    # shear modulus [Pa]
INDENTATIONS = 0.1, 0.2, 0.4, 0.6       # over the radius


def young(nu):
    return 2*MODULUS*(1 + nu)


def hertz(d, nu):
    """Force [N] at the indentation d [m]."""
    return 4/3*young(nu)/(1 - nu*nu)*math.sqrt(RADIUS)*(d/2)**1.5


def approach(F, nu):
    """Half the indentation of Tatara [m]."""
    E = young(nu)
    k = 1 - nu*nu
    a = (3*k*F*RADIUS/(4*E))**(1/3)
    distance = math.hypot(a, 2*RADIUS)
    f = 2*(1 + nu)*RADIUS**2/distance**3 + k/distance
    return 3*k*F/(4*E*a) - f*F/(math.pi*E)


def tatara(d, nu):
    """Force [N] at the indentation d [m]."""
    low, high = hertz(d, nu), 4*hertz(d, nu)
    for _ in range(100):
        F = 0.5*(low + high)
        if approach(F, nu) < d/2:
            low = F
        else:
            high = F
    return F


if __name__ == "__main__":
    ratio = float(sys.argv[2])
    print("indentation,force")
    for part in INDENTATIONS:
        print("%.6g,%.6g" % (part*RADIUS, tatara(part*RADIUS, ratio)))
