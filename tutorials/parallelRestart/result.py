"""Largest distance between the red cells of the serial and of the parallel run over time."""
from clumps import table

LENGTHS = {"x": 30e-6, "y": 1, "z": 20e-6}      # periods in x and z (system/blockMeshDict)


def apart(a, b):
    return max(abs((a[c] - b[c] + length/2) % length - length/2) for c, length in LENGTHS.items())


serial = {(row["time"], row["clump"]): row for row in table("serial", "clumpForce")}
parallel = table(".", "clumpForce")
end = parallel[-1]["time"]
first = [row for row in parallel if row["time"] <= end/2]
for what, rows in (f"to the restart at {end/2:g} s", first), (f"to {end:g} s", parallel):
    distance = max(apart(row, serial[row["time"], row["clump"]]) for row in rows)
    print(f"largest distance from the serial run {what}: {1e6*distance:.4f} um")
print(f"rows: {len(serial)} in the serial run, {len(parallel)} in the parallel one")
