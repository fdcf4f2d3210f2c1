"""Draws the clumps of VTK/clumps in their channel, with the profiles of the run:

    python3 picture.py tube|slit            result.png: the last time, profiles beside it
    python3 picture.py tube|slit animation  animation.gif: every time of VTK/clumps

The view is along a line that is tilted by 25 and 20 degrees against z. A sphere shows its own
surface; darker places are hidden from the light or lie between other clumps. The colour is the
velocity of the clump along x. Walls are drawn as outlines.
"""

import glob
import re
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.animation import PillowWriter
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

PIXELS = 14                         # per um
TILT = np.radians([20, 25])         # about x, about y
COLOURS = plt.cm.Reds(np.linspace(0.35, 1, 256))[:, :3]


def turned(x):
    """Coordinates to the right, upwards and towards the eye."""
    a, b = TILT
    x = x @ np.array([[np.cos(b), 0, -np.sin(b)], [0, 1, 0], [np.sin(b), 0, np.cos(b)]])
    return x @ np.array([[1, 0, 0], [0, np.cos(a), np.sin(a)], [0, -np.sin(a), np.cos(a)]])


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()

    def of(name):
        return vtk_to_numpy(data.GetPointData().GetArray(name))
    return (1e6*vtk_to_numpy(data.GetPoints().GetData()).astype(float), 1e6*of("radius"),
            of("U")[:, 0], of("clump"))


def outline(tube, low, high):
    """Lines of the walls, in space."""
    if tube:
        t = np.linspace(0, 2*np.pi, 200)
        middle, r = (low + high)/2, (high - low)[1]/2
        rings = [np.stack([np.full_like(t, x), middle[1] + r*np.cos(t), middle[2] + r*np.sin(t)], 1)
                 for x in (low[0], high[0])]
        # The two lines along the tube that bound its projection
        sides = [np.array([ring[k] for ring in rings])
                 for k in (np.argmin(turned(rings[0])[:, 1]), np.argmax(turned(rings[0])[:, 1]))]
        return rings + sides
    lines = []
    for y in (low[1], high[1]):
        corners = [(low[0], low[2]), (high[0], low[2]), (high[0], high[2]), (low[0], high[2])]
        lines.append(np.array([(x, y, z) for x, z in corners + corners[:1]]))
    return lines


def render(x, r, colours, lines):
    """An image of spheres that has room for lines, and its extents."""
    p = turned(x)
    seen = np.concatenate([p - r[:, None], p + r[:, None]] + [turned(line) for line in lines])
    left, bottom = seen.min(axis=0)[:2] - 0.5
    right, top = seen.max(axis=0)[:2] + 0.5
    w, h = int((right - left)*PIXELS), int((top - bottom)*PIXELS)
    depth = np.full((h, w), -1e9)
    normal = np.zeros((h, w, 3))
    colour = np.ones((h, w, 3))
    px = left + (np.arange(w) + 0.5)/PIXELS
    py = bottom + (np.arange(h) + 0.5)/PIXELS
    for centre, radius, c in zip(p, r, colours):
        i0, i1 = np.searchsorted(px, [centre[0] - radius, centre[0] + radius])
        j0, j1 = np.searchsorted(py, [centre[1] - radius, centre[1] + radius])
        dx, dy = np.meshgrid(px[i0:i1] - centre[0], py[j0:j1] - centre[1])
        dz2 = radius**2 - dx**2 - dy**2
        dz = np.sqrt(np.maximum(dz2, 0))
        part = (slice(j0, j1), slice(i0, i1))
        nearer = (dz2 > 0) & (centre[2] + dz > depth[part])
        depth[part][nearer] = (centre[2] + dz)[nearer]
        normal[part][nearer] = (np.stack([dx, dy, dz], -1)/radius)[nearer]
        colour[part][nearer] = c

    # Light from the upper left, and shade where the surroundings lie nearer to the eye
    covered = depth > -1e8
    ground = depth[covered].min() if covered.any() else 0
    filled = np.where(covered, depth, ground)
    shade = np.zeros_like(filled)
    count = 0
    for radius in 0.6, 1.2, 2.4:
        for angle in np.arange(12)*np.pi/6:
            shift = (int(radius*PIXELS*np.sin(angle)), int(radius*PIXELS*np.cos(angle)))
            around = np.roll(filled, shift, (0, 1)) - filled
            shade += np.clip(around/radius, 0, 1.5)/1.5
            count += 1
    light = np.array([-0.45, 0.6, 0.66])
    diffuse = np.clip(normal @ (light/np.linalg.norm(light)), 0, 1)
    shine = np.clip(normal @ np.array([-0.25, 0.33, 0.91]), 0, 1)**40
    bright = (0.35 + 0.75*diffuse)*(1 - 0.75*shade/count)
    image = np.clip(colour*bright[..., None] + 0.25*shine[..., None], 0, 1)
    image[~covered] = 1
    return image[::-1], (left, right, bottom, top)


