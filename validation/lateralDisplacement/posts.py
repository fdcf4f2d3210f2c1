"""blockMeshDict of posts of 10 um on a square grid of 20 um, periodic in all directions.

    python3 posts.py <posts along a side> <fineness>    # 1 is the mesh of the tutorial
"""

import sys

import numpy as np

PERIOD, RADIUS, DEPTH = 20, 5, 16       # [um]
CELLS = 12, 12, 20                      # of a block: along the post, away from it, deep

posts, fineness = int(sys.argv[1]), float(sys.argv[2])
numbers = " ".join(str(round(fineness*n)) for n in CELLS)
directions = np.exp(0.25j*np.pi*np.arange(8))
edge = 0.5*PERIOD*np.array([1, 1 + 1j, 1j, -1 + 1j, -1, -1 - 1j, -1j, 1 - 1j])

places = {}             # number of a vertex, over its place; those at the back follow at the end
blocks, arcs, walls = [], [], []
sides = {"left": [], "right": [], "bottom": [], "top": []}
front = []


def vertex(place):
    return places.setdefault((round(place.real, 6), round(place.imag, 6)), len(places))


def extruded(a, b):
    return f"({a} {b} {b}b {a}b)"


for column in range(posts):
    for row in range(posts):
        middle = PERIOD*(column + 1j*row)
        inner = [vertex(middle + RADIUS*d) for d in directions]
        outer = [vertex(middle + e) for e in edge]
        for i in range(8):
            j = (i + 1) % 8
            face = f"{inner[i]} {outer[i]} {outer[j]} {inner[j]}"
            blocks.append(face)
            front.append(f"({face})")
            arc = middle + RADIUS*np.exp(0.25j*np.pi*(i + 0.5))
            arcs.append((inner[i], inner[j], arc))
            walls.append(extruded(inner[i], inner[j]))
            at = 0.5*(edge[i] + edge[j])
            side = {(1, 0): "right", (-1, 0): "left", (0, 1): "top", (0, -1): "bottom"}[
                tuple(int(2*c/PERIOD) for c in (at.real, at.imag))]
            last = {"left": column == 0, "right": column == posts - 1,
                    "bottom": row == 0, "top": row == posts - 1}[side]
            if last:
                sides[side].append(extruded(outer[i], outer[j]))


def atBack(text):
    """Vertices at the back are those in front and their number of them."""
    return " ".join(str(int(n.rstrip("b")) + len(places)) for n in text.split())


def numbered(face):
    return "(" + " ".join(atBack(n) if n.endswith("b") else n
                          for n in face.strip("()").split()) + ")"


def patch(name, faces, neighbour=None):
    kind = f"type cyclic; neighbourPatch {neighbour};" if neighbour else "type wall;"
    print(f"    {name} {{ {kind} faces ( {' '.join(map(numbered, faces))} ); }}")


print("FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }")
print("scale 1e-6;\nvertices\n(")
for z in 0, DEPTH:
    for x, y in places:
        print(f"    ({x} {y} {z})")
print(");\nblocks\n(")
for block in blocks:
    print(f"    hex ({block} {atBack(block)}) ({numbers}) simpleGrading (1 1 1)")
print(");\nedges\n(")
for a, b, place in arcs:
    for shift, z in (0, 0), (len(places), DEPTH):
        print(f"    arc {a + shift} {b + shift} ({place.real:.6f} {place.imag:.6f} {z})")
print(");\nboundary\n(")
patch("post", walls)
patch("left", sides["left"], "right")
patch("right", sides["right"], "left")
patch("bottom", sides["bottom"], "top")
patch("top", sides["top"], "bottom")
patch("front", front, "back")
patch("back", [f"({' '.join(n + 'b' for n in face.strip('()').split())})" for face in front],
      "front")
print(");")
