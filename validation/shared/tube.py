"""blockMeshDict of a round tube along x with a square core, on standard output:

    python3 tube.py <cell width> <x:radius> <x:radius> ...

Lengths in um. The radius goes linearly from station to station; inlet and outlet are cyclic; the
number of cells across is that of the widest station.
"""

import argparse
import math


def station(word):
    x, radius = word.split(":")
    return float(x), float(radius)


options = argparse.ArgumentParser(
    description=__doc__, usage=argparse.SUPPRESS, add_help=False,
    formatter_class=argparse.RawDescriptionHelpFormatter)
options.add_argument("-help", action="help", help=argparse.SUPPRESS)
options.add_argument("width", type=float)
options.add_argument("first", type=station)
options.add_argument("others", type=station, nargs="+")
given = options.parse_args()
width, stations = given.width, [given.first] + given.others
widest = max(r for _, r in stations)

core = 0.65                                             # half the core's diagonal over the radius
across = max(2, round(math.pi*widest/2/width*0.85))     # cells along a quarter of the wall
radial = max(2, round(1.5*(1 - core)*widest/width))

print('''FoamFile
{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      blockMeshDict;
}

// Round tube along x; station by station four corners of the core, four on the wall

scale   1e-6;

vertices
(''')
for x, r in stations:
    print(f"    // x {x:g}, radius {r:g}")
    for part in core, 1:
        for k in range(4):
            angle = math.pi/4 + k*math.pi/2
            print(f"    ({x:g} {part*r*math.cos(angle):.6g} {part*r*math.sin(angle):.6g})")
print(");\n\nblocks\n(")
for s in range(len(stations) - 1):
    length = stations[s + 1][0] - stations[s][0]
    n = max(1, round(length/width))
    a, b = 8*s, 8*(s + 1)

    def block(*corners, cells):
        left = " ".join(str(a + c) for c in corners)
        right = " ".join(str(b + c) for c in corners)
        # x is the third direction, so that corners run around it
        print(f"    hex ({left} {right}) ({cells[0]} {cells[1]} {n}) simpleGrading (1 1 1)")

    block(0, 1, 2, 3, cells=(across, across))
    for k in range(4):
        block(4 + k, 4 + (k + 1) % 4, (k + 1) % 4, k, cells=(across, radial))
print(");\n\nedges\n(")
for s, (x, r) in enumerate(stations):
    for k in range(4):
        angle = (k + 1)*math.pi/2
        print(f"    arc {8*s + 4 + k} {8*s + 4 + (k + 1) % 4} "
              f"({x:g} {r*math.cos(angle):.6g} {r*math.sin(angle):.6g})")
print(");\n\nboundary\n(")


def faces(station):
    a = 8*station
    return [(a, a + 1, a + 2, a + 3)] + [(a + 4 + k, a + 4 + (k + 1) % 4, a + (k + 1) % 4, a + k)
                                         for k in range(4)]


def patch(name, entries, quads):
    print(f"    {name}\n    {{")
    for entry in entries:
        print(f"        {entry}")
    print("        faces\n        (")
    for quad in quads:
        print("            (" + " ".join(map(str, quad)) + ")")
    print("        );\n    }")


last = len(stations) - 1
patch("inlet", ["type            cyclic;", "neighbourPatch  outlet;"], faces(0))
patch("outlet", ["type            cyclic;", "neighbourPatch  inlet;"], faces(last))
patch("walls", ["type            wall;"],
      [(8*s + 4 + k, 8*s + 4 + (k + 1) % 4, 8*(s + 1) + 4 + (k + 1) % 4, 8*(s + 1) + 4 + k)
       for s in range(last) for k in range(4)])
print(");")