def draw(axes, path, tube, low, high, speeds):
    x, r, u, clump = read(path)
    number = clump.astype(int)
    mean = np.bincount(number, u)/np.maximum(np.bincount(number), 1)
    share = np.clip((mean[number] - speeds[0])/(speeds[1] - speeds[0]), 0, 1)
    lines = outline(tube, low, high)
    image, extent = render(x, r, COLOURS[(255*share).astype(int)], lines)
    axes.imshow(image, extent=extent, interpolation="bilinear")
    for line in lines:
        q = turned(line)
        axes.plot(q[:, 0], q[:, 1], color="0.35", lw=1, alpha=0.7)
    axes.set_axis_off()


def rows(table):
    """Rows of a table as dictionaries."""
    (path,) = glob.glob(f"postProcessing/{table}/0/*.dat")
    names, result = [], []
    with open(path) as file:
        for line in file:
            cells = line.lstrip("# ").rstrip("\n").split("\t")
            if re.match(r"[-\d]", line):
                result.append({n: float(c) for n, c in zip(names, cells)})
            else:
                names = [re.sub(r" *\[.*", "", cell) for cell in cells]
    return result


def profile(last, column):
    """Positions and means of a profile over the second half of the run."""
    chosen = [row for row in rows("clumpProfiles") if row["time"] > last/2]
    bins = sorted({row["bin"] for row in chosen})
    parts = [[row for row in chosen if row["bin"] == k] for k in bins]
    return ([1e6*part[0]["s"] for part in parts],
            [np.nanmean([row[column] for row in part]) for part in parts])


def main():
    tube, moving = sys.argv[1] == "tube", "animation" in sys.argv
    files = sorted(glob.glob("VTK/clumps/spheres_*.vtp"),
                   key=lambda f: int(re.findall(r"_(\d+)\.vtp", f)[0]))
    with open("VTK/clumps/spheres.vtp.series") as series:
        times = [float(t) for t in re.findall(r'"time" *: *([-+.\de]+)', series.read())]

    with open("system/blockMeshDict") as file:
        vertices = re.findall(r"^ *\( *(-?[\d.]+) +(-?[\d.]+) +(-?[\d.]+)\)", file.read(), re.M)
    corners = np.array(vertices, dtype=float)
    low, high = corners.min(axis=0), corners.max(axis=0)
    if tube:
        r = np.hypot(corners[:, 1], corners[:, 2]).max()
        low[1:], high[1:] = -r, r
    u = read(files[-1])[2]
    speeds = np.percentile(u, [1, 99])

    if moving:
        figure, axes = plt.subplots(figsize=(9, 5))
        film = PillowWriter(fps=12)
        with film.saving(figure, "animation.gif", dpi=80):
            for time, path in zip(times, files):
                axes.clear()
                draw(axes, path, tube, low, high, speeds)
                axes.set_title(f"{1e3*time:.0f} ms", fontsize=10)
                film.grab_frame()
        return

    figure = plt.figure(figsize=(11, 8.6))
    grid = figure.add_gridspec(2, 3, height_ratios=[2.2, 1], hspace=0.08, wspace=0.35)
    axes = figure.add_subplot(grid[0, :])
    draw(axes, files[-1], tube, low, high, speeds)
    scale = matplotlib.cm.ScalarMappable(
        matplotlib.colors.Normalize(1e3*speeds[0], 1e3*speeds[1]),
        matplotlib.colors.ListedColormap(COLOURS))
    figure.colorbar(scale, ax=axes, shrink=0.5, pad=0.01, label="velocity of the cells [mm/s]")
    viscosity = rows("apparentViscosity")
    driven = abs(viscosity[-1]["Ub"]) > 1e-3*np.abs(u).max()
    across = "distance from the axis [um]" if tube else "distance from the lower wall [um]"
    for column, (key, label, factor) in enumerate((("H", "haematocrit", 1),
                                                   ("U", "velocity [mm/s]", 1e3))):
        axes = figure.add_subplot(grid[1, column])
        s, values = profile(times[-1], key)
        axes.plot(s, factor*np.array(values), "o-", color="firebrick", ms=4)
        axes.set_xlabel(across)
        axes.set_ylabel(label)
        axes.grid(alpha=0.3)
        if key == "H":
            axes.set_ylim(bottom=0)
        elif driven:
            # The plain fluid at the same mean velocity
            Ub = 1e3*viscosity[-1]["Ub"]
            q = np.linspace(0, high[1] if tube else high[1] - low[1], 50)
            r = q/high[1] if tube else 2*q/(high[1] - low[1]) - 1
            axes.plot(q, (2 if tube else 1.5)*Ub*(1 - r**2), "--", color="0.5", lw=1,
                      label="plain fluid")
            axes.legend(frameon=False, fontsize=8)
    axes = figure.add_subplot(grid[1, 2])
    axes.plot([1e3*row["time"] for row in viscosity], [row["muRel"] for row in viscosity],
              color="firebrick", lw=1)
    axes.set_xlabel("time [ms]")
    axes.set_ylabel("relative viscosity")
    axes.set_ylim(1, 1.6*np.median([row["muRel"] for row in viscosity]))
    axes.grid(alpha=0.3)
    figure.savefig("result.png", dpi=110, bbox_inches="tight")


main()
