#!/usr/bin/python3
"""A capsule in Stokes flow (u = y, 0, 0) over time, by boundary integrals without a mesh.

The membrane is a map x(s) of the unit sphere, which is its state without strain, in spherical
harmonics up to a degree. Its force per area at rest is the projection of Div P onto them, so that
its power is minus the rate of change of the strain energy, and of the bending energy

    E = kappa/2 int (2 H - c0)^2 dS

with the mean curvature H, 1 for a sphere. Lengths are in radii, times in shear times, stresses in
outer viscosities times the shear rate, kappa in shear moduli times the radius squared; L is the
inner over the outer viscosity, n the outward normal, G and T the velocity and the stress of a
force (Pozrikidis 1992):

    u(x0) = 2/(1 + L) u_inf(x0) + 1/(4 pi (1 + L)) int G f dS0
                                + (1 - L)/(4 pi (1 + L)) int u.T.n dS

Every node is the pole of a grid of its own, on which the integrands are smooth, so that the
quadrature converges as fast as the harmonics do. Time steps are explicit, of the third order.

Prints a row per 0.2 shear times: D, the semi-axes in and across the plane of the shear and the
inclination of the ellipsoid with the same second moments of volume, and the change of the volume.
"""

import argparse

import numpy as np


def legendre(degree, theta):
    """Normalised associated Legendre functions over degree, order and point, and their
    derivatives."""
    s, c = np.sin(theta), np.cos(theta)
    P = np.zeros((degree + 1, degree + 2, theta.size))
    P[0, 0] = np.sqrt(0.25/np.pi)
    for m in range(1, degree + 1):
        P[m, m] = -np.sqrt((2*m + 1)/(2*m))*s*P[m - 1, m - 1]
    for m in range(degree):
        P[m + 1, m] = np.sqrt(2*m + 3)*c*P[m, m]
        for k in range(m + 2, degree + 1):
            a = np.sqrt((4*k*k - 1)/(k*k - m*m))
            b = np.sqrt(((k - 1)**2 - m*m)/(4*(k - 1)**2 - 1))
            P[k, m] = a*(c*P[k - 1, m] - b*P[k - 2, m])
    D = np.zeros_like(P)
    for k in range(degree + 1):
        for m in range(k + 1):
            down = P[k, m - 1] if m else -P[k, 1]
            D[k, m] = 0.5*(np.sqrt((k - m)*(k + m + 1))*P[k, m + 1]
                           - np.sqrt((k + m)*(k - m + 1))*down)
    return P, D


def modes(degree, theta, phi):
    """Of every real spherical harmonic: degree and order, its function of theta and the derivative,
    its wave in phi and the derivative."""
    P, D = legendre(degree, theta)
    for k in range(degree + 1):
        for m in range(-k, k + 1):
            n = abs(m)
            scale = np.sqrt(2) if m else 1
            wave, turned = np.cos(n*phi), -n*np.sin(n*phi)
            if m < 0:
                wave, turned = np.sin(n*phi), n*np.cos(n*phi)
            yield k, n, scale*P[k, n], scale*D[k, n], wave, turned


def harmonics(degree, theta, phi):
    """Real spherical harmonics at points (points x harmonics), and their gradients on the sphere
    (direction x points x harmonics)."""
    st, ct, sp, cp = np.sin(theta), np.cos(theta), np.sin(phi), np.cos(phi)
    along = np.array([ct*cp, ct*sp, -st])
    around = np.array([-sp, cp, 0*phi])/st
    values, gradients = [], []
    for _, _, P, D, wave, turned in modes(degree, theta, phi):
        values.append(P*wave)
        gradients.append(D*wave*along + P*turned*around)
    return np.array(values).T, np.moveaxis(np.array(gradients), 0, -1)


