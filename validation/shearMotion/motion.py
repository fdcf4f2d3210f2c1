"""Motion of a ring from the positions of its spheres, VTK/clumps/spheres_*.vtp of a case, as a
table on standard output: time, lengths along the principal axes, inclination of the longest to the
flow, angle by which the spheres have gone round the centre in the plane of flow and gradient, the
ring's axis.

    python3 motion.py <case> <time step>
"""

import base64
import glob
import math
import re
import sys
import numpy as np


def centres(name):
    """The first data array is the points: eight bytes of size, then floats."""
    with open(name) as file:
        text = file.read()
    data = base64.b64decode(re.search(r"<DataArray[^>]*'Points'[^>]*>\s*(\S+)", text).group(1))
    return np.frombuffer(data[8:], dtype="<f4").reshape(-1, 3).astype(float)


def number(name):
    return int(re.search(r"_(\d+)\.vtp", name).group(1))


case, step = sys.argv[1], float(sys.argv[2])
radius = 1.4756e-6       # of the healthy cell's spheres
turned, last = 0, None
print("t_s,L1_m,L2_m,L3_m,inclination_deg,turned_rad,normal_x,normal_y,normal_z")
for name in sorted(glob.glob(f"{case}/VTK/clumps/spheres_*.vtp"), key=number):
    x = centres(name)
    x -= x.mean(axis=0)
    axes = np.linalg.eigh(x.T @ x)[1].T[::-1]
    lengths = [np.ptp(x @ axis) + 2*radius for axis in axes]
    inclination = math.degrees(math.atan2(axes[0][1], axes[0][0]))
    inclination -= 180*round(inclination/180)
    angles = np.arctan2(x[:, 1], x[:, 0])
    if last is not None:
        turned += ((last - angles + math.pi) % (2*math.pi) - math.pi).mean()
    last = angles
    values = [number(name)*step, *lengths, inclination, turned, *axes[2]]
    print(",".join(f"{v:.8g}" for v in values))
