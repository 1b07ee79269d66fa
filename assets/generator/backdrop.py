"""A seamless backdrop: a floor that curves up into a wall."""

import math

from generator import surfaces
from generator.mesh import Mesh

HALF_WIDTH, NEAR, BEND, TOP = 6.0, 7.0, 1.4, 6.0  # metres
BACK = -2.6  # where the wall stands


def backdrop():
    """The floor is the plane y = 0; the wall looks along +Z."""
    curve = [(0.0, NEAR)]
    for k in range(33):
        angle = math.pi / 2 * k / 32
        curve.append((BEND * (1 - math.cos(angle)), BACK + BEND * (1 - math.sin(angle))))
    curve.append((TOP, BACK))
    mesh = Mesh("backdrop")
    mesh.add("backdrop", surfaces.grid([[(-HALF_WIDTH, *p), (HALF_WIDTH, *p)] for p in curve]))
    return mesh