def parameterDerivatives(degree, theta, phi):
    """First and second derivatives of the real spherical harmonics by theta and phi: theta, phi,
    theta theta, theta phi, phi phi (derivative x points x harmonics)."""
    st, cotangent = np.sin(theta), 1/np.tan(theta)
    result = []
    for k, n, P, D, wave, turned in modes(degree, theta, phi):
        DD = -cotangent*D - (k*(k + 1) - (n/st)**2)*P
        result.append([D*wave, P*turned, DD*wave, D*turned, -n*n*P*wave])
    return np.moveaxis(np.array(result), 0, -1)


def points(theta, phi):
    return np.array([np.sin(theta)*np.cos(phi), np.sin(theta)*np.sin(phi), np.cos(theta)]).T


def sphereGrid(degree):
    """Gauss-Legendre latitudes times equal longitudes: theta, phi, weights."""
    c, w = np.polynomial.legendre.leggauss(degree + 1)
    n = 2*degree + 2
    theta, phi = np.meshgrid(np.arccos(c), 2*np.pi*np.arange(n)/n, indexing="ij")
    return theta.ravel(), phi.ravel(), np.repeat(w, n)*2*np.pi/n


def forceVelocity(r):
    """G: velocity times 8 pi of a unit force, over the vectors r from it."""
    d = np.linalg.norm(r, axis=-1)[..., None, None]
    return np.eye(3)/d + r[..., :, None]*r[..., None, :]/d**3


def wallImage(x, y, distance):
    """What a wall at rest at y = -distance adds to G (Blake 1971)."""
    e = np.array([0, 1, 0])
    h = (y[..., 1] + distance)[..., None, None]
    R = x - y + 2*h[..., 0]*e
    d = np.linalg.norm(R, axis=-1)[..., None, None]
    R1, RR = R[..., 1, None, None], R[..., :, None]*R[..., None, :]
    dipole = np.eye(3)/d**3 - 3*RR/d**5
    doublet = ((R1*np.eye(3) + R[..., :, None]*e - e[:, None]*R[..., None, :])/d**3
               - 3*R1*RR/d**5)
    return -forceVelocity(R) + 2*h*(h*dipole - doublet)@np.diag([1, -1, 1])


class Box:
    """What the walls and the periodic neighbours of a box (height, length, depth) add to the
    velocity at x of a force at y: images in either wall, not those from wall to wall, as in the
    table of triangles. Around the middle that is a polynomial of the fifth degree in x and y,
    within 0.3 % of it in a box six radii high."""

    degree, size, nSamples = 5, 1.7, 150

    def __init__(self, height, length, depth):
        order = range(self.degree + 1)
        self.powers = np.array([(i, j, k) for i in order for j in order for k in order
                                if i + j + k <= self.degree])
        samples = np.random.default_rng(1).normal(size=(self.nSamples, 3))
        samples *= (self.size*np.linspace(0.1, 1, self.nSamples)**(1/3)
                    /np.linalg.norm(samples, axis=1))[:, None]
        x, y = samples[:, None], samples[None]
        up = np.array([1, -1, 1])
        images = 0
        for i in range(-2, 3):
            for k in range(-2, 3):
                shifted = y + np.array([i*length, 0, k*depth])
                images = images + wallImage(x, shifted, height/2)
                images += up[:, None]*wallImage(up*x, up*shifted, height/2)*up
                if i or k:
                    images += forceVelocity(x - shifted)
        fit = np.linalg.pinv(self.monomials(samples))
        self.response = np.einsum("as,stij,bt->aibj", fit, images, fit, optimize=True)

    def monomials(self, x):
        return np.prod((x/self.size)[:, None]**self.powers, axis=2)

    def gradients(self, x):
        lower = np.maximum(self.powers - np.eye(3, dtype=int)[:, None], 0)
        return np.array([np.prod((x/self.size)[:, None]**lower[k], axis=2)*self.powers[:, k]
                         for k in range(3)])/self.size

    def velocity(self, x, forces, dipoles):
        """At x, of forces and of dipoles (force x arm) at x."""
        sources = self.monomials(x).T@forces
        sources += np.einsum("ksb,sjk->bj", self.gradients(x), dipoles)
        return self.monomials(x)@np.einsum("aibj,bj->ai", self.response, sources)/(8*np.pi)


