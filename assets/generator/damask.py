"""An embossed damask wallpaper: palmettes framed by rising ogee stems, in half-drop repeat."""

import functools
import math
import random

from generator import fields, noise, png
from generator.brush import Canvas, mirrored, turned
from generator.normals import normal_map
from generator.palette import blended, rgb

SIZE = 768  # holds two palmettes, half a tile apart across and up
PAPER, INK = rgb("#ddd2bb"), rgb("#c9b48d")


@functools.cache
def _distances():
    canvas = Canvas(SIZE, SIZE, 14.0)
    for x, y in ((0.25, 0.25), (0.75, 0.75)):
        _palmette(canvas, x, y)
        _stems(canvas, x, y)
    return canvas.distances


def _both(canvas, x, points, radii):
    """A stroke and its mirror image."""
    canvas.stroke(points, radii)
    canvas.stroke(mirrored(points, x), radii)


def _palmette(canvas, x, y):
    """A fan of leaves about a flower, over two scrolls and a drop of husks."""

    def at(points):
        return [(x + px, y + py) for px, py in points]

    heart = (x, y)
    for k, size in enumerate((0.290, 0.262, 0.228, 0.192, 0.158)):
        leaf = at([(0, 0.075), (0, 0.62 * size), (0, size)])
        _both(canvas, x, turned(leaf, -0.44 * k, heart), [0.003, 0.029 - 0.0028 * k, 0.001])
        bead = turned(at([(0, 0.86 * size)]), -0.44 * (k + 0.5), heart)
        _both(canvas, x, bead * 2, [0.0065 - 0.0006 * k] * 2)
    canvas.dot(*heart, 0.017)
    for k in range(10):
        petal = turned(at([(0, 0.028), (0, 0.048)]), math.pi * (k + 0.5) / 5, heart)
        canvas.stroke(petal, [0.004, 0.0095])
    scroll = [
        (0.012, -0.105), (0.085, -0.112), (0.160, -0.088), (0.205, -0.030), (0.192, 0.022),
        (0.155, 0.020), (0.150, -0.012), (0.170, -0.018),
    ]
    _both(canvas, x, at(scroll), [0.002, 0.011, 0.014, 0.012, 0.009, 0.007, 0.007, 0.010])
    curl = [(0.060, -0.118), (0.100, -0.150), (0.140, -0.142), (0.138, -0.112), (0.120, -0.118)]
    _both(canvas, x, at(curl), [0.003, 0.008, 0.007, 0.006, 0.008])
    for side in (-1, 1):
        husk = [(0, -0.10), (side * 0.035, -0.165), (side * 0.030, -0.225), (side * 0.012, -0.26)]
        canvas.stroke(at(husk), [0.003, 0.013, 0.010, 0.001])
    canvas.stroke(at([(0, -0.10), (0, -0.20), (0, -0.31)]), [0.004, 0.014, 0.001])
    for k in range(3):
        canvas.dot(x, y - 0.335 - 0.024 * k, 0.0080 - 0.0016 * k)


def _stems(canvas, x, y):
    """From half a tile below (x, y), out and up on either side to the palmettes' widest points."""

    def along(t):
        return (x + 0.25 - 0.235 * math.cos(math.pi * t), y - 0.5 + 0.5 * t)

    _both(canvas, x, [along(k / 16) for k in range(17)], [0.0065] * 17)
    for k in range(1, 10):
        t, side = k / 10, 1 if k % 2 else -1
        size = 0.075 + 0.02 * math.sin(math.pi * t)
        rise = math.atan2(0.5, 0.235 * math.pi * math.sin(math.pi * t))
        x0, y0 = along(t)
        leaf = [(x0, y0), (x0 + 0.5 * size, y0 + 0.10 * size * side), (x0 + size, y0)]
        _both(canvas, x, turned(leaf, rise + 0.72 * side, (x0, y0)), [0.002, 0.0125, 0.001])
    canvas.dot(x, y - 0.5, 0.022)
    for k in range(8):
        bead = turned([(x + 0.037, y - 0.5)], math.pi * (k + 0.5) / 4, (x, y - 0.5))[0]
        canvas.dot(*bead, 0.0065)


@functools.cache
def _paper():
    generator = random.Random(31)
    fibres = noise.octaves(SIZE, SIZE, 96, 96, 3, generator, 0.7)
    clouds = noise.octaves(SIZE, SIZE, 3, 3, 4, generator)
    return fibres, clouds


def color():
    fibres, clouds = _paper()

    def paint(distance, fibre, cloud):
        ink = min(max(0.5 - distance, 0.0), 1.0)
        base = blended(PAPER, INK, 0.85 * ink)
        light = 1 + 0.012 * cloud + 0.006 * fibre
        return tuple(channel * light for channel in base)

    return png.color(fields.combined(paint, _distances(), *_paper()))


def normals():
    fibres, _ = _paper()

    def rise(distance, fibre):
        """The ink swells to a rounded ridge 10 pixels from its edge."""
        inside = min(max((2.0 - distance) / 11, 0.0), 1.0)
        return math.sin(math.pi / 2 * inside) + 0.035 * fibre

    return normal_map(fields.combined(rise, _distances(), fibres), 0.0050)
