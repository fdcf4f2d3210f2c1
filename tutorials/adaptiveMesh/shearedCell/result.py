"""Rotation of the red cell about the vorticity; half the shear rate (100 1/s) for a sphere."""
from clumps import table

print(f"rotation of the red cell {table('.', 'clumpShape')[-1]['omegaz']:.1f} 1/s")
