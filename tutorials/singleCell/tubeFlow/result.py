"""Speed of the red cell at the end, and its distance from the axis."""
from clumps import table

MEAN = 0.8e-3           # m/s, constant/fvOptions
cell = table(".", "clumpForce")[-1]
print(f"speed of the red cell over mean velocity {cell['Ux']/MEAN:.3f}, "
      f"{1e6*(cell['y']**2 + cell['z']**2)**0.5:.2f} um from the axis")
