"""Rotation of the red cell at the end, and half the shear rate."""
import re
from clumps import table

HEIGHT = 22.5e-6        # between the walls (system/blockMeshDict)
with open("0.orig/U") as file:
    wall = float(re.search(r"top .*uniform \((\S+) ", file.read()).group(1))
omega = table(".", "clumpShape")[-1]["omegaz"]
print(f"rotation {-omega:.1f} 1/s; half the shear rate is {wall/HEIGHT:.1f} 1/s")
