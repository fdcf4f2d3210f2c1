"""The nodes of a red cell (shape biconcave) where it is pulled: nodes.py <subdivisions> <part>, the
part of all nodes that is nearest to either end along x."""
import sys
from math import sqrt

subdivisions, part = int(sys.argv[1]), float(sys.argv[2])

# The order of the nodes is that of surfaceShape::setIcosphere
g = (1 + sqrt(5))/2
points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g),
          (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]


def unit(p):
    size = sqrt(sum(c*c for c in p))
    return tuple(c/size for c in p)


points = [unit(p) for p in points]
for _ in range(subdivisions):
    middles, finer = {}, []

    def middle(i, j):
        key = min(i, j), max(i, j)
        if key not in middles:
            middles[key] = len(points)
            points.append(unit([u + v for u, v in zip(points[i], points[j])]))
        return middles[key]

    for i, j, k in triangles:
        a, b, c = middle(i, j), middle(j, k), middle(k, i)
        finer += [(i, a, c), (j, b, a), (k, c, b), (a, b, c)]
    triangles = finer

order = sorted(range(len(points)), key=lambda i: points[i][0])
n = round(part*len(points))
print(f"plus ({' '.join(map(str, order[-n:]))}); minus ({' '.join(map(str, order[:n]))});")
