"""Wood: growth rings cut lengthwise, and pores, as a tileable board along v; oak and walnut."""

import math
import random

from generator import noise, png
from generator.palette import blended, rgb, shaded

EARLY, LATE, PORE = rgb("#c99a63"), rgb("#a06f3e"), rgb("#6f4a28")


class Grain:
    """A board `size` pixels square; `at` reads it with wrap, so that planks may share one board."""

    def __init__(self, size, seed):
        generator = random.Random(seed)
        self.size = size
        warp = noise.octaves(size, size, 3, 2, 4, generator)
        fibre = noise.octaves(size, size, size // 4, 4, 2, generator, 0.8)
        pores = noise.octave(size, size, size // 2, size // 24, generator)
        clouds = noise.octaves(size, size, 4, 3, 3, generator)
        self._late, self._pores = [], []
        for r in range(size):
            v = 2 * math.pi * r / size
            arch = 1.1 * math.cos(v) + 0.35 * math.sin(2 * v)
            late, holes = [], []
            for c in range(size):
                u = c / size
                hill = math.sin(math.pi * u)
                ring = 9 * u + arch * hill + 0.42 * warp[r][c]
                phase = ring - math.floor(ring)
                late.append(0.62 * phase**2.2 + 0.13 * fibre[r][c] + 0.10 * clouds[r][c])
                open_ = pores[r][c] - 1.0 + 0.45 * (phase < 0.35)
                holes.append(min(max(1.6 * open_, 0.0), 1.0))
            self._late.append(late)
            self._pores.append(holes)

    def at(self, column, row):
        """How much late wood there is, about 0 to 1, and how deep a pore, 0 to 1."""
        r, c = row % self.size, column % self.size
        return self._late[r][c], self._pores[r][c]


def oak(late, pore, tone=1.0, warmth=0.0):
    """The colour of oiled oak; `warmth` from -1 (greyer) to 1 (redder)."""
    base = blended(EARLY, LATE, min(max(late, -0.2), 1.2))
    base = blended(base, PORE, 0.55 * pore)
    r, g, b = shaded(base, tone)
    return (r * (1 + 0.025 * warmth), g, b * (1 - 0.06 * warmth))


def walnut():
    """The colour of a board of polished walnut."""
    grain = Grain(512, 23)

    def paint(c, r):
        late, pore = grain.at(c, r)
        base = blended(rgb("#8a5f3e"), rgb("#543420"), min(max(late, -0.2), 1.2))
        return blended(base, rgb("#2f1c10"), 0.45 * pore)

    return png.color([[paint(c, r) for c in range(512)] for r in range(512)])
