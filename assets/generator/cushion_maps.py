"""A tufted seat cushion: heights to displace it by, and its striped cotton."""

import functools
import math
import random

from generator import fields, noise, png
from generator.palette import blended, rgb, shaded
from generator.vectors import smoothstep

SIZE = 512
TUFTS = 3  # buttons along a row across the cushion; every other row is shifted by half a step
RIM = 0.6  # the height at the rim
MADDER, CREAM, INDIGO = rgb("#a8402c"), rgb("#e2cfa6"), rgb("#33425c")


def _from_lattice(u, v):
    """Along both diagonals, in steps: the seams lie at integers, the buttons where they cross."""
    return (u - v) * TUFTS, (u + v - 1) * TUFTS


def _height(u, v):
    """0 to 1: pillows between the seams, pinched about the buttons, which stand in their pits."""
    s, t = _from_lattice(u, v)
    pillow = abs(math.sin(math.pi * s) * math.sin(math.pi * t)) ** 0.38
    ds, dt = s - round(s), t - round(t)
    from_button = math.hypot(ds, dt) * math.sqrt(0.5) / TUFTS  # in cushion widths
    pit = math.exp(-((from_button / 0.040) ** 2))
    button = math.sqrt(max(0.0, 1 - (from_button / 0.021) ** 2))
    ring = math.exp(-(((from_button - 0.040) / 0.022) ** 2))
    fold = 0.10 * math.cos(12 * math.atan2(ds, dt)) * ring
    height = 0.22 + 0.74 * pillow * (1 - 0.6 * pit) - 0.20 * pit + 0.18 * button
    height += 0.5 * fold * pillow
    border = smoothstep(min(u, 1 - u, v, 1 - v) / 0.09)  # calm at the rim, where the cord lies
    return RIM + (height - RIM) * border


def heights():
    return png.grey16(fields.field(SIZE, SIZE, _height))


@functools.cache
def _slubs():
    return noise.octaves(SIZE, SIZE, 24, 256, 2, random.Random(41), 0.8)


def color():
    """Stripes along v, as they are woven: a broad cream one between two fine lines of indigo."""

    def stripe(u, v):
        x = 6 * u % 1
        middle = abs(x - 0.5)
        cream = 1 - smoothstep((middle - 0.155) / 0.012)
        line = 1 - smoothstep((abs(middle - 0.215) - 0.020) / 0.012)
        fine = 1 - smoothstep((abs(middle - 0.42) - 0.010) / 0.010)
        cloth = blended(blended(MADDER, CREAM, max(cream, fine)), INDIGO, line)
        thread = 0.97 + 0.03 * math.cos(2 * math.pi * 128 * v) * math.cos(2 * math.pi * 128 * u)
        return shaded(cloth, thread)

    stripes = fields.field(SIZE, SIZE, stripe)
    return png.color(fields.combined(lambda c, n: shaded(c, 1 + 0.03 * n), stripes, _slubs()))
