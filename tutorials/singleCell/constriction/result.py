"""Length of the red cell at the start, at most and at the end, and its volume."""
from clumps import table

shape = table(".", "clumpShape")
length = [1e6*row["L1"] for row in shape]
volume = [row["volume"]/shape[0]["volume"] for row in shape]
print(f"length of the red cell {length[0]:.1f} um at the start, {max(length):.1f} um at most, "
      f"{length[-1]:.1f} um at the end")
print(f"volume within {100*max(abs(v - 1) for v in volume):.1f} % of that at the start")
