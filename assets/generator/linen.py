"""A plain weave of uneven threads, as normals."""

import math
import random

from generator import fields, noise
from generator.normals import normal_map

SIZE, THREADS = 512, 48


def normals():
    generator = random.Random(51)
    warp = noise.octave(SIZE, SIZE, THREADS, 8, generator)
    weft = noise.octave(SIZE, SIZE, 8, THREADS, generator)

    def rise(u, v):
        """Warp and weft pass over each other in turn; the higher of the two is seen."""
        x, y = math.pi * THREADS * u, math.pi * THREADS * v
        over = math.cos(x) * math.cos(y)
        return abs(math.sin(x)) ** 0.6 * (1 + over), abs(math.sin(y)) ** 0.6 * (1 - over)

    def woven(sides, a, b):
        return max(sides[0] * (1 + 0.25 * a), sides[1] * (1 + 0.25 * b))

    heights = fields.combined(woven, fields.field(SIZE, SIZE, rise), warp, weft)
    return normal_map(heights, 0.0022)
