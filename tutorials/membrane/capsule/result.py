"""Deformation of the capsule at the end, and the motion of its membrane around it."""
import re
from math import degrees, pi
from clumps import table

HEIGHT = 24e-6          # between the walls (system/blockMeshDict)
with open("0.orig/U") as file:
    wall = float(re.search(r"top .*uniform \((\S+) ", file.read()).group(1))
shear = 2*wall/HEIGHT

rows = table(".", "clumpShape")
first, last = rows[len(rows)//2], rows[-1]

# The node passes through the angle -pi
turned = (first["phase"] - last["phase"]) % (2*pi)
rate = turned/(last["time"] - first["time"])
print(f"deformation {last['TaylorDeformation']:.3f}, inclined by "
      f"{degrees(last['inclination']):.1f} degrees")
print(f"the membrane goes around at {rate/shear:.2f} of the shear rate; the volume has changed by "
      f"{abs(last['volume']/rows[0]['volume'] - 1):.1e}")
