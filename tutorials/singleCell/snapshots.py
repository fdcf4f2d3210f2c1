"""Draws a clump at several times between walls y = -r(x) and r(x), seen along z:

    python3 snapshots.py together|panels <number> <x:r> <x:r> ...

together: all times in one picture, as many as fit, panels: one picture each at equal intervals,
moving with the clump.
Lengths in um; the spheres are those of VTK/clumps, sphere 0 is marked. Writes result.png.
"""

import glob
import re
import sys
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

together = sys.argv[1] == "together"
number = int(sys.argv[2])
xs, rs = zip(*((float(v) for v in word.split(":")) for word in sys.argv[3:]))

files = sorted(
    glob.glob("VTK/clumps/spheres_*.vtp"),
    key=lambda f: int(re.findall(r"_(\d+)\.vtp", f)[0])
)
with open("VTK/clumps/spheres.vtp.series") as series:
    times = [float(t) for t in re.findall(r'"time" *: *([-+.\de]+)', series.read())]
if len(times) < 2:
    sys.exit("No spheres in VTK/clumps")
if together:
    chosen = [round(i*(len(times) - 1)/(number - 1)) for i in range(number)]
else:
    stride = max((len(times) - 1)//(number - 1), 1)
    chosen = [max(len(times) - 1 - i*stride, 0) for i in reversed(range(number))]


def spheres(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    radii = vtk_to_numpy(data.GetPointData().GetArray("radius"))
    return 1e6*vtk_to_numpy(data.GetPoints().GetData()), 1e6*radii


if together:
    figure, axes = plt.subplots(figsize=(12, 12*2.4*max(rs)/(xs[-1] - xs[0]) + 0.6))
    panels = [axes]*number
else:
    figure, panels = plt.subplots(1, number, figsize=(2*number, 2.6), sharey=True)

drawn_to = -1e9
for i, (axes, k) in enumerate(zip(panels, chosen)):
    x, radii = spheres(files[k])
    if together and (x[:, 0] - radii).min() < drawn_to:
        continue
    drawn_to = (x[:, 0] + radii).max()
    shift = 0 if together else x[:, 0].mean()
    for j, (centre, radius) in enumerate(zip(x, radii)):
        axes.add_patch(plt.Circle((centre[0] - shift, centre[1]), radius, lw=0, alpha=0.6,
                                  color="C0" if j == 0 else plt.cm.Reds(0.35 + 0.5*i/number)))
    label = f"{1e3*times[k]:.0f} ms"
    if together:
        axes.text(x[:, 0].mean(), 0.9*max(rs), label, ha="center", va="top", fontsize=8)
    else:
        axes.set_title(label, fontsize=9)
        axes.set_xlim(-8, 8)

for axes in [panels[0]] if together else panels:
    low, high = (xs[0], xs[-1]) if together else (-8, 8)
    wall_x, wall_r = (xs, rs) if together else ((low, high), (rs[0], rs[0]))
    for sign in -1, 1:
        axes.plot(wall_x, [sign*r for r in wall_r], "k", lw=1.5)
    axes.set_xlim(low, high)
    height = 1.1*max(rs) if together else min(1.1*max(rs), 8)
    axes.set_ylim(-height, height)
    axes.set_aspect("equal")
    axes.set_xlabel("x [um]" if together else "x - cell [um]", fontsize=8)
panels[0].set_ylabel("y [um]", fontsize=8)
figure.tight_layout()
figure.savefig("result.png", dpi=110)
