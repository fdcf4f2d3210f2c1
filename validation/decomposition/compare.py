"""Largest difference of force and position of the cell over all steps, relative to drag and cell
size."""

from clumps import table
from results import Results, write_table

CELL = 7.82e-6


def cell(split):
    return table(split, "clumpForce", type="healthy")


def difference(row, same, columns, size):
    return max(abs(row[c] - same[c]) for c in columns)/size


serial = cell("1-1-1")
drag = abs(serial[-1]["Fx"])
data, results = [], Results()
for split in ("4-1-1", "2-1-2"):
    rows = cell(split)
    assert len(rows) == len(serial) >= 10, (len(rows), len(serial))
    forces = [difference(r, s, ("Fx", "Fy", "Fz"), drag) for r, s in zip(rows, serial)]
    positions = [difference(r, s, ("x", "y", "z"), CELL) for r, s in zip(rows, serial)]
    data += [[split, i + 1, f"{f:.3e}", f"{x:.3e}"] for i,
             (f, x) in enumerate(zip(forces, positions))]
    results.add(f"force, split {split}, largest difference over the drag", max(forces), "-", 0,
                "1e-8", "serial run")
    results.add(f"position, split {split}, largest difference over the cell's diameter",
                max(positions), "-", 0, "1e-8",
                "serial run")
write_table("data.csv", ["split", "step", "force_difference", "position_difference"], data)
results.write()
