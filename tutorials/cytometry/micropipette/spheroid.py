"""Writes constant/cell.obj, a spheroid around x: an icosphere that is stretched.

    spheroid.py <half its thickness> <half its width> <subdivisions>
"""

import sys

import numpy as np

GOLDEN = (1 + 5**0.5)/2
NODES = [(-1, GOLDEN, 0), (1, GOLDEN, 0), (-1, -GOLDEN, 0), (1, -GOLDEN, 0),
         (0, -1, GOLDEN), (0, 1, GOLDEN), (0, -1, -GOLDEN), (0, 1, -GOLDEN),
         (GOLDEN, 0, -1), (GOLDEN, 0, 1), (-GOLDEN, 0, -1), (-GOLDEN, 0, 1)]
TRIANGLES = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]

thickness, width, subdivisions = float(sys.argv[1]), float(sys.argv[2]), int(sys.argv[3])
nodes = [np.array(p)/np.linalg.norm(p) for p in NODES]
triangles = TRIANGLES
for _ in range(subdivisions):
    middles = {}

    def middle(i, j):
        """Node in the middle of an edge"""
        edge = min(i, j), max(i, j)
        if edge not in middles:
            middles[edge] = len(nodes)
            p = nodes[i] + nodes[j]
            nodes.append(p/np.linalg.norm(p))
        return middles[edge]

    finer = []
    for i, j, k in triangles:
        a, b, c = middle(i, j), middle(j, k), middle(k, i)
        finer += [(i, a, c), (j, b, a), (k, c, b), (a, b, c)]
    triangles = finer

with open("constant/cell.obj", "w") as file:
    for p in nodes:
        file.write("v %.12g %.12g %.12g\n" % (thickness*p[0], width*p[1], width*p[2]))
    for t in triangles:
        file.write("f %d %d %d\n" % tuple(i + 1 for i in t))
