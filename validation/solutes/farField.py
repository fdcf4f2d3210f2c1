"""Exact conditions at the faces of the box around a sphere in a Stokes flow:

    farField.py <case> <flow> <radius> <centre> <half width of the outermost mesh cells> <Pe> ...

flow is uniform, extension or shear (of a sphere free to turn), with a velocity of 1000 times the
radius per second, an axial rate or a rate of shear of 1000 1/s.
Writes the velocity (fixed) to 0/U and, for every Peclet number, the concentration to 0/c<number>.
The latter has beyond the box the form of that of a point source in the undisturbed flow, G:
c at the face over c in the mesh cell is the ratio of G at both places. Its strength is not given.
In shear, where the flow also enters the box with a concentration, the ratio does not determine it
there: c at the face is that of the source, which gives off what the theory of small Peclet numbers
says. The concentration at the start is that of the source, too.
"""

import re
import sys

import numpy as np

case, flow = sys.argv[1:3]
a, half = float(sys.argv[3]), float(sys.argv[5])
centre = np.array(sys.argv[4].split(), float)
RATE = 1000
TENSOR = {
    "uniform": np.zeros((3, 3)),
    "extension": RATE*np.diag([1, -0.5, -0.5]),
    "shear": RATE*np.array([[0, 0, 0], [1, 0, 0], [0, 0, 0]]),
}[flow]     # of the velocity x @ TENSOR
STRAIN = (TENSOR + TENSOR.T)/2
WIND = np.array([RATE*a if flow == "uniform" else 0, 0, 0])


def velocity(x):
    """Around a sphere at rest, or one that turns with the flow."""
    r = np.linalg.norm(x, axis=1)[:, None]
    q = a/r
    if flow == "uniform":
        return WIND*(1 - 0.75*q - 0.25*q**3) - x*(x @ WIND)[:, None]/r**2*0.75*(q - q**3)
    stretched = x @ STRAIN
    along = np.sum(x*stretched, axis=1)[:, None]/r**2
    return x @ TENSOR - q**5*stretched - 2.5*x*along*(q**3 - q**5)


def logarithm(x, diffusivity):
    """Of the concentration of a steady point source of 1/s in the undisturbed flow: the integral,
    over the time since its release, of the normal distribution of what was released."""
    longest = 60/RATE if flow == "extension" else 40*(24*a)**2/diffusivity
    times = np.geomspace((0.05*a)**2/diffusivity, longest, 300)
    terms = []
    for t in times:
        s = 2*diffusivity*t
        if flow == "shear":
            # Along the flow the variance is s (1 + w) in the frame that is sheared by half
            w = (RATE*t)**2/12
            along = (x[:, 0] - RATE*t*x[:, 1]/2)**2/(1 + w) + x[:, 1]**2 + x[:, 2]**2
            terms.append(-0.5*along/s - 1.5*np.log(s) - 0.5*np.log1p(w) + np.log(t))
            continue
        rates = np.diag(TENSOR)
        variances = np.array([s if k == 0 else diffusivity*np.expm1(2*k*t)/k for k in rates])
        spread = np.sum((x - WIND*t)**2/variances, axis=1)
        terms.append(-0.5*spread - 0.5*np.log(variances.prod()) + np.log(t))
    terms = np.array(terms)
    top = terms.max(axis=0)
    width = np.log(times[1]/times[0])*(2*np.pi)**-1.5
    return top + np.log(width*np.exp(terms - top).sum(axis=0))


def field(kind, name, dimensions, start, patches):
    """Write 0/<name>."""
    text = ("FoamFile { version 2.0; format ascii; class %s; object %s; }\ndimensions %s;\n"
            "internalField %s;\nboundaryField\n{\n" % (kind, name, dimensions, start))
    with open("%s/0/%s" % (case, name), "w") as file:
        file.write(text + "".join("    %s { %s }\n" % p for p in patches.items()) + "}\n")


def vectors(text):
    """Of a list of OpenFOAM, from the centre."""
    x = np.array(text.replace("(", " ").replace(")", " ").split(), float)
    return x.reshape(-1, 3) - centre


def values(kind, rows):
    """A list of OpenFOAM."""
    return "nonuniform List<%s> %d(%s)" % (kind, len(rows), " ".join(rows))


with open(case + "/0/C") as file:
    text = file.read()
faces, cells = {}, {}
for patch in [p + n for p in "xyz" for n in "01"]:
    found = re.search(patch + r"\s*\{[^}]*nonuniform List<vector>\s*\d+\s*\(([^}]*)\)\s*;", text)
    x = vectors(found.group(1))
    normal = np.zeros(3)
    normal["xyz".index(patch[0])] = 2*int(patch[1]) - 1
    faces[patch], cells[patch] = x, x - half*normal

U = {patch: velocity(x) for patch, x in faces.items()}
field("volVectorField", "U", "[0 1 -1 0 0 0 0]", "uniform (%g %g %g)" % tuple(WIND), {
    patch: "type fixedValue; value " + values("vector", ["(%.10g %.10g %.10g)" % tuple(u)
                                                       for u in rows]) + ";"
    for patch, rows in U.items()})
for number in sys.argv[6:]:
    D = RATE*a*a/float(number)
    patches, start = {}, "uniform 0"
    if flow == "shear":
        source = 4*np.pi*D*a*(1 + 0.2568*float(number)**0.5)
        inside = vectors(re.search(r"internalField[^(]*\(([^;]*)\)\s*;", text).group(1))
        start = values("scalar", ["%.6g" % min(c, 1)
                                  for c in source*np.exp(logarithm(inside, D))])
    for patch in faces:
        if flow == "shear":
            patches[patch] = ("type fixedValue; value " + values("scalar", [
                "%.8g" % c for c in source*np.exp(logarithm(faces[patch], D))]) + ";")
            continue
        ratio = np.exp(np.minimum(logarithm(faces[patch], D) - logarithm(cells[patch], D), 0))
        patches[patch] = ("type mixed; refValue uniform 0; refGradient uniform 0; value uniform 0;"
                          " valueFraction " + values("scalar", ["%.8g" % (1 - r) for r in ratio])
                          + ";")
    field("volScalarField", "c" + number, "[0 -3 0 0 1 0 0]", start, patches)
