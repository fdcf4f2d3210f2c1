"""Writes blockMeshDict of the space between cylinders of 4 and 12 um. With the argument "turning"
the mesh cells within 7 um are a zone of their own, joined to the others by cyclicAMI."""
import math
import sys

turning = sys.argv[1] == "turning"
vertices, edges, blocks = [], {}, []
patches = {name: [] for name in ("inner", "outer", "joinA", "joinB", "back", "front")}


def place(r, quarters):
    return "%.12g %.12g" % (r*math.cos(quarters*math.pi/2), r*math.sin(quarters*math.pi/2))


def vertex(r, quarter, z, part):
    key = (r, quarter % 4, z, part if turning and r == 7 else 0)
    if key not in vertices:
        vertices.append(key)
    return vertices.index(key)


def side(v, *corners):
    return "(%s)" % " ".join(str(v[k]) for k in corners)


for part, (a, b, n) in enumerate(((4, 7, 3), (7, 12, 5))):
    for k in range(4):
        v = [vertex(r, quarter, z, part) for z in (0, 12)
             for r, quarter in ((a, k), (b, k), (b, k + 1), (a, k + 1))]
        blocks.append("hex %s %s (%d 12 12) simpleGrading (1 1 1)"
                      % (side(v, *range(8)), "" if part else "rotor", n))
        for i, j, r, z in ((0, 3, a, 0), (1, 2, b, 0), (4, 7, a, 12), (5, 6, b, 12)):
            edges[frozenset((v[i], v[j]))] = ("arc %d %d (%s %d)"
                                              % (v[i], v[j], place(r, k + 0.5), z))
        patches["joinB" if part else "inner"].append(side(v, 0, 4, 7, 3))
        patches["outer" if part else "joinA"].append(side(v, 1, 2, 6, 5))
        patches["back"].append(side(v, 0, 3, 2, 1))
        patches["front"].append(side(v, 4, 5, 6, 7))

print("FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }")
print("scale 1e-6;")
print("vertices (", *("(%s %d)" % (place(r, k), z) for r, k, z, _ in vertices), ");")
print("edges (", *edges.values(), ");")
print("blocks (", *blocks, ");")
print("boundary (")
for name, entries in (("inner", "type wall;"), ("outer", "type wall;"),
                      ("joinA", "type cyclicAMI; neighbourPatch joinB; transform noOrdering;"),
                      ("joinB", "type cyclicAMI; neighbourPatch joinA; transform noOrdering;"),
                      ("back", "type cyclic; neighbourPatch front;"),
                      ("front", "type cyclic; neighbourPatch back;")):
    if turning or not name.startswith("join"):
        print("%s { %s faces ( %s ); }" % (name, entries, " ".join(patches[name])))
print(");")
