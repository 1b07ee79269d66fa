"""A monstera's leaf, split and pierced: colour with alpha, and normals. The tip is at u = 1."""

import functools
import math
import random

from generator import fields, noise, png
from generator.brush import Canvas
from generator.normals import normal_map
from generator.palette import blended, rgb, shaded
from generator.surfaces import spline

SIZE = 512
STALK = (0.255, 0.5)  # where the stalk meets the blade
OUTLINE = (  # degrees from the midrib, distance from the stalk
    (0, 0.725), (12, 0.660), (28, 0.590), (52, 0.535), (80, 0.470), (108, 0.390), (136, 0.310),
    (158, 0.242), (172, 0.150), (180, 0.045),
)
VEINS = (  # where on the midrib, and towards which angle of the outline
    (0.00, 150), (0.03, 118), (0.10, 92), (0.19, 71), (0.29, 53), (0.39, 38), (0.49, 25.5),
    (0.58, 14.5),
)
DEEP, FRESH, VEIN = rgb("#2c5f33"), rgb("#5d9a45"), rgb("#b4c983")


@functools.cache
def _reach():
    """The outline's radius at every half degree."""
    curve = spline([(float(a), r) for a, r in OUTLINE], 64)
    radii, k = [], 0
    for half_degree in range(361):
        while k < len(curve) - 2 and curve[k + 1][0] < half_degree / 2:
            k += 1
        (a, p), (b, q) = curve[k], curve[k + 1]
        radii.append(p + (q - p) * (half_degree / 2 - a) / (b - a))
    return radii


def _outline(degrees):
    radii = _reach()
    at = min(max(2 * degrees, 0.0), 359.999)
    i = int(at)
    return radii[i] + (radii[i + 1] - radii[i]) * (at - i)


def _margin(along, degrees, part):
    """A point on the way from the midrib to the outline, on the upper side."""
    x0, y0 = STALK[0] + along, STALK[1]
    reach = _outline(degrees)
    x1 = STALK[0] + reach * math.cos(math.radians(degrees))
    y1 = STALK[1] + reach * math.sin(math.radians(degrees))
    bow = 0.05 * part * (1 - part)
    return x0 + (x1 - x0) * part - bow, y0 + (y1 - y0) * part + bow


def _both(canvas, points, radii):
    canvas.stroke(points, radii)
    canvas.stroke([(x, 1 - y) for x, y in points], radii)


@functools.cache
def _veins():
    canvas = Canvas(SIZE, SIZE, 26.0)
    canvas.stroke([STALK, (0.6, 0.5), (0.965, 0.5)], [0.0078, 0.0055, 0.001])
    for along, degrees in VEINS:
        path = [_margin(along, degrees, part) for part in (0, 0.35, 0.7, 0.96)]
        _both(canvas, path, [0.0040, 0.0032, 0.0022, 0.0006])
    return canvas.distances


@functools.cache
def _cuts():
    """Between two veins a split from the margin inwards, and a hole near the midrib."""
    canvas = Canvas(SIZE, SIZE, 3.0)
    pairs = list(zip(VEINS, VEINS[1:]))
    for k, ((a, low), (b, high)) in enumerate(pairs[1:]):
        along, degrees = (a + b) / 2, (low + high) / 2
        depth = (0.62, 0.50, 0.44, 0.47, 0.56, 0.70)[k]
        split = [_margin(along, degrees, depth + (1.12 - depth) * t) for t in (0, 0.4, 1)]
        _both(canvas, split, [0.009, 0.013, 0.030 - 0.003 * k])
        if k < 5:
            hole = [_margin(along, degrees, part) for part in (0.16, depth - 0.20)]
            _both(canvas, hole, [0.0075, 0.0125 - 0.001 * k])
    return canvas.distances


def _inside(u, v, cut):
    """Distance to the edge in pixels, about; positive on the leaf."""
    x, y = u - STALK[0], abs(v - STALK[1])
    degrees = math.degrees(math.atan2(y, x))
    return min((_outline(degrees) - math.hypot(x, y)) * SIZE * 0.9, cut)


def color():
    generator = random.Random(71)
    clouds = noise.octaves(SIZE, SIZE, 6, 6, 4, generator)
    places = fields.field(SIZE, SIZE, lambda u, v: (u, v))

    def paint(place, vein, cut, cloud):
        inside = _inside(*place, cut)
        young = min(max(0.40 + 0.20 * cloud + 0.35 * (place[0] - 0.5), 0), 1)
        green = blended(DEEP, FRESH, young)
        green = blended(green, VEIN, 0.6 * min(max(1.2 - vein / 1.5, 0), 1))
        green = blended(green, shaded(DEEP, 0.85), 0.35 * math.exp(-((vein - 7) / 5) ** 2))
        green = blended(green, FRESH, 0.6 * min(max(1 - inside / 4, 0), 1))
        return green + (min(max(inside + 0.5, 0.0), 1.0),)

    return png.color(fields.combined(paint, places, _veins(), _cuts(), clouds))


def normals():
    """The blade swells between its veins and turns down at its edges."""
    places = fields.field(SIZE, SIZE, lambda u, v: (u, v))

    def rise(place, vein, cut):
        swell = math.sqrt(min(max(vein, 0.0) / 24, 1.0))
        ridge = 0.35 * math.exp(-max(vein, -3) ** 2 / 6)
        edge = min(max(_inside(*place, cut) / 8, 0.0), 1.0)
        return swell * (0.5 + 0.5 * edge) + ridge

    return normal_map(fields.combined(rise, places, _veins(), _cuts()), 0.011)
