"""The clumps in space at the written times, for the view that turns, and a still picture."""
import base64

import matplotlib
import numpy as np
from clumpDomain import fitting, hasFluid, lengthUnit
from clumpRender import render, turned
from matplotlib import pyplot as plt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter, vtkDecimatePro, vtkTriangleFilter

from clumpReport.figures import embedded

MOST_POINTS = 200000    # spheres and nodes of all times in the page, 16 bytes each
MOST_TIMES = 100
MOST_SLICES = 10
MOST_TRIANGLES = 20000  # of all walls
WIDE = 1000             # pixels of the still picture


def encoded(array, kind):
    return base64.b64encode(np.ascontiguousarray(array, dtype=kind).tobytes()).decode()


def chosen(run):
    """Times and files that the page has room for: the first with a clump, the last, and as many
    between."""
    first = next((k for k, (_, path) in enumerate(run.frames) if run.clumps(path)), None)
    if first is None:
        return []
    there = run.frames[first:]
    points = sum(len(x) + len(nodes) for x, nodes, _ in run.clumps(there[-1][1]).values())
    number = min(max(MOST_POINTS//max(points, 1), 2), MOST_TIMES, len(there))
    return [there[round(k)] for k in np.linspace(0, len(there) - 1, number)] if number > 1 \
        else there[-1:]


def polygons(surface):
    """Points and triangles of a surface."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    triangles.Update()
    data = triangles.GetOutput()
    if not data.GetNumberOfPolys():
        return np.empty((0, 3)), np.empty((0, 3), dtype=int)
    return (vtk_to_numpy(data.GetPoints().GetData()).astype(float),
            vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def walls(domain):
    """Points and triangles of each wall, with fewer triangles where there are many."""
    total = sum(wall.GetNumberOfPolys()*2 for wall in domain.walls)
    for wall in domain.walls:
        if total > MOST_TRIANGLES:
            triangles, fewer = vtkTriangleFilter(), vtkDecimatePro()
            triangles.SetInputData(wall)
            fewer.SetInputConnection(triangles.GetOutputPort())
            fewer.SetTargetReduction(1 - MOST_TRIANGLES/total)
            fewer.PreserveTopologyOn()
            fewer.Update()
            wall = fewer.GetOutput()
        yield polygons(wall)


def slice(domain, time):
    """Points, triangles and speed [m/s] of the flow in the middle plane across z."""
    mesh = domain.flow(time)
    if mesh is None:
        return None
    plane, cutter = vtkPlane(), vtkCutter()
    plane.SetOrigin(*(np.array(domain.limits[0]) + domain.limits[1])/2)
    plane.SetNormal(0, 0, 1)
    cutter.SetInputData(mesh)
    cutter.SetCutFunction(plane)
    cutter.Update()
    x, triangles = polygons(cutter.GetOutput())
    U = cutter.GetOutput().GetPointData().GetArray("U")
    return (x, triangles, np.linalg.norm(vtk_to_numpy(U), axis=1)) if len(triangles) else None


def slices(domain, times, factor):
    """Slices near some of the times, the colours by speed; and the range of the speed as text."""
    step = -(-len(times)//MOST_SLICES)
    found = [slice(domain, time) for time in times[::step]]
    found = [part for part in found if part]
    if not found:
        return {}
    most = max(speed.max() for _, _, speed in found)
    colours = matplotlib.colormaps["viridis"]
    by, unit = fitting("m/s", most)
    return {"step": step, "range": f"Flow: 0 (dark) to {by*most:.3g} {unit} (yellow).",
            "parts": [{"points": encoded(factor*x, "<f4"), "triangles": encoded(corners, "<u4"),
                       "colours": encoded(colours(speed/(most or 1))[:, :3], "<f4")}
                      for x, corners, speed in found]}


def limits(run, frames):
    """Of the domain where it has a fluid, which the clumps may leave; else of the clumps."""
    ends = [np.concatenate([e for x, nodes, _ in run.clumps(path).values()
                            for e in (x[:, :3] - x[:, 3:], x[:, :3] + x[:, 3:], nodes)])
            for _, path in (frames[0], frames[-1])]
    every = np.concatenate(ends)
    box = run.domain.limits if run.domain.limits and hasFluid(run.case) else None
    return box or (every.min(axis=0), every.max(axis=0))


def scene(run, types):
    """What the script of the page needs for the view; types: names of those of the page."""
    frames = chosen(run)
    if not frames:
        return None
    low, high = limits(run, frames)
    factor, unit = lengthUnit(max(np.subtract(high, low)))
    byTime, unitOfTime = fitting("s", frames[-1][0])
    meshes = {}             # those of membranes do not change

    def ofType(x, nodes, corners):
        mesh = meshes.setdefault(encoded(corners, "<u4"), len(meshes))
        return {"spheres": encoded(factor*x, "<f4"), "nodes": encoded(factor*nodes, "<f4"),
                "mesh": mesh}

    moving = [{types.index(run.types[kind]): ofType(*parts)
               for kind, parts in run.clumps(path).items()} for _, path in frames]
    wet = hasFluid(run.case)
    return {
        "unit": unit,
        "low": list(np.multiply(low, factor)), "high": list(np.multiply(high, factor)),
        "times": [f"{byTime*time:.4g} {unitOfTime}" for time, _ in frames],
        "frames": moving, "meshes": list(meshes),
        "walls": [{"points": encoded(factor*x, "<f4"), "triangles": encoded(corners, "<u4")}
                  for x, corners in walls(run.domain)] if wet else [],
        "flow": slices(run.domain, [time for time, _ in frames], factor) if wet else {},
    }


def edges(low, high):
    """The twelve edges of a box."""
    corners = np.array([[(low, high)[n >> k & 1][k] for k in range(3)] for n in range(8)])
    return [corners[[n, n | 1 << k]] for n in range(8) for k in range(3) if not n >> k & 1]


def picture(run, types, colours):
    """The clumps at the last time as a still picture, in the edges of the domain and where middle
    planes cut the walls."""
    frames = chosen(run)
    if not frames:
        return ""
    low, high = limits(run, frames)
    factor, unit = lengthUnit(max(np.subtract(high, low)))
    box = [factor*line for line in edges(low, high)]
    cut = [part for k in (1, 2) for part in factor*run.domain.section(k)] \
        if hasFluid(run.case) else []
    parts = run.clumps(frames[-1][1])
    rgb = {kind: np.array(matplotlib.colors.to_rgb(colours[types.index(run.types[kind])]))
           for kind in parts}
    x = np.concatenate([p[:, :3] for p, _, _ in parts.values()])
    r = np.concatenate([p[:, 3] for p, _, _ in parts.values()])
    nodes = np.concatenate([n for _, n, _ in parts.values()])
    first = np.cumsum([0] + [len(n) for _, n, _ in parts.values()])
    corners = np.concatenate([c + k for (_, _, c), k in zip(parts.values(), first)]).astype(int)
    ofSpheres = np.concatenate([np.tile(rgb[k], (len(parts[k][0]), 1)) for k in parts])
    ofNodes = np.concatenate([np.tile(rgb[k], (len(parts[k][1]), 1)) for k in parts])
    places = turned(np.concatenate(box))
    wide = np.ptp(places[:, 0])
    image, extent = render(WIDE/wide, box, (factor*x, factor*r, ofSpheres),
                           (factor*nodes, corners, ofNodes))
    figure, axes = plt.subplots(figsize=(9, max(9*np.ptp(places[:, 1])/wide, 1)))
    axes.imshow(image, extent=extent, interpolation="bilinear")
    for line in box + cut:
        q = turned(line)
        axes.plot(q[:, 0], q[:, 1], color="0.5", lw=0.8, alpha=0.6)
    axes.set_axis_off()
    shown = {types.index(run.types[kind]) for kind in parts}
    if len(shown) > 1:
        axes.legend([plt.Circle((0, 0), facecolor=colours[k]) for k in sorted(shown)],
                    [types[k] for k in sorted(shown)], loc="upper left", bbox_to_anchor=(1, 1))
    return embedded(figure)


def size(run):
    """The size of the domain in words, empty without a mesh or a fluid."""
    if not run.domain.limits or not hasFluid(run.case):
        return ""
    low, high = run.domain.limits
    factor, unit = lengthUnit(max(np.subtract(high, low)))
    text = " × ".join(f"{factor*(b - a):.4g}" for a, b in zip(low, high)) + f" {unit}"
    periodic = ", ".join("xyz"[k] for k in run.domain.periodic)
    return text + (f", periodic along {periodic}" if periodic else "") \
        + (f", {len(run.domain.walls)} walls" if len(run.domain.walls) > 1 else "")
