"""The space around the clumps of a case, from its mesh and fields, and units and colours of
pictures.

    from clumpDomain import Domain, lengthUnit
    domain = Domain("case")
    domain.limits               # smallest and largest coordinates [m], None without a mesh
    domain.walls                # surfaces of the wall patches
    domain.section(2)           # lines (n, 2, 3) in which the middle plane across z cuts the walls
    flow = domain.flow(0.1)     # the mesh with U at the written time nearest to 0.1 s, or None
"""

import os
import re
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPlaneCollection, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCutter, vtkPolyDataNormals
from vtkmodules.vtkFiltersGeneral import vtkClipClosedSurface, vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter
from vtkmodules.vtkFiltersSources import vtkOutlineSource
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

sys.dont_write_bytecode = True
vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)

PREFIXES = {-18: "a", -15: "f", -12: "p", -9: "n", -6: "u", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}


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


def fitting(unit, most):
    """Factor and name of the multiple of an SI unit in which a number of this size has one to
    three digits before its point; units of another kind stay."""
    first = re.split("[/ .]", unit)[0]
    if not np.isfinite(most) or most <= 0 or \
            first not in ("m", "m2", "m3", "s", "N", "Pa", "J", "W"):
        return 1, unit
    exponent = int(first[1]) if first in ("m2", "m3") else 1
    power = int(3*np.floor(np.log10(most)/3/exponent + 1e-9))
    power = max(min(power, 9), -18)
    return 10.0**(-power*exponent), PREFIXES[power] + unit


def lengthUnit(span):
    """Factor and name of the unit for a picture of this size [m]."""
    return fitting("m", 0.3*span)


def joined(parts):
    """Surfaces as one data set."""
    append = vtkAppendPolyData()
    append.AddInputData(vtkPolyData())      # where there is no clump
    for part in parts:
        append.AddInputData(part)
    append.Update()
    return append.GetOutput()


def moved(data, factor, shift=(0, 0, 0)):
    """A surface multiplied by a factor, then shifted."""
    transform, result = vtkTransform(), vtkTransformPolyDataFilter()
    transform.Translate(*shift)
    transform.Scale(factor, factor, factor)
    result.SetTransform(transform)
    result.SetInputData(data)
    result.Update()
    return result.GetOutput()


def openReader(case):
    """A reader of the mesh and its fields."""
    marker = os.path.join(case, "case.foam")
    with open(marker, "a"):
        pass
    reader = vtkOpenFOAMReader()
    reader.SetFileName(marker)
    reader.UpdateInformation()
    return reader


def patches(case):
    """The patches of the mesh as {name: (type, surface)}; none without a mesh."""
    boundary = os.path.join(case, "constant", "polyMesh", "boundary")
    if not os.path.exists(boundary):
        return {}
    with open(boundary) as file:
        types = dict(re.findall(r"(\w+)\s*\{\s*type\s+(\w+);", file.read()))
    reader = openReader(case)
    found = {}
    for name, kind in types.items():
        reader.DisableAllPatchArrays()
        for array in name, "patch/" + name:
            reader.SetPatchArrayStatus(array, 1)
        geometry = vtkCompositeDataGeometryFilter()
        geometry.SetInputConnection(reader.GetOutputPort())
        geometry.Update()
        if geometry.GetOutput().GetNumberOfPoints():
            found[name] = kind, geometry.GetOutput()
    return found


