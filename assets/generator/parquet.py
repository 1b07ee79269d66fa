"""A herringbone parquet of oak blocks, four times as long as wide: colour, normals, roughness."""

import functools
import random

from generator import fields, noise, png
from generator.normals import normal_map
from generator.palette import blended, rgb
from generator.wood import Grain, oak

SIZE = 1024
LONG = 4  # the length of a block in widths
CELLS = 2 * LONG  # the pattern repeats after so many widths, across and along
GAP = rgb("#3a2616")


class Block:
    """What one block has of its own."""

    def __init__(self, generator):
        self.shift = generator.randrange(SIZE), generator.randrange(SIZE)
        self.tone = generator.uniform(0.88, 1.08)
        self.warmth = generator.uniform(-1, 1)
        self.tilt = generator.gauss(0, 0.16), generator.gauss(0, 0.06)
        self.gloss = generator.uniform(-0.03, 0.03)


def _place(u, v):
    """Which block is at (u, v), and where on it: across and along, both in block widths.

    In the grid of squares one block wide, a step to the right moves on along a lying block, a step
    up along a standing one; `k` counts through one of each.
    """
    x, y = u * CELLS, v * CELLS
    i, j = int(x), int(y)
    k = (i - j) % CELLS
    if k < LONG:
        return ("lying", (i - k) % CELLS, j), y - j, k + x - i
    k = CELLS - 1 - k
    return ("standing", i, (j - k) % CELLS), x - i, k + y - j


@functools.cache
def _surface():
    """For each pixel: colour, height and roughness."""
    generator = random.Random(21)
    blocks, grain = {}, Grain(SIZE, 22)
    grit = noise.octaves(SIZE, SIZE, 64, 64, 4, generator)
    pixels_per_width = SIZE // CELLS

    def surface(u, v):
        key, across, along = _place(u, v)
        block = blocks.get(key) or blocks.setdefault(key, Block(generator))
        edge = min(across, 1 - across, along, LONG - along)
        late, pore = grain.at(
            int(across * 1.9 * pixels_per_width) + block.shift[0],
            int(along * 1.3 * pixels_per_width) + block.shift[1],
        )
        seam = min(max((edge - 0.006) / 0.016, 0.0), 1.0)  # 0 in the gap, 1 on the wood
        bevel = min(max(edge / 0.038, 0.0), 1.0)
        color = blended(GAP, oak(late, pore, block.tone, block.warmth), seam)
        rise = 2.2 * (bevel - 1) * (1 - 0.5 * bevel) - 0.35 * pore - 0.12 * late
        rise += block.tilt[0] * (across - 0.5) + block.tilt[1] * (along - LONG / 2)
        return color, rise, 0.33 + block.gloss + 0.16 * pore + 0.30 * (1 - seam)

    plain = fields.field(SIZE, SIZE, surface)
    return fields.combined(
        lambda s, g: (s[0], s[1] + 0.03 * g, s[2] + 0.02 * g), plain, grit
    )


def color():
    return png.color([[s[0] for s in row] for row in _surface()])


def normals():
    return normal_map([[s[1] for s in row] for row in _surface()], 0.0016)


def roughness():
    half = [row[::2] for row in _surface()[::2]]
    return png.grey([[s[2] for s in row] for row in half])
