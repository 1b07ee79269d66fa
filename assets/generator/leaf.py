"""Leaves as bent cards that a texture's alpha cuts out."""

import math

from generator import surfaces, vectors


class Card:
    """A card bent along its midrib and folded up along it; u runs from the stalk to the tip."""

    def __init__(self, foot, turn, rise, size, droop, fold):
        """`foot`: where it begins; `turn` about +Y and `rise` above the horizon: where it points.

        `size` is its length and width, `droop` the angle that it bends down by, `fold` the slope
        of its halves.
        """
        self.foot, self.turn, self.rise = foot, turn, rise
        self.size, self.droop, self.fold = size, droop, fold

    def point(self, u, v):
        """`v` from -1 to 1 across."""
        steps = 8
        x = y = 0.0
        for i in range(steps):
            pitch = self.rise - self.droop * u * (i + 0.5) / steps
            x += self.size[0] * u / steps * math.cos(pitch)
            y += self.size[0] * u / steps * math.sin(pitch)
        pitch = self.rise - self.droop * u
        half = self.size[1] / 2
        up = half * (self.fold * abs(v) + 0.10 * v * v + 0.05 * math.sin(8 * u + self.turn) * v * v)
        local = (x - up * math.sin(pitch), y + up * math.cos(pitch), -half * v)
        return vectors.add(self.foot, vectors.rotate_y(local, self.turn))

    def surface(self, along, across):
        """A grid of so many quads; its front looks up."""
        rows, uvs = [], []
        for r in range(across + 1):
            vs = 2 * r / across - 1
            rows.append([self.point(c / along, vs) for c in range(along + 1)])
            uvs.append([(c / along, r / across) for c in range(along + 1)])
        return surfaces.short_cut(surfaces.grid(rows, uvs=uvs))
