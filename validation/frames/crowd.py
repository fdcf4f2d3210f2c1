"""Parameters of twenty red blood cells in shear, seen from a frame: crowd.py <frame>. Places and
orientations are those of the first frame, turned or mirrored about the middle of the box, or by
half a mesh cell elsewhere along the flow and the vorticity; a moving frame has another speed of
walls and fluid."""

import sys
from math import radians

import numpy as np

from frame import matrices, speed

length, across, layers = 20e-6, 27, 5
shear = 200                     # 1/s


def rotation(axis, angle):
    """Matrix of a rotation by an angle [rad]."""
    x, y, z = np.array(axis)/np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle)*cross + (1 - np.cos(angle))*cross @ cross


def axis_angle(matrix):
    """Axis and angle [degrees] of a rotation that is neither none nor half a turn."""
    axis = np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0],
                     matrix[1, 0] - matrix[0, 1]])
    sine, cosine = np.linalg.norm(axis)/2, (np.trace(matrix) - 1)/2
    assert sine > 1e-6
    return axis/np.linalg.norm(axis), np.degrees(np.arctan2(sine, cosine))


name = sys.argv[1]
frame = matrices.get(name, np.eye(3))
elsewhere = 0.5*length/across*np.array((1, 0, 1))*("half a mesh cell" in name)
# A ring that is mirrored in its own plane is the same body
body = np.diag([1, 1, np.linalg.det(frame)])
random = np.random.default_rng(1)
clumps = []
for i in range(2):
    for j in range(layers):
        for k in range(2):
            place = length*np.array([(i + 0.5)/2, (j + 0.5)/layers, (k + 0.5)/2])
            place += random.uniform(-0.2e-6, 0.2e-6, 3)
            turn = rotation((1, 0, 0), radians(90)) @ rotation(
                random.normal(size=3), radians(random.uniform(1, 5)))
            place = frame @ (place - length/2) + length/2 + elsewhere
            axis, angle = axis_angle(frame @ turn @ body)
            clumps.append("{ type body; position (%.12g %.12g %.12g);" % tuple(place)
                          + " axis (%.12g %.12g %.12g);" % tuple(axis)
                          + " angle %.12g; }" % angle)
flow, gradient = frame @ (1, 0, 0), abs(frame @ (0, 1, 0))
d = "xyz"[int(np.argmax(gradient))]
top = flow*shear*length/2
if (frame @ (0, 1, 0)).sum() < 0:
    top = -top
moving = np.array((-speed*(name == "moving"), 0, 0))
print("flow (%g %g %g);" % tuple(moving), f"{d}Type wall; {d}U fixedValue; {d}P zeroGradient;",
      f"{d}0 (%g %g %g); {d}1 (%g %g %g);" % (*(moving - top), *(moving + top)))
print("places { type list; clumps (", *clumps, "); }", sep="\n")
