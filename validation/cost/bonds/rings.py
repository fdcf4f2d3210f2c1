"""Rings of ten atoms for LAMMPS, on a lattice so wide that none meets another."""
import math
import sys

rings, size, radius, cell = int(sys.argv[1]), 10, 2.135, 20.0
side = math.ceil(rings**(1/3))
print(f"rings\n\n{rings*size} atoms\n{rings*size} bonds\n1 atom types\n1 bond types\n")
for axis in "xyz":
    print(f"0 {side*cell} {axis}lo {axis}hi")
print("\nMasses\n\n1 1.0\n\nAtoms\n")
for k in range(rings):
    x, y, z = ((k // side**d % side + 0.5)*cell for d in range(3))
    for i in range(size):
        a = 2*math.pi*i/size
        print(k*size + i + 1, k + 1, 1, x + radius*math.cos(a), y + radius*math.sin(a), z)
print("\nBonds\n")
for k in range(rings):
    for i in range(size):
        print(k*size + i + 1, 1, k*size + i + 1, k*size + (i + 1) % size + 1)
