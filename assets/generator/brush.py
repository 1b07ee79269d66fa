"""Drawings as distances: strokes of varying width on a tileable canvas."""

import math

from generator.surfaces import spline

FAR = 1e9


class Canvas:
    """The distance in pixels to the nearest stroke, negative inside, known up to `reach` outside.

    Strokes are given in units of the canvas's width, y up from its lower left corner.
    """

    def __init__(self, width, height, reach=2.0):
        self.width, self.height, self.reach = width, height, reach
        self.distances = [[FAR] * width for _ in range(height)]

    def stroke(self, points, radii, steps=8):
        """A smooth curve through `points`, whose radius runs through `radii`."""
        knots = [p + (r,) for p, r in zip(points, radii)]
        path = spline(knots, steps) if len(knots) > 2 else knots
        for a, b in zip(path, path[1:]):
            self._segment(*(self.width * v for v in a + b))

    def dot(self, x, y, radius):
        self._segment(*(self.width * v for v in (x, y, radius, x, y, radius)))

    def _segment(self, ax, ay, ar, bx, by, br):
        margin = max(ar, br) + self.reach
        if margin <= self.reach:
            return
        first, last = math.floor(min(ax, bx) - margin), math.ceil(max(ax, bx) + margin)
        low, high = math.floor(min(ay, by) - margin), math.ceil(max(ay, by) + margin)
        dx, dy, dr = bx - ax, by - ay, br - ar
        along = dx * dx + dy * dy
        inverse = 1 / along if along > 0 else 0.0
        width, height = self.width, self.height
        for y in range(low, high):
            row = self.distances[(height - 1 - y) % height]
            oy = y + 0.5 - ay
            for x in range(first, last):
                ox = x + 0.5 - ax
                t = (ox * dx + oy * dy) * inverse
                t = 0.0 if t < 0 else 1.0 if t > 1 else t
                ex, ey = ox - t * dx, oy - t * dy
                distance = math.sqrt(ex * ex + ey * ey) - (ar + t * dr)
                column = x % width
                if distance < row[column]:
                    row[column] = distance


def turned(points, angle, center=(0.0, 0.0)):
    """`points` turned counter-clockwise about `center`."""
    c, s = math.cos(angle), math.sin(angle)
    x0, y0 = center
    return [
        (x0 + c * (x - x0) - s * (y - y0), y0 + s * (x - x0) + c * (y - y0)) for x, y in points
    ]


def mirrored(points, x):
    """`points` mirrored in the vertical line at `x`."""
    return [(2 * x - px, py) for px, py in points]
