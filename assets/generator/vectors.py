"""Three-vectors as tuples, and rigid frames."""

import math


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a, factor):
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def length(a):
    return math.sqrt(dot(a, a))


def normalize(a):
    """The unit vector along `a`, which must not be zero."""
    return scale(a, 1.0 / length(a))


def mix(a, b, t):
    """`a` at t = 0, `b` at t = 1."""
    return add(scale(a, 1.0 - t), scale(b, t))


def smoothstep(t):
    """0 below t = 0, 1 above t = 1, and a smooth rise between."""
    t = min(max(t, 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


def rotate_y(p, angle):
    """`p` turned about +Y, counter-clockwise as seen from above."""
    c, s = math.cos(angle), math.sin(angle)
    return (c * p[0] + s * p[2], p[1], -s * p[0] + c * p[2])


class Frame:
    """A right-handed orthonormal frame: local x, y and z axes at an origin."""

    def __init__(self, origin=(0, 0, 0), x=(1, 0, 0), y=(0, 1, 0)):
        """`y` is kept; `x`, which must not be parallel to it, is made perpendicular."""
        self.origin = origin
        self.y = normalize(y)
        self.x = normalize(subtract(x, scale(self.y, dot(x, self.y))))
        self.z = cross(self.x, self.y)

    def direction(self, v):
        """From local to outer coordinates."""
        return add(add(scale(self.x, v[0]), scale(self.y, v[1])), scale(self.z, v[2]))

    def point(self, p):
        """From local to outer coordinates."""
        return add(self.origin, self.direction(p))


def about_y(origin, angle):
    """A frame turned about +Y, counter-clockwise as seen from above."""
    return Frame(origin, rotate_y((1, 0, 0), angle))
