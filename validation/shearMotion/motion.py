"""Motion of a ring from the positions of its spheres in VTK/clumps of a case, as a
table on standard output: time, lengths along the principal axes, inclination of the longest to the
flow, angle by which the spheres have gone round the centre in the plane of flow and gradient, the
ring's axis.

    python3 motion.py <case>
"""

import math
import sys
import numpy as np
from clumps import frames, spheres

case = sys.argv[1]
radius = 1.4756e-6       # of the healthy cell's spheres
turned, last = 0, None
print("t_s,L1_m,L2_m,L3_m,inclination_deg,turned_rad,normal_x,normal_y,normal_z")
for time, name in frames(case):
    x = spheres(name)["x"]
    x -= x.mean(axis=0)
    axes = np.linalg.eigh(x.T @ x)[1].T[::-1]
    lengths = [np.ptp(x @ axis) + 2*radius for axis in axes]
    inclination = math.degrees(math.atan2(axes[0][1], axes[0][0]))
    inclination -= 180*round(inclination/180)
    angles = np.arctan2(x[:, 1], x[:, 0])
    if last is not None:
        turned += ((last - angles + math.pi) % (2*math.pi) - math.pi).mean()
    last = angles
    values = [time, *lengths, inclination, turned, *axes[2]]
    print(",".join(f"{v:.8g}" for v in values))
