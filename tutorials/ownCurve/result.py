"""Diameters of the fitted cell at one force, with those of the table."""
import csv
from clumps import table

FORCE = 109.0           # pN, constant/clumpProperties
with open("measured.csv") as file:
    rows = csv.DictReader(line for line in file if not line.startswith("#"))
    measured = next(row for row in rows if float(row["force_pN"]) == FORCE)
cell = table(".", "clumpShape")[-1]
for name, column in (("axial", "Lx"), ("transverse", "Ly")):
    print(f"{name} diameter at {FORCE:g} pN: {1e6*cell[column]:.2f} um, measured "
          f"{measured[name + '_um']} +- {measured[name + 'Error_um']} um")