class Domain:
    """What the mesh says about the space around the clumps."""

    def __init__(self, case):
        self.case = case
        found = patches(case).values()
        self.walls = [surface for kind, surface in found if kind == "wall"]
        self.limits = None
        self.periodic = []              # directions, 0 to 2
        if found:
            bounds = np.array([surface.GetBounds() for _, surface in found])
            self.limits = bounds[:, ::2].min(axis=0), bounds[:, 1::2].max(axis=0)
            extents = (self.limits[1] - self.limits[0]).max()
            self.periodic = sorted({k for (kind, _), b in zip(found, bounds)
                                    if kind in ("cyclic", "cyclicAMI")
                                    for k in range(3) if b[2*k + 1] - b[2*k] < 1e-6*extents})

    def repeated(self, data, depth):
        """A surface whose part beyond a periodic boundary is at the other end instead, closed in
        the boundary; whole in the direction depth, that of the view, where the cut would show."""
        for k in set(self.periodic) - {depth}:
            low, high = self.limits[0][k], self.limits[1][k]
            least, most = data.GetBounds()[2*k:2*k + 2]
            if low <= least and most <= high:
                continue
            parts = []
            for shift in (low - high, 0, high - low):
                # In um: the filter has an absolute tolerance of 1e-6
                cut, planes = vtkClipClosedSurface(), vtkPlaneCollection()
                for end, sign in ((low, 1), (high, -1)):
                    plane = vtkPlane()
                    plane.SetOrigin(*1e6*end*np.eye(3)[k])
                    plane.SetNormal(*sign*np.eye(3)[k])
                    planes.AddItem(plane)
                cut.SetInputData(moved(data, 1e6, 1e6*shift*np.eye(3)[k]))
                cut.SetClippingPlanes(planes)
                cut.SetPassPointData(True)
                cut.Update()
                if cut.GetOutput().GetNumberOfCells():
                    normals = vtkPolyDataNormals()      # the ends have none
                    normals.SetInputConnection(cut.GetOutputPort())
                    normals.SetFeatureAngle(60)
                    normals.Update()
                    parts.append(moved(normals.GetOutput(), 1e-6))
            data = joined(parts)
        return data

    def actors(self):
        """Translucent walls, and the edges of the domain where it has periodic ends or no walls."""
        def actor(surface, colour, opacity):
            mapper, result = vtkPolyDataMapper(), vtkActor()
            mapper.SetInputData(surface)
            mapper.ScalarVisibilityOff()
            result.SetMapper(mapper)
            result.GetProperty().SetColor(*colour)
            result.GetProperty().SetOpacity(opacity)
            return result

        result = [actor(wall, (0.55, 0.6, 0.7), 0.15) for wall in self.walls]
        if self.limits and (self.periodic or not self.walls):
            edges = vtkOutlineSource()
            edges.SetBounds(*np.transpose(self.limits).ravel())
            edges.Update()
            result.append(actor(edges.GetOutput(), (0.5, 0.5, 0.5), 1))
        return result

    def section(self, depth):
        """The lines in which the middle plane across an axis cuts the walls."""
        result = [np.empty((0, 2, 3))]
        for wall in self.walls:
            plane, cutter = vtkPlane(), vtkCutter()
            plane.SetOrigin(*(np.array(self.limits[0]) + self.limits[1])/2)
            plane.SetNormal(*np.eye(3)[depth])
            cutter.SetInputData(wall)
            cutter.SetCutFunction(plane)
            cutter.Update()
            lines = cutter.GetOutput()
            if lines.GetNumberOfLines():
                points = vtk_to_numpy(lines.GetPoints().GetData()).astype(float)
                ends = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
                result.append(points[ends].reshape(-1, 2, 3))
        return np.concatenate(result)

    def flow(self, time):
        """The mesh with U at the nearest of the written times; None where there is none, or none
        that is as near as the written times are to each other."""
        written = sorted(float(t) for t in os.listdir(self.case)
                         if re.fullmatch(r"[\d.]+(e-?\d+)?", t)
                         and os.path.exists(os.path.join(self.case, t, "U")))
        if not written or not self.limits:
            return None
        nearest = min(written, key=lambda t: abs(t - time))
        spacing = max((b - a for a, b in zip(written, written[1:])), default=0)
        if abs(nearest - time) > spacing + 1e-6*abs(time):
            return None
        reader = openReader(self.case)
        reader.DisableAllPatchArrays()
        reader.SetPatchArrayStatus("internalMesh", 1)
        reader.DisableAllCellArrays()
        reader.SetCellArrayStatus("U", 1)
        reader.CreateCellToPointOn()
        reader.SetTimeValue(nearest)
        reader.Modified()
        reader.Update()
        blocks = reader.GetOutput().NewIterator()
        blocks.InitTraversal()
        while not blocks.IsDoneWithTraversal():
            mesh = blocks.GetCurrentDataObject()
            if mesh.GetPointData().GetArray("U"):
                return mesh
            blocks.GoToNextItem()
        return None