class Capsule:

    def __init__(self, law, ratio, Ca, degree, box, bending=0, curvature=0):
        self.law, self.ratio, self.Ca = law, ratio, Ca
        self.bending, self.curvature = bending/Ca, curvature
        self.box = Box(*box) if box else None
        theta, phi, self.weights = sphereGrid(degree)
        self.nTheta, self.nPhi = degree + 1, 2*degree + 2
        self.start = points(theta, phi)
        self.synthesis, _ = harmonics(degree, theta, phi)
        self.analysis = self.synthesis.T*self.weights

        # The membrane's stress is a product of many factors: on a grid twice as fine
        fineTheta, finePhi, self.fineWeights = sphereGrid(2*degree)
        self.fine, self.gradients = harmonics(degree, fineTheta, finePhi)
        self.sphere = points(fineTheta, finePhi)
        if bending:
            self.derivatives = parameterDerivatives(degree, fineTheta, finePhi)
            self.parameterWeights = self.fineWeights/np.sin(fineTheta)

        # Grids around a node of every latitude at phi = 0: equal steps of longitude, Gauss' rule
        # in the angle from the pole, whose sine takes away the singularity
        c, w = np.polynomial.legendre.leggauss(2*degree)
        angle, turn = np.meshgrid(0.5*np.pi*(c + 1), np.pi*(np.arange(4*degree) + 0.5)/(2*degree),
                                  indexing="ij")
        self.poleWeights = (np.repeat(0.5*np.pi*w, 4*degree)*np.sin(angle.ravel())
                            *np.pi/(2*degree))
        local = points(angle.ravel(), turn.ravel())
        self.around = []
        for t in theta[::self.nPhi]:
            toPole = np.array([[np.cos(t), 0, np.sin(t)], [0, 1, 0], [-np.sin(t), 0, np.cos(t)]])
            p = local@toPole.T
            values, _ = harmonics(degree, np.arccos(p[:, 2]), np.arctan2(p[:, 1], p[:, 0]))
            self.around.append(values@self.analysis)
        longitudes = np.arange(self.nPhi)
        self.shifts = (longitudes[:, None] + longitudes) % self.nPhi

    def membrane(self, x):
        """At the nodes: force per area at rest and n dS/dS0; volume and its second moments."""
        coefficients = self.analysis@x
        F = np.einsum("jqk,ki->qij", self.gradients, coefficients)
        C = np.einsum("qai,qaj->qij", F, F)
        trace = np.trace(C, axis1=1, axis2=2)
        J2 = 0.5*(trace**2 - np.einsum("qij,qji->q", C, C))     # (dS/dS0)^2
        if self.law == "NH":    # W = (trace + 1/J2 - 3)/2
            dTrace, dJ2 = 0.5, -0.5/J2**2
        else:                   # W = (I1^2 + 2 I1 - 2 I2 + I2^2)/4, I1 = trace - 2, I2 = J2 - 1
            dTrace, dJ2 = 0.5*(trace - 1), 0.5*(J2 - 2)
        P = 2*((dTrace + dJ2*trace)[:, None, None]*F - dJ2[:, None, None]*(F@C))/self.Ca
        force = -np.einsum("jqk,qij,q->ki", self.gradients, P, self.fineWeights, optimize=True)

        side = np.cross(np.eye(3)[np.argmin(abs(self.sphere), axis=1)], self.sphere)
        side /= np.linalg.norm(side, axis=1)[:, None]
        other = np.cross(self.sphere, side)
        normal = np.cross(np.einsum("qij,qj->qi", F, side), np.einsum("qij,qj->qi", F, other))

        y = self.fine@coefficients
        dV = np.einsum("qi,qi,q->q", y, normal, self.fineWeights)
        volume = dV.sum()/3
        moments = np.einsum("q,qi,qj->ij", dV, y, y)/5
        smooth = self.fine.T@(self.fineWeights[:, None]*normal)
        if self.bending:
            force += self.bendingForce(coefficients)
        return self.synthesis@force, self.synthesis@smooth, volume, moments

    def bendingForce(self, coefficients):
        """Minus the derivative of the bending energy by the coefficients. With the tangents a_i,
        i = theta, phi, the metric g_ij, its determinant J^2, b_ij = x_,ij.n and C = 2 H = -g^ij
        b_ij, the derivatives of kappa/2 (C - c0)^2 J by the tangents and by x_,ij are

            kappa (C - c0) J (2 b^ki a_k + g^kl Gamma^i_kl n) + kappa/2 (C - c0)^2 J a^i
            -kappa (C - c0) J g^ij n
        """
        x = np.einsum("dqk,ki->dqi", self.derivatives, coefficients)
        a, second = x[:2], x[[2, 3, 3, 4]].reshape(2, 2, -1, 3)
        normal = np.cross(a[0], a[1])
        J = np.linalg.norm(normal, axis=1)
        normal /= J[:, None]
        inverse = np.linalg.inv(np.einsum("iqx,jqx->qij", a, a))
        upper = np.einsum("qij,jqx->iqx", inverse, a)
        b = np.einsum("ijqx,qx->qij", second, normal)
        C = -np.einsum("qij,qij->q", inverse, b)
        factor = self.bending*(C - self.curvature)*J
        byTangent = (2*np.einsum("qij,qjk,kqx->iqx", inverse, b, upper)
                     + np.einsum("qkl,klqx,iqx->iq", inverse, second, upper)[..., None]*normal)
        byTangent = (factor[:, None]*byTangent
                     + (0.5*factor*(C - self.curvature))[:, None]*upper)
        bySecond = -(factor*np.moveaxis(inverse, 0, 2))[..., None]*normal
        stress = np.array([*byTangent, bySecond[0, 0], 2*bySecond[0, 1], bySecond[1, 1]])
        return -np.einsum("dqk,dqx,q->kx", self.derivatives, stress, self.parameterWeights,
                          optimize=True)

    def onGrids(self, latitude, fields):
        """Fields (nodes x components) on the grids around the nodes of a latitude."""
        n = fields.shape[1]
        turned = fields.reshape(self.nTheta, self.nPhi, n)[:, self.shifts]
        turned = turned.transpose(0, 2, 1, 3).reshape(self.nTheta*self.nPhi, -1)
        return (self.around[latitude]@turned).reshape(-1, self.nPhi, n).transpose(1, 0, 2)

    def velocity(self, x, guess):
        """At the nodes; guess is a velocity near it."""
        L = self.ratio
        force, normal, *_ = self.membrane(x)
        u = 2/(1 + L)*x[:, 1:2]*np.array([1, 0, 0])
        kernels = []
        for i in range(self.nTheta):
            rows = slice(i*self.nPhi, (i + 1)*self.nPhi)
            grids = self.onGrids(i, np.hstack((x, force, normal)))
            r, f, n = grids[..., :3] - x[rows, None], grids[..., 3:6], grids[..., 6:]
            d = np.linalg.norm(r, axis=2)
            rf = np.einsum("jqi,jqi->jq", r, f)
            u[rows] += np.einsum("q,jqi->ji", self.poleWeights,
                                 f/d[..., None] + (rf/d**3)[..., None]*r)/(4*np.pi*(1 + L))
            kernels.append((r, -6*self.poleWeights*np.einsum("jqi,jqi->jq", r, n)/d**5))
        if self.box:
            w = self.weights[:, None]
            outer = guess[:, :, None]*normal[:, None]
            dipoles = (1 - L)*(outer + outer.transpose(0, 2, 1))
            u += 2/(1 + L)*self.box.velocity(x, w*force, w[..., None]*dipoles)
        if L == 1:
            return u

        def doubleLayer(v):
            result = np.empty_like(v)
            for i, (r, k) in enumerate(kernels):
                on = self.onGrids(i, v)
                result[i*self.nPhi:(i + 1)*self.nPhi] = np.einsum(
                    "jq,jqi->ji", k*np.einsum("jqi,jqi->jq", r, on), r)
            return (1 - L)/(4*np.pi*(1 + L))*result

        return solve(doubleLayer, u, guess)

    def step(self, x, u, dt):
        """State and velocity after a step of dt (Ralston's method)."""
        first = self.velocity(x, u)
        second = self.velocity(x + dt/2*first, first)
        third = self.velocity(x + 0.75*dt*second, second)
        x = x + dt/9*(2*first + 3*second + 4*third)
        return self.synthesis@(self.analysis@x), third

    def shape(self, x):
        """D, semi-axes, inclination in degrees and volume."""
        *_, volume, moments = self.membrane(x)
        squares, axes = np.linalg.eigh(5*moments[:2, :2]/volume)
        B, L = np.sqrt(squares)
        return ((L - B)/(L + B), L, B, np.sqrt(5*moments[2, 2]/volume),
                np.degrees(np.arctan2(axes[1, 1], axes[0, 1])) % 180, volume)


