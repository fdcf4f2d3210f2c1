"""What a lip does to a membrane of triangles that slides over it without friction.

    lip.py

A chain of straight edges is drawn around the corner between two flat walls at right angles, whose
edge is an arc of the radius a. Its nodes keep to the walls and the arc. Where it has moved by part
of an edge, the chord of each edge around the arc is another one, so that the far end has moved by
more or less than the near one: the tension T is not handed on in full. Printed over a and the
length d of an edge: the largest part of T that is lost where the chain would advance, and the
largest part by which it is driven.
"""

import numpy as np


def place(s, a):
    """The point at the length s along the walls from the beginning of the arc, d = 1"""
    arc = 0.5*np.pi*a
    if s <= 0:
        return np.array([-a, -s])
    if s < arc:
        return np.array([-a*np.cos(s/a), -a*np.sin(s/a)])
    return np.array([s - arc, -a])


def following(s, a):
    """Where the next node of the chain is"""
    start = place(s, a)
    low, high = s + 1, s + 3
    for _ in range(60):
        middle = 0.5*(low + high)
        if np.linalg.norm(place(middle, a) - start) < 1:
            low = middle
        else:
            high = middle
    return low


def gain(s, a):
    """By how much the far end is ahead of the length of the chain, from a node at -2 + s"""
    first = last = s - 2
    edges = int(2*a + 8)
    for _ in range(edges):
        last = following(last, a)
    return last - first - edges


if __name__ == "__main__":
    print("a/d   lost  driven, parts of the tension")
    for a in (0.1, 0.25, 0.5, 0.75, 1, 1.5, 2, 3):
        s = np.linspace(0, 1, 201)
        rate = np.gradient([gain(x, a) for x in s], s)
        print("%.2f  %.3f %.3f" % (a, -rate.min(), rate.max()))
