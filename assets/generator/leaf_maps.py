"""A rubber plant's leaf: colour with its outline as alpha, and normals. The stalk is at u = 0."""

import functools
import math
import random

from generator import fields, noise, png
from generator.brush import Canvas
from generator.normals import normal_map
from generator.palette import blended, rgb, shaded

WIDTH, HEIGHT = 512, 256
DEEP, FRESH, VEIN, MARGIN = rgb("#2f5a2b"), rgb("#5b8f3c"), rgb("#a9bf74"), rgb("#7a9a48")


def half_width(u):
    """Of the blade, in heights of the map: broadest before its middle, with a drawn-out tip."""
    if not 0.0 < u < 1.0:
        return 0.0
    return 0.46 * math.sin(math.pi * u**0.88) ** 0.72 * (1 - 0.22 * u) + 0.012 * (1 - u)


def _inside(u, v):
    """Distance to the outline in pixels, about; positive on the leaf."""
    step = 1e-3
    slope = (half_width(u + step) - half_width(u - step)) / (2 * step) * HEIGHT / WIDTH
    return (half_width(u) - abs(v - 0.5)) * HEIGHT / math.hypot(1.0, slope)


@functools.cache
def _veins():
    """Distances in pixels to the midrib with its pairs of side veins."""
    canvas = Canvas(WIDTH, HEIGHT, 20.0)
    canvas.stroke([(0.0, 0.25), (0.5, 0.25), (0.985, 0.25)], [0.0075, 0.0050, 0.001])
    for k in range(15):
        u = 0.05 + 0.058 * k
        reach = half_width(min(u + 0.08, 0.99)) / 2
        ends = [(u, 0.25), (u + 0.45 * reach, 0.25 + 0.62 * reach)]
        ends.append((u + 1.0 * reach, 0.25 + 0.98 * reach))
        for side in (ends, [(x, 0.5 - y) for x, y in ends]):
            canvas.stroke(side, [0.0022, 0.0015, 0.0003])
    return canvas.distances


def color():
    generator = random.Random(61)
    clouds = noise.octaves(WIDTH, HEIGHT, 8, 4, 4, generator)
    places = fields.field(WIDTH, HEIGHT, lambda u, v: (u, v))

    def paint(place, vein, cloud):
        inside = _inside(*place)
        green = blended(DEEP, FRESH, min(max(0.42 + 0.22 * cloud, 0), 1))
        green = blended(green, VEIN, 0.75 * min(max(1.2 - vein / 1.6, 0), 1))
        green = blended(green, shaded(DEEP, 0.9), 0.35 * math.exp(-((vein - 5) / 4) ** 2))
        green = blended(green, MARGIN, 0.7 * min(max(1 - inside / 3.5, 0), 1))
        return green + (min(max(inside + 0.5, 0.0), 1.0),)

    return png.color(fields.combined(paint, places, _veins(), clouds))


def normals():
    """The blade swells between its veins."""

    def rise(vein):
        return math.sqrt(min(max(vein, 0.0) / 18, 1.0)) + 0.35 * math.exp(-max(vein, -3) ** 2 / 5)

    return normal_map(fields.combined(rise, _veins()), 0.010)
