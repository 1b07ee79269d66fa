"""A sitting hare, cast in one piece: blended ellipsoids and capsules.

As glass it is seen through, so the surface is closed, and its points are evenly spread.
"""

import math

from generator import implicit, vectors
from generator.implicit import blend, capsule, carve, ellipsoid
from generator.mesh import Mesh

HEIGHT = 0.36  # metres to the tips of the ears; the field below has height 1
CELL = 0.0078  # of the field; at this size no two sheets of the surface share an edge
NECK = (0.09, 0.60, 0.0)
HEAD_TURN = math.radians(-14)
HEAD = (0.09, 0.82, 0.0), 0.32  # a ball about head and ears


def hare():
    """The hare sits on y = 0 and looks along +X, a little towards +Z."""
    surface = implicit.surface_net(_field, (-0.5, -0.06, -0.36), (0.5, 1.1, 0.36), CELL)
    surface.points = [vectors.scale(p, HEIGHT) for p in surface.points]
    mesh = Mesh("hare", normals=False)
    mesh.add("hare", surface)
    return mesh


def _field(p):
    """Signed distance to the hare, about."""
    mirrored = (p[0], p[1], abs(p[2]))
    width = 0.09
    if p[1] > 0.85:
        whole = _head(p)  # the body is too far to blend with
    else:
        whole = _body(mirrored)
        if math.dist(p, HEAD[0]) - HEAD[1] < whole + width:
            whole = blend(whole, _head(p), width)
    return -blend(-whole, p[1], 0.012)  # cut flat at y = 0, with a rounded edge


def _body(p):
    """`p` has z >= 0: both sides are alike."""
    d = ellipsoid(p, (-0.10, 0.25, 0), (0.22, 0.22, 0.165))
    d = blend(d, ellipsoid(p, (0.06, 0.36, 0), (0.135, 0.22, 0.125)), 0.12)
    d = blend(d, capsule(p, (0.06, 0.45, 0), (0.10, 0.63, 0), 0.105, 0.07), 0.10)
    d = blend(d, ellipsoid(p, (-0.08, 0.18, 0.13), (0.155, 0.155, 0.075)), 0.030)  # thigh
    d = blend(d, capsule(p, (-0.12, 0.03, 0.15), (0.09, 0.025, 0.17), 0.045, 0.036), 0.030)
    d = blend(d, capsule(p, (0.12, 0.36, 0.062), (0.165, 0.05, 0.062), 0.058, 0.034), 0.045)
    d = blend(d, ellipsoid(p, (0.195, 0.022, 0.062), (0.065, 0.034, 0.040)), 0.03)  # paw
    return blend(d, ellipsoid(p, (-0.325, 0.12, 0), (0.075, 0.065, 0.06)), 0.03)  # tail


def _head(p):
    q = vectors.add(NECK, vectors.rotate_y(vectors.subtract(p, NECK), -HEAD_TURN))
    side = 1.0 if q[2] >= 0 else -1.0
    m = (q[0], q[1], abs(q[2]))
    d = ellipsoid(m, (0.135, 0.685, 0), (0.125, 0.098, 0.082))
    d = blend(d, ellipsoid(m, (0.225, 0.655, 0), (0.072, 0.058, 0.052)), 0.07)  # muzzle
    d = blend(d, ellipsoid(m, (0.155, 0.645, 0.045), (0.075, 0.058, 0.042)), 0.05)  # cheek
    d = carve(d, ellipsoid(m, (0.19, 0.725, 0.095), (0.035, 0.026, 0.028)), 0.03)  # eye socket
    d = blend(d, ellipsoid(m, (0.180, 0.718, 0.066), (0.021, 0.021, 0.017)), 0.006)
    return blend(d, _ear(m, side), 0.04)


def _ear(m, side):
    """A long leaf that leans back, hollow in front; the far one leans a little more."""
    lean = 0.30 if side > 0 else 0.42
    spread = 0.20
    root = vectors.subtract(m, (0.075, 0.745, 0.040))
    x = math.cos(lean) * root[0] + math.sin(lean) * root[1]
    y = -math.sin(lean) * root[0] + math.cos(lean) * root[1]
    up = math.cos(spread) * y + math.sin(spread) * root[2]
    out = -math.sin(spread) * y + math.cos(spread) * root[2]
    turned = vectors.rotate_y((x, up, out), 0.7)
    d = ellipsoid(turned, (0, 0.14, 0), (0.030, 0.175, 0.058))
    return carve(d, ellipsoid(turned, (0.040, 0.15, 0), (0.030, 0.135, 0.038)), 0.012)
