"""Length of the tongue over the pressure by the analysis of Evans (1973), doc/theory.md, for a lip
that is round and for a cell of finite size.

    law.py                  prints both for the pipette and the cell of this tutorial

The membrane keeps the area of its patches and slides over the wall without friction. The tongue is
part of a sphere that touches the lip, or half a sphere and a cylinder. Outside, the membrane lies
on the lip, and from there on it is flat (Evans), or part of a spheroid which has the volume and the
area that are left of the cell. Without bending, a flaccid cell has no tension at its equator, so
that the balance along the meridian gives the tension T at the mouth,

    T = int (T1 - T2) dr/r,      P = 2 T/Rc

from the mouth to the equator, with the radius Rc of the tongue.
"""

import numpy as np


def integral(y, x):
    """By the trapezoidal rule"""
    return (0.5*(y[1:] + y[:-1])*np.diff(x)).sum()


def spheroid(a, c):
    """Radii and areas from the pole to the equator of a spheroid of the half axes a, a, c"""
    t = np.linspace(0, 0.5*np.pi, 4001)
    r = a*np.sin(t)
    slope = np.hypot(a*np.cos(t), c*np.sin(t))
    rings = 0.5*np.pi*(r[1:] + r[:-1])*(slope[1:] + slope[:-1])*np.diff(t)
    return r, np.concatenate([[0], np.cumsum(rings)])


def root(f, low, high):
    """Of a function that grows"""
    for _ in range(60):
        middle = 0.5*(low + high)
        low, high = (middle, high) if f(middle) < 0 else (low, middle)
    return 0.5*(low + high)


class Tongue:
    """In a bore of the radius Rp with a lip of the radius b: the sphere touches the lip at the
    angle phi from the face, and has a cylinder of this length behind it where phi is 90 degrees."""

    def __init__(self, Rp, b, phi, cylinder=0):
        mouth = Rp + b
        R = self.radius = mouth/np.sin(phi) - b
        self.length = (b + R)*(1 - np.cos(phi)) + cylinder
        area = 2*np.pi*R*(R*(1 - np.cos(phi)) + cylinder)
        volume = np.pi*R**2*(R*(2/3 - np.cos(phi) + np.cos(phi)**3/3) + cylinder)

        # The membrane on the lip, from the tongue to the face
        psi = np.linspace(phi, 0, 1001)
        self.r = mouth - b*np.sin(psi)
        self.areas = area + 2*np.pi*b*(mouth*(phi - psi) - b*(np.cos(psi) - np.cos(phi)))
        self.volume = volume + abs(integral(np.pi*self.r**2, b*np.cos(psi)))

    def pressure(self, r, areas, rest):
        """P/G, with the membrane outside at the radii r; rest: radius at rest by the area"""
        r = np.concatenate([self.r, r])
        areas = np.concatenate([self.areas, areas])
        square = (rest(areas)/r)**2
        return 2*integral((square - 1/square)/r, r)/self.radius

    def flat(self):
        """P/G by Evans"""
        mouth = self.r[-1]
        r = np.geomspace(mouth, 1000*mouth, 4001)[1:]
        return self.pressure(r, self.areas[-1] + np.pi*(r**2 - mouth**2),
                             lambda A: np.sqrt(A/np.pi))

    def cell(self, a0, c0):
        """P/G of a cell that is a spheroid at rest, around the axis of the pipette"""
        mouth = self.r[-1]
        rest, restAreas = spheroid(a0, c0)

        def outside(a):
            # Its half axis c from the volume, without the cap in the mouth
            def excess(c):
                cap = c*(1 - np.sqrt(1 - (mouth/a)**2))
                return (4/3*np.pi*a*a*c - np.pi*a*a*cap**2/c*(1 - cap/(3*c)) + self.volume
                        - 4/3*np.pi*a0*a0*c0)

            r, areas = spheroid(a, root(excess, 0.2*c0, 3*c0))
            return r, areas, np.interp(mouth, r, areas)

        def area(a):
            r, areas, lost = outside(a)
            return 2*areas[-1] - lost + self.areas[-1] - 2*restAreas[-1]

        r, areas, lost = outside(root(area, 0.6*a0, 1.2*a0))
        beyond = r > mouth
        return self.pressure(r[beyond], self.areas[-1] + areas[beyond] - lost,
                             lambda A: np.interp(A, restAreas, rest))


def tongues(Rp, b):
    """From short to long ones"""
    for phi in np.linspace(0.6, 0.5*np.pi, 12):
        yield Tongue(Rp, b, phi)
    for cylinder in np.linspace(0.1, 1.5, 15)*Rp:
        yield Tongue(Rp, b, 0.5*np.pi, cylinder)


def length(pressure, Rp, b, cell=None):
    """Of the tongue from the face of the pipette at P/G, by Evans or of a cell (a0, c0)"""
    rows = [(t.cell(*cell) if cell else t.flat(), t.length) for t in tongues(Rp, b)]
    return np.interp(pressure, *zip(*rows))


if __name__ == "__main__":
    print("L/Rp   P Rp/G of a flat membrane, of the cell, and with a sharp lip by Evans")
    for t in tongues(1, 0.5):
        s = 2*t.length - 1
        print("%.2f   %.2f  %.2f  %.2f" % (t.length, t.flat(), t.cell(3.6, 1.8),
                                           s + np.log(1 + s) if s > 0 else 0))
