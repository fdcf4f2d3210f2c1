"""What walls and periodic images change about the flow of a force, at zero Reynolds number.

Walls at y = +-H and periods in x and z enter as the difference between the velocity of a force in
the slit and in free space, which is smooth. Both are velocities of a Gaussian force, the first by
Fourier series in x and z and Chebyshev collocation in y,

    mu (D^2 - k^2)^2 v = i kx D f,     mu (D^2 - k^2) eta = -i kz f,     u = i (kx D v - kz eta)/k^2

with v = D v = eta = 0 at the walls; the mean flow (k = 0) keeps its flux.
"""

from math import erf
import numpy as np


def chebyshev(n):
    """Points on [-1, 1] and the differentiation matrix (Trefethen, Spectral Methods in Matlab,
    2000)."""
    x = np.cos(np.pi*np.arange(n + 1)/n)
    c = np.hstack([2, np.ones(n - 1), 2])*(-1)**np.arange(n + 1)
    X = np.tile(x, (n + 1, 1)).T
    D = np.outer(c, 1/c)/(X - X.T + np.eye(n + 1))
    return x, D - np.diag(D.sum(axis=1))


class Slit:
    """Velocity along x at mid-height per force along x at mid-height, in the slit minus in free
    space."""

    def __init__(self, mu, lx, height, lz, width=1.5, n=64):
        h = height/2
        points, D = chebyshev(n)
        y, D = h*points, D/h
        D2 = D @ D
        inner = slice(1, n)
        middle = n//2
        f = np.exp(-y**2/(2*width**2))/(np.sqrt(2*np.pi)*width)

        # v = (1 - (y/h)^2) q builds in v = D v = 0 with q = 0 at the walls
        s = 1 - points[inner]**2
        D4 = (np.diag(1 - points**2) @ np.linalg.matrix_power(D, 4)
              - np.diag(8*points/h) @ np.linalg.matrix_power(D, 3)
              - 12/h**2*D2)[inner, inner] @ np.diag(1/s)

        # Flux-free mean flow: mu u'' = -f + G
        u = np.zeros((2, n + 1))
        A = mu*D2[inner, inner]
        u[0, inner] = np.linalg.solve(A, -f[inner])
        u[1, inner] = np.linalg.solve(A, np.ones(n - 1))
        moments = np.array([(1 - (-1)**(j + 1))/(j + 1) for j in range(n + 1)])
        weights = np.linalg.lstsq(
            np.vander(points, n + 1, increasing=True).T, moments, rcond=None)[0]
        flux = u @ weights
        mean = (u[0] - flux[0]/flux[1]*u[1])[middle]/(lx*lz)

        modes = []
        top = 4.5/width
        for i in range(int(top*lx/(2*np.pi)) + 1):
            for j in range(int(top*lz/(2*np.pi)) + 1):
                kx, kz = 2*np.pi*i/lx, 2*np.pi*j/lz
                k2 = kx**2 + kz**2
                if k2 == 0:
                    continue
                g = f*np.exp(-k2*width**2/2)
                L = D2[inner, inner] - k2*np.eye(n - 1)
                biharmonic = D4 - 2*k2*D2[inner, inner] + k2**2*np.eye(n - 1)
                v, eta = np.zeros(n + 1), np.zeros(n + 1)
                v[inner] = np.linalg.solve(mu*biharmonic, kx*(D @ g)[inner])
                eta[inner] = np.linalg.solve(mu*L, -kz*g[inner])
                # v and eta stand for i v and i eta
                value = -(kx*(D @ v)[middle] - kz*eta[middle])/k2
                modes.append((kx, value*(2 if i else 1)*(2 if j else 1)/(lx*lz)))

        # Velocity of the same force in free space, along its direction
        dx = np.linspace(0, lx, 1001)
        r = np.maximum(dx, 1e-3*width)/(np.sqrt(2)*width)
        a, b = np.vectorize(erf)(r), 2*r*np.exp(-r**2)/np.sqrt(np.pi)
        free = (2*a - (a - b)/r**2)/(8*np.pi*mu*np.sqrt(2)*width*r)
        self.dx = dx
        self.values = mean - free + sum(value*np.cos(kx*dx) for kx, value in modes)

    def correction(self, dx):
        return np.interp(abs(dx), self.dx, self.values)


if __name__ == '__main__':
    # Checks: no slip of a lone sphere; wall correction of Faxen, k = 1.004; Hasimoto-like decay
    mu = 1.2e-3
    wide = Slit(mu, 400, 50, 400)
    wall = -wide.correction(0)*6*np.pi*mu*25
    print('walls alone, F/F_inf - 1 per a/H: %.4f (Faxen 1.004)' % wall)
