"""The point of the capsule in the picture of deformation over area, its tensions and velocity."""
from clumpTables import table

MEAN_VELOCITY = 0.1     # constant/fvOptions [m/s]

contour, state, motion = (table(".", name) for name in
                          ("clumpContour", "membraneState", "clumpForce"))
first, last = contour[0], contour[-1]
before = contour[3*len(contour)//4]
print(f"area {last['area']*1e12:.1f} um2, deformation {last['deformation']:.4f}, a quarter of the "
      f"run before {before['deformation']:.4f}")
print(f"inertia ratio {last['inertiaRatio']:.3f}")
print(f"tensions {state[-1]['smallestTension']*1e3:.1f} to {state[-1]['largestTension']*1e3:.1f} "
      f"mN/m, at rest {state[0]['meanTension']*1e3:.1f}")
print(f"velocity {motion[-1]['Ux']/MEAN_VELOCITY:.2f} of the mean of the flow")
