"""A cube of n x n x n cubes, each split into six tetrahedra around the same diagonal (Kuhn), as
mesh.msh for gmshToFoam.

    tetrahedra.py <length> <n>

The pattern is the same in every cube, so that opposite sides match.
"""

import sys
from itertools import permutations, product

import numpy as np

length, n = float(sys.argv[1]), int(sys.argv[2])
number = {at: i + 1 for i, at in enumerate(product(range(n + 1), repeat=3))}
elements = []                           # kind of gmsh, number of the patch, points
for cube in product(range(n), repeat=3):
    for path in permutations(np.eye(3, dtype=int)):
        corners = [np.array(cube)]
        for step in path:
            corners.append(corners[-1] + step)
        if np.linalg.det(path) < 0:     # positive volume
            corners[2:] = corners[:1:-1]
        elements.append((4, 7, [number[tuple(c)] for c in corners]))
        for triangle in ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)):
            points = np.array([corners[i] for i in triangle])
            for side in range(6):
                if all(points[:, side//2] == n*(side % 2)):
                    elements.append((2, side + 1, [number[tuple(p)] for p in points]))

with open("mesh.msh", "w") as file:
    names = "".join('2 %d "tets_%s%d"\n' % (i + 1, "xyz"[i//2], i % 2) for i in range(6))
    file.write('$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n7\n' + names
               + '3 7 "inside"\n$EndPhysicalNames\n$Nodes\n%d\n' % len(number))
    for at, i in number.items():
        file.write("%d %.12g %.12g %.12g\n" % (i, *(length*x/n for x in at)))
    file.write("$EndNodes\n$Elements\n%d\n" % len(elements))
    for i, (kind, region, points) in enumerate(elements):
        file.write("%d %d 2 %d %d %s\n" % (i + 1, kind, region, region, " ".join(map(str, points))))
    file.write("$EndElements\n")
