"""A still picture of spheres and triangles in space, with light and shade, without a display.

    from clumpRender import render, turned
    image, extent = render(14, lines, (x, r, colours))      # spheres, 14 pixels per unit of length
    image, extent = render(14, lines, triangles=(x, corners, colours))

The view is along a line that is tilted by 25 and 20 degrees against z. A sphere shows its own
surface; darker places are hidden from the light or lie between other surfaces. `lines`, arrays of
points, are not drawn, but the picture has room for them; turned(line) are their places in it.
"""

import numpy as np

TILT = np.radians([20, 25])         # about x, about y
LIGHT = np.array([-0.45, 0.6, 0.66])/np.linalg.norm([-0.45, 0.6, 0.66])
SHINE = np.array([-0.25, 0.33, 0.91])
NO_SPHERES = np.empty((0, 3)), np.empty(0), np.empty((0, 3))
NO_TRIANGLES = np.empty((0, 3)), np.empty((0, 3), dtype=int), np.empty((0, 3))


def turned(x):
    """Coordinates to the right, upwards and towards the eye."""
    a, b = TILT
    x = x @ np.array([[np.cos(b), 0, -np.sin(b)], [0, 1, 0], [np.sin(b), 0, np.cos(b)]])
    return x @ np.array([[1, 0, 0], [0, np.cos(a), np.sin(a)], [0, -np.sin(a), np.cos(a)]])


class Canvas:
    """The pixels with the nearest depth, its normal and its colour."""

    def __init__(self, low, high, pixels):
        (left, bottom), (right, top) = low - 0.5*14/pixels, high + 0.5*14/pixels
        self.extent, self.pixels = (left, right, bottom, top), pixels
        w, h = int((right - left)*pixels), int((top - bottom)*pixels)
        self.depth, self.normal = np.full((h, w), -1e9), np.zeros((h, w, 3))
        self.colour = np.ones((h, w, 3))
        self.px = left + (np.arange(w) + 0.5)/pixels
        self.py = bottom + (np.arange(h) + 0.5)/pixels

    def window(self, low, high):
        """Slices of the pixels in a rectangle, and their coordinates."""
        i0, i1 = np.searchsorted(self.px, [low[0], high[0]])
        j0, j1 = np.searchsorted(self.py, [low[1], high[1]])
        return (slice(j0, j1), slice(i0, i1)), *np.meshgrid(self.px[i0:i1], self.py[j0:j1])

    def draw(self, part, inside, depth, normal, colour):
        nearer = inside & (depth > self.depth[part])
        self.depth[part][nearer] = depth[nearer]
        self.normal[part][nearer] = normal[nearer]
        self.colour[part][nearer] = colour

    def sphere(self, centre, radius, colour):
        part, x, y = self.window(centre - radius, centre + radius)
        dx, dy = x - centre[0], y - centre[1]
        dz2 = radius**2 - dx**2 - dy**2
        dz = np.sqrt(np.maximum(dz2, 0))
        self.draw(part, dz2 > 0, centre[2] + dz, np.stack([dx, dy, dz], -1)/radius, colour)

    def triangle(self, corners, normals, colour):
        """A triangle whose normal is interpolated between those of its corners."""
        part, x, y = self.window(corners.min(axis=0), corners.max(axis=0))
        a, b, c = corners
        twice = (b[0] - a[0])*(c[1] - a[1]) - (c[0] - a[0])*(b[1] - a[1])
        if not x.size or abs(twice) < 1e-12:
            return
        v = ((x - a[0])*(c[1] - a[1]) - (c[0] - a[0])*(y - a[1]))/twice
        w = ((b[0] - a[0])*(y - a[1]) - (x - a[0])*(b[1] - a[1]))/twice
        weights = np.stack([1 - v - w, v, w], -1)
        self.draw(part, (weights >= 0).all(axis=-1), weights @ corners[:, 2], weights @ normals,
                  colour)

    def lit(self):
        """The picture, white where nothing is, with light from the upper left and shade where the
        surroundings lie nearer to the eye."""
        covered = self.depth > -1e8
        filled = np.where(covered, self.depth, self.depth[covered].min() if covered.any() else 0)
        shade, count = np.zeros_like(filled), 0
        for radius in 0.6, 1.2, 2.4:
            for angle in np.arange(12)*np.pi/6:
                way = radius*14
                around = np.roll(filled, (int(way*np.sin(angle)), int(way*np.cos(angle))), (0, 1))
                shade += np.clip((around - filled)*self.pixels/way, 0, 1.5)/1.5
                count += 1
        bright = (0.35 + 0.75*np.clip(self.normal @ LIGHT, 0, 1))*(1 - 0.75*shade/count)
        shine = np.clip(self.normal @ SHINE, 0, 1)**40
        image = np.clip(self.colour*bright[..., None] + 0.25*shine[..., None], 0, 1)
        image[~covered] = 1
        return image[::-1]


def vertexNormals(x, triangles):
    """Unit normals at the nodes, towards the eye."""
    a, b, c = (x[triangles[:, k]] for k in range(3))
    result = np.zeros_like(x)
    for k in range(3):
        np.add.at(result, triangles[:, k], np.cross(b - a, c - a))
    result /= np.maximum(np.linalg.norm(result, axis=1), 1e-300)[:, None]
    return result


def render(pixels, lines=(), spheres=NO_SPHERES, triangles=NO_TRIANGLES):
    """An image of spheres and triangles that has room for lines, and its extents."""
    x, r, colours = spheres
    p = turned(x)
    nodes, corners, ofNodes = triangles
    q = turned(nodes)
    normals = vertexNormals(q, corners)
    seen = np.concatenate([p - r[:, None], p + r[:, None], q] + [turned(line) for line in lines])
    canvas = Canvas(seen.min(axis=0)[:2], seen.max(axis=0)[:2], pixels)
    for centre, radius, colour in zip(p, r, colours):
        canvas.sphere(centre, radius, colour)
    for k in corners:
        canvas.triangle(q[k], normals[k], ofNodes[k[0]])
    return canvas.lit(), canvas.extent
