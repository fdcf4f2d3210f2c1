"""Picture of the tethered cell and the flow: xvfb-run -a pvbatch picture.py"""

from paraview.simple import *
import glob
import json

# Whole, or in a piece per processor
series = sorted(glob.glob('VTK/clumps/spheres.*vtp.series'))[0]
with open(series) as file:
    last = 'VTK/clumps/' + json.load(file)['files'][-1]['name']

flow = OpenFOAMReader(FileName='case.foam')
flow.MeshRegions = ['internalMesh']
flow.CellArrays = ['U', 'p']
flow.UpdatePipeline()
times = flow.TimestepValues
time = times[-1] if hasattr(times, '__len__') else times
flow.UpdatePipeline(time)

spheres = OpenDataFile(last)
spheres.UpdatePipeline()

view = CreateView('RenderView')
view.ViewSize = [1500, 900]
view.Background = [1, 1, 1]
view.UseColorPaletteForBackground = 0
view.OrientationAxesVisibility = 0
view.ViewTime = time

# Mid-plane coloured by speed in mm/s, below the spheres
speed = Calculator(
    Input=CellDatatoPointData(Input=flow), ResultArrayName='speed', Function='1000*mag(U)'
)
plane = Slice(Input=speed)
plane.SliceType.Origin = [25e-6, 25e-6, 12.5e-6]
plane.SliceType.Normal = [0, 0, 1]
plane = Clip(Input=plane)
plane.ClipType = 'Box'
plane.ClipType.Position = [5e-6, 12e-6, 0]
plane.ClipType.Length = [40e-6, 26e-6, 25e-6]
plane.Exact = 1

shown = Show(plane, view)
ColorBy(shown, ('POINTS', 'speed'))
colours = GetColorTransferFunction('speed')
colours.ApplyPreset('Viridis (matplotlib)', True)
colours.RescaleTransferFunction(0, 1.5)
shown.Ambient = 1
shown.Diffuse = 0

# Just below the streamlines
shown.Position = [0, 0, -0.3e-6]
bar = GetScalarBar(colours, view)
bar.Title = 'speed (mm/s)'
bar.ComponentTitle = ''
bar.AutomaticLabelFormat = 0
bar.LabelFormat = bar.RangeLabelFormat = '%.1f'
bar.TitleColor = bar.LabelColor = [0, 0, 0]
bar.WindowLocation = 'Any Location'
bar.Position = [0.93, 0.25]
bar.ScalarBarLength = 0.5
shown.SetScalarBarVisibility(view, True)

# Streamlines from a rake in front of the bead
rake = StreamTracer(Input=plane, SeedType='Line', Vectors=['POINTS', 'U'])
rake.SeedType.Point1 = [6e-6, 12.5e-6, 12.5e-6]
rake.SeedType.Point2 = [6e-6, 37.5e-6, 12.5e-6]
rake.SeedType.Resolution = 24
rake.MaximumStreamlineLength = 60e-6
rake.SurfaceStreamlines = 1
lines = Show(rake, view)
lines.ColorArrayName = [None, ""]
lines.DiffuseColor = lines.AmbientColor = [1, 1, 1]
lines.LineWidth = 1.5
lines.Opacity = 0.8

data = servermanager.Fetch(spheres)
for i in range(data.GetNumberOfPoints()):
    fields = data.GetPointData()
    ball = Sphere(Center=data.GetPoint(i), Radius=fields.GetArray('radius').GetValue(i),
                  ThetaResolution=64, PhiResolution=64)
    bead = fields.GetArray('type').GetValue(i) == 1
    look = Show(ball, view)
    look.DiffuseColor = look.AmbientColor = [0.2, 0.3, 0.8] if bead else [0.75, 0.07, 0.1]
    look.Specular = 0.4

view.CameraParallelProjection = 1
view.CameraParallelScale = 14.5e-6
view.CameraFocalPoint = [27e-6, 25e-6, 12.5e-6]
view.CameraPosition = [27e-6, 13e-6, 60e-6]
view.CameraViewUp = [0, 1, 0]
SaveScreenshot('result.png', view)
