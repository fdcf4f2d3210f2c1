"""Frames of reference: the matrix that takes a vector of the first frame to that of another, and
the speed [m/s] of the moving one along the flow."""

import numpy as np

matrices = {
    "turned by half a turn": np.diag([-1, -1, 1]),
    "mirrored": np.diag([-1, 1, 1]),
    # Flow along z, gradient along x, vorticity along y
    "other axes": np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]]),
}

speed = 0.6e-3
