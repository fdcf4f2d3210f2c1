#!/usr/bin/env python3
"""Prints the drag on the tethered cell and its shape, and compares the drag with an independent reference.

Reference: the drag of the undeformed ring in unbounded fluid, edgewise, from reference/ (computed by a boundary
integral method), carried over to the cell's present shape, the bead in front of it, the walls and the periodic
images by slitMobility.py. The first factor corrects for what Rotne-Prager mobilities miss on the undeformed ring.
"""

import csv
import glob
import re
import sys
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from slitMobility import Slit, drag

mu = 1.2e-3            # Pa s, so um/s and pN go together through pN s/um^2 = Pa s
u_mean = 1000.0        # um/s
height, length, width = 50.0, 50.0, 25.0


def last_rows(name):
    """Last row per clump type of a clump table, in the newest time directory."""
    def start(path):
        return float(path.split('/')[-2])
    path = sorted(glob.glob('postProcessing/%s/*/%s*.dat' % (name, name)), key=start)[-1]
    rows = {}
    for line in open(path):
        if not line.startswith('#'):
            columns = line.split()
            rows[columns[2]] = np.array([float(columns[0])] + [float(c) for c in columns[3:]])
    return rows


def spheres():
    """Centres, radii [um] and clump numbers at the last time written."""
    files = glob.glob('VTK/clumps/spheres_*.vtp')
    path = max(files, key=lambda f: int(re.findall(r'_(\d+)\.vtp', f)[0]))
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    fields = data.GetPointData()
    return (1e6*vtk_to_numpy(data.GetPoints().GetData()), 1e6*vtk_to_numpy(fields.GetArray('radius')),
            vtk_to_numpy(fields.GetArray('clump')))


def table_value(shape, column):
    with open('reference/stokes_drag_rings_tori_biconcave_computed.csv') as f:
        rows = csv.DictReader(line for line in f if not line.startswith('#'))
        return next(float(r[column]) for r in rows if r['shape'].startswith(shape))


def reference(x, a, cell):
    angles = 2*np.pi*np.arange(10)/10
    ring = 1.955*np.column_stack([np.cos(angles), np.sin(angles), 0*angles])
    exact = table_value('ring 10 spheres a=1.955;R=1.955', 'FUx_pN_s_um')
    approximate = drag(ring, np.full(10, 1.955), mu, lambda y, r: 1.0).sum()
    factor = exact/approximate

    def poiseuille(y, r):
        # with the curvature over a sphere (Faxen)
        h = height/2
        return 1.5*u_mean*(1 - ((y - h)/h)**2 - (r/h)**2/3)

    forces = drag(x, a, mu, poiseuille, Slit(mu, length, height, width).correction)
    return factor*forces[cell].sum(), exact, factor


force, shape = last_rows('clumpForce'), last_rows('clumpShape')
x, a, clump = spheres()
F = 1e12*force['healthy'][1]
axial, transverse = 1e6*shape['healthy'][4], 1e6*shape['healthy'][5]
F_reference, unbounded, factor = reference(x, a, clump == 1)

settling = np.linalg.norm(force['healthy'][10:13])*1e6
print('time                           %8.3f s' % force['healthy'][0])
print('drag on the cell               %8.2f pN' % F)
print('drag on the bead               %8.2f pN' % (1e12*force['bead'][1]))
print('F_D/u, u = 1 mm/s mean         %8.4f pN s/um' % (F/u_mean))
print('axial, transverse diameter     %8.2f x %.2f um' % (axial, transverse))
print('speed of the cell              %8.4f um/s' % settling)
print('reference F_D/u                %8.4f pN s/um' % (F_reference/u_mean))
print('  ring unbounded, edgewise     %8.4f pN s/um, times the shape, bead, walls (no slip, y)' % unbounded)
print('  and periodic images (x, z); Rotne-Prager on the ring times %.3f is exact' % factor)
print('deviation                      %8.1f %%' % (100*(F/F_reference - 1)))

with open('result.csv', 'w') as f:
    f.write('quantity,value,unit,reference,tolerance,source\n')
    f.write('F_D/u,%.5f,pN s/um,%.5f,5%%,"ring unbounded (computed), with shape, bead, wall and periodic corrections"\n'
            % (F/u_mean, F_reference/u_mean))
    f.write('axial diameter,%.3f,um,,,\n' % axial)
    f.write('transverse diameter,%.3f,um,,,\n' % transverse)

sys.exit(0 if abs(F/F_reference - 1) < 0.05 else 1)
