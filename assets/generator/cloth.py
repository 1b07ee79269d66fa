"""A square cloth over a round table, and a curtain."""

import math
import random

from generator import surfaces
from generator.furniture import TABLE_RADIUS, TABLE_TOP
from generator.mesh import Mesh
from generator.vectors import smoothstep

HALF_SIDE = 0.66  # of the table cloth
FOLDS = 13
LIFT = 0.0018  # of the cloth above the table
TABLE_CLOTH_TOP = TABLE_TOP + LIFT


def table_cloth():
    """Lies on the table and hangs over its edge; its corners hang lowest."""
    generator = random.Random(11)
    waves = _random_waves(generator, (1, 2, 3, 5), 0.25, 0.6)
    heights = [(n, generator.uniform(0, 2 * math.pi)) for n in (2, 3, 7)]
    columns, rows_down = 288, 30
    turns = [c / columns for c in range(columns)] + [0.0]
    rows, flat = [[(0.0, TABLE_CLOTH_TOP, 0.0)] * len(turns)], [[(0.0, 0.0)] * len(turns)]
    for k in range(1, 5):
        radius = k / 5 * TABLE_RADIUS
        rows.append([_on_table(turn, radius) for turn in turns])
        flat.append([_unfolded(turn, radius) for turn in turns])
    for k in range(rows_down + 1):
        t = (k / rows_down) ** 1.25
        rows.append([_hanging(turn, t, waves, heights) for turn in turns])
        flat.append([_unfolded(turn, _leaves_at() + t * _run(turn)) for turn in turns])
    mesh = Mesh("table_cloth", normals=False)
    mesh.add("linen", surfaces.grid(rows[::-1], uvs=flat[::-1]))
    return mesh


def _leaves_at():
    """The radius at which the cloth leaves the table's top."""
    return TABLE_RADIUS - 0.008


def _run(turn):
    """The length of cloth from there to the hem."""
    c, s = abs(math.cos(2 * math.pi * turn)), abs(math.sin(2 * math.pi * turn))
    return HALF_SIDE / (c**9 + s**9) ** (1 / 9) - _leaves_at()


def _unfolded(turn, radius):
    """A point of the cloth when it lies flat, in metres: its texture coordinates."""
    return radius * math.cos(2 * math.pi * turn), radius * math.sin(2 * math.pi * turn)


def _random_waves(generator, numbers, low, high):
    """For each wave number, itself, a phase, and an amplitude between `low` and `high`."""
    turn = 2 * math.pi
    return [(n, generator.uniform(0, turn), generator.uniform(low, high)) for n in numbers]


def _on_table(turn, radius):
    angle = -2 * math.pi * turn
    return (radius * math.cos(angle), TABLE_CLOTH_TOP, radius * math.sin(angle))


def _hanging(turn, t, waves, heights):
    """A point `t` of the way from where the cloth leaves the table top to its hem.

    Hung cloth is longer than the circle it hangs from: over an arc that has grown from R to R + s,
    n folds take up the excess with an amplitude of (2 R / n) sqrt(s / R).
    """
    angle = 2 * math.pi * turn
    edge, bend = _leaves_at(), 0.010
    run = t * _run(turn)
    around = min(run / bend, math.pi / 2)
    drop = bend * (1 - math.cos(around)) + max(run - bend * math.pi / 2, 0)
    radius = edge + bend * math.sin(around)
    phase = FOLDS * angle + sum(a * math.sin(n * angle + p) for n, p, a in waves)
    size = 0.95 + 0.25 * math.sin(heights[0][0] * angle + heights[0][1])
    size *= 0.85 + 0.15 * math.sin(heights[2][0] * angle + heights[2][1])
    amplitude = size * 2 * TABLE_RADIUS / FOLDS * math.sqrt(drop / TABLE_RADIUS)
    amplitude *= smoothstep((drop - 0.004) / 0.12)
    fold = math.cos(phase)
    radius += 0.05 * drop + amplitude * (fold + 0.55 * fold * fold + 0.1)
    sideways = 0.35 * amplitude / TABLE_RADIUS * math.sin(phase + 0.6)
    y = TABLE_CLOTH_TOP - drop * (1 - 0.06 * drop)
    return (radius * math.cos(angle + sideways), y, -radius * math.sin(angle + sideways))


def curtain():
    """Hangs in folds along X from 0 to 1, from y = 1 down to 0; scale it to its place."""
    generator = random.Random(5)
    shifts = _random_waves(generator, (1, 2, 4), 0.2, 0.5)
    columns, rows_up, folds = 224, 18, 8
    rows = []
    for r in range(rows_up + 1):
        y = r / rows_up
        row = []
        for c in range(columns + 1):
            x = c / columns
            phase = 2 * math.pi * folds * x
            phase += sum(a * math.sin(2 * math.pi * n * x + p + 0.9 * y) for n, p, a in shifts)
            depth = 0.045 * (1.0 - 0.35 * y) * (0.8 + 0.2 * math.sin(9.0 * x + 2 * y))
            fold = math.sin(phase)
            z = depth * (fold + 0.25 * math.sin(2 * phase + 1))
            row.append((x + 0.012 * math.sin(2 * phase), y, z))
        rows.append(row)
    mesh = Mesh("curtain", normals=False)
    mesh.add("linen", surfaces.grid(rows, uvs=surfaces.measured(rows)))
    return mesh
