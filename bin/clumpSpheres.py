"""Reads the spheres and the surfaces of membranes that the function object vtkClumps has written to
VTK/clumps, whole (.vtp) or in a piece per processor (.pvtp).

    from clumpSpheres import drawSpheres, frames, membranes, spheres, typeNames
    time, path = frames("case")[-1]
    s = spheres(path)
    s["x"], s["radius"], s["U"]         # arrays, one row per sphere, SI units
    typeNames(path)[int(s["type"][0])]  # name of the type of the first sphere
    m = membranes(path)                 # nodes of the same time, the same arrays without a radius
    m["x"][m["triangles"]]              # corners of the triangles
"""

import json
import os
import re
import sys
from xml.etree import ElementTree


# Of the types in their order, for pictures
TYPE_COLOURS = {
    "red": (0.78, 0.13, 0.13), "blue": (0.12, 0.35, 0.75), "orange": (0.9, 0.55, 0.1),
    "green": (0.2, 0.55, 0.25), "purple": (0.5, 0.3, 0.65), "grey": (0.35, 0.35, 0.35),
    "teal": (0.1, 0.6, 0.6), "brown": (0.55, 0.35, 0.2), "pink": (0.9, 0.45, 0.65),
}


def hasFluid(case):
    """Whether the case has a fluid; without one its mesh may be any size."""
    return os.path.exists(os.path.join(case, "constant", "transportProperties"))


def gravity(case):
    """The components of constant/g, zero without it."""
    path = os.path.join(case, "constant", "g")
    found = None
    if os.path.exists(path):
        with open(path) as file:
            found = re.search(r"^\s*value\s*\(([^)]*)\)", file.read(), re.M)
    return [float(word) for word in found.group(1).split()] if found else [0.0]*3


def typeColour(kind):
    """Name and components of the colour of a type by its number."""
    return list(TYPE_COLOURS.items())[kind % len(TYPE_COLOURS)]


def seriesFile(case="."):
    """The list of the times of the spheres, None where there is none."""
    paths = (os.path.join(case, "VTK", "clumps", f"spheres.{kind}.series")
             for kind in ("pvtp", "vtp"))
    return next(filter(os.path.exists, paths), None)


def frames(case="."):
    """The times that were written [s] and their files."""
    series = seriesFile(case)
    folder = os.path.join(case, "VTK", "clumps")
    if not series:
        path = os.path.join(folder, "spheres.vtp.series")
        sys.exit(f"There is no {path}; the function object vtkClumps writes it")
    with open(series) as file:
        result = [(f["time"], os.path.join(folder, f["name"])) for f in json.load(file)["files"]]
    if not result:
        sys.exit(f"There is no time in {series}")
    return result


def read(path):
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPPolyDataReader
    reader = vtkXMLPPolyDataReader() if path.endswith(".pvtp") else vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def typeNames(path):
    """Names of the types, in the order of the numbers in the array `type`."""
    if path.endswith(".pvtp"):
        # Texts are in the pieces
        piece = next(ElementTree.parse(path).iter("Piece")).get("Source")
        path = os.path.join(os.path.dirname(path), piece)
    names = read(path).GetFieldData().GetAbstractArray("typeNames")
    return [names.GetValue(k) for k in range(names.GetNumberOfValues())] if names else []


def spheres(path):
    """Centres `x` and every array of a file by name, without rows where there are no spheres."""
    return arrays(read(path))


def arrays(data):
    """Points `x` and every array of a data set by name."""
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy
    point = data.GetPointData()
    result = {point.GetArrayName(k): vtk_to_numpy(point.GetArray(k))
              for k in range(point.GetNumberOfArrays())}
    result["x"] = vtk_to_numpy(data.GetPoints().GetData()).astype(float) \
        if data.GetNumberOfPoints() else np.empty((0, 3))
    return result


def membranes(path):
    """Nodes `x`, corners `triangles` and every array of the membranes at the time of a file of
    spheres, without rows where there are none."""
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy
    folder, name = os.path.split(path)
    path = os.path.join(folder, name.replace("spheres", "membranes"))
    data = read(path) if os.path.exists(path) else None
    if data is None or not data.GetNumberOfPoints():
        return {"x": np.empty((0, 3)), "triangles": np.empty((0, 3), dtype=int),
                "clump": np.empty(0), "type": np.empty(0), "U": np.empty((0, 3))}
    corners = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
    return {**arrays(data), "triangles": corners.reshape(-1, 3)}


def drawSpheres(axes, path):
    """Draws the spheres of a file in um as they are seen along z, the lower ones lighter."""
    import matplotlib.pyplot as plt
    s = spheres(path)
    if not len(s["x"]):
        return
    height = 1e6*s["x"][:, 2]
    for k in height.argsort():
        axes.add_patch(plt.Circle(1e6*s["x"][k, :2], 1e6*s["radius"][k], lw=0.3, ec="k",
                                  fc=plt.cm.Reds(0.45 + 0.04*(height[k] - height.min()))))