def solve(apply, b, v, tolerance=1e-7):
    """v - apply(v) = b by GMRES."""
    residual = b + apply(v) - v
    size = np.linalg.norm(residual)
    basis, H = [residual/max(size, 1e-300)], np.zeros((51, 50))
    y = np.zeros(0)
    for k in range(50):
        error = np.linalg.norm(H[:k + 1, :k]@y - size*np.eye(k + 1)[0])
        if error <= tolerance*np.linalg.norm(b):
            break
        q = basis[k] - apply(basis[k])
        for j in range(k + 1):
            H[j, k] = np.sum(basis[j]*q)
            q -= H[j, k]*basis[j]
        H[k + 1, k] = np.linalg.norm(q)
        basis.append(q/H[k + 1, k])
        y = np.linalg.lstsq(H[:k + 2, :k + 1], size*np.eye(k + 2)[0], rcond=None)[0]
    return v + sum(a*q for a, q in zip(y, basis))


def main():
    options = argparse.ArgumentParser(
        description=__doc__, add_help=False, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("-h", "-help", "--help", action="help", help="prints this text")
    options.add_argument("law", choices=("NH", "SK"), help="neo-Hookean, or Skalak with C = 1")
    options.add_argument("ratio", type=float, help="inner over outer viscosity")
    options.add_argument("Ca", type=float, help="capillary number")
    options.add_argument("degree", type=int, help="of the spherical harmonics")
    options.add_argument("step", type=float)
    options.add_argument("end", type=float)
    options.add_argument("box", type=float, nargs="*",
                         help="height, length and depth of a box; unbounded if absent")
    options.add_argument("-bending", type=float, default=0, help="kappa")
    options.add_argument("-curvature", type=float, default=0, help="c0")
    given = options.parse_args()
    capsule = Capsule(given.law, given.ratio, given.Ca, given.degree, given.box,
                      given.bending, given.curvature)
    x = capsule.start
    u = 0*x
    head = (f"{given.law},{given.ratio:g},{given.Ca:g},{given.bending:g},{given.curvature:g},"
            + ",".join(f"{side:g}" for side in given.box or (0, 0, 0)))
    every = round(0.2/given.step)
    for n in range(round(given.end/given.step) + 1):
        if n % every == 0 and n > 0:
            *shape, angle, volume = capsule.shape(x)
            print(f"{head},{given.degree},{n*given.step:.1f},"
                  + ",".join(f"{value:.5f}" for value in shape)
                  + f",{angle:.2f},{volume/(4*np.pi/3) - 1:.1e}", flush=True)
        x, u = capsule.step(x, u, given.step)


if __name__ == "__main__":
    main()
