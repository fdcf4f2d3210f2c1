"""Opens a case in ParaView, ready to play:

    clumpAnimation                                      # makes the surfaces of the clumps
    touch case.foam
    paraview --script=$FOAM_USER_APPBIN/clumpView.py    # in the folder of the case

shows the clumps coloured by their type (the surfaces of clumpAnimation, else the spheres) and,
where there is a flow, its speed in the mid-plane across z. `pvbatch clumpView.py view.png` writes a
picture of the last time instead.
"""
import os
import sys

from paraview.simple import (
    CellDatatoPointData, ColorBy, GetActiveViewOrCreate, GetAnimationScene, OpenDataFile,
    OpenFOAMReader, Render, ResetCamera, SaveScreenshot, Show, Slice)


def clumps(view):
    """The surfaces, or the spheres in their size."""
    folder = os.path.join("VTK", "clumps")
    paths = [os.path.abspath(os.path.join(folder, name + ".series"))
             for name in ("surfaces.vtp", "spheres.pvtp", "spheres.vtp")]
    path = next(filter(os.path.exists, paths), None)
    if not path:
        sys.exit(f"There is no {paths[-1]}; the function object vtkClumps writes it")
    smooth = path == paths[0]
    shown = Show(OpenDataFile(path), view)
    if not smooth:
        shown.SetRepresentationType("Point Gaussian")
        shown.ShaderPreset = "Sphere"
        shown.ScaleByArray = 1
        shown.SetScaleArray = ["POINTS", "radius"]
        shown.GaussianRadius = 1
        shown.UseScaleFunction = 0
    ColorBy(shown, ("POINTS", "type"))


def flow(view):
    """Speed in the mid-plane, where the case has U."""
    reader = OpenFOAMReader(FileName=os.path.abspath("case.foam"))
    reader.MeshRegions = ["internalMesh"]
    reader.UpdatePipeline()
    if "U" not in reader.CellData.keys():
        return
    bounds = reader.GetDataInformation().GetBounds()
    plane = Slice(Input=CellDatatoPointData(Input=reader))
    plane.SliceType.Origin = [sum(bounds[k:k + 2])/2 for k in (0, 2, 4)]
    plane.SliceType.Normal = [0, 0, 1]
    shown = Show(plane, view)
    ColorBy(shown, ("POINTS", "U", "Magnitude"))
    shown.RescaleTransferFunctionToDataRange(False, True)
    shown.SetScalarBarVisibility(view, True)
    shown.Opacity = 0.6


view = GetActiveViewOrCreate("RenderView")
if os.path.exists("case.foam"):
    flow(view)
clumps(view)
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
ResetCamera(view)
Render(view)
if len(sys.argv) > 1:
    scene.GoToLast()
    SaveScreenshot(sys.argv[1], view, ImageResolution=[900, 600])
