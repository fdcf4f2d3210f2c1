"""blockMeshDict of a part of a curved square duct, with the flow along y at its beginning.

    bend.py <radius of the middle> <angle> <width> <mesh cells across>
"""

import sys
from math import cos, sin

R, angle, width = map(float, sys.argv[1:4])
across = int(sys.argv[4])
half = width/2


def at(r, turned, z):
    return f"({r*cos(turned):.12g} {r*sin(turned):.12g} {z:.12g})"


corners = (R - half, 0), (R + half, 0), (R + half, angle), (R - half, angle)
vertices = "\n    ".join(at(r, turned, z) for z in (-half, half) for r, turned in corners)
arcs = "\n    ".join(
    f"arc {low + first} {low + second} {at(r, angle/2, z)}"
    for low, z in ((0, -half), (4, half)) for first, second, r in ((0, 3, R - half),
                                                                   (1, 2, R + half)))
print(f"""FoamFile {{ version 2.0; format ascii; class dictionary; object blockMeshDict; }}
scale 1;
vertices
(
    {vertices}
);
blocks
(
    hex (0 1 2 3 4 5 6 7) ({across} {round(R*angle/width*across)} {across}) simpleGrading (1 1 1)
);
edges
(
    {arcs}
);
boundary
(
    y0 {{ type patch; faces ((0 1 5 4)); }}
    y1 {{ type patch; faces ((3 7 6 2)); }}
    x0 {{ type wall; faces ((0 4 7 3)); }}
    x1 {{ type wall; faces ((1 2 6 5)); }}
    z0 {{ type wall; faces ((0 3 2 1)); }}
    z1 {{ type wall; faces ((4 5 6 7)); }}
);""")
