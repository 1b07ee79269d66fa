"""Two plants in their pots: a rubber plant and a monstera."""

import math
import random

from generator import surfaces, vectors
from generator.leaf import Card
from generator.mesh import Mesh
from generator.surfaces import lathe, profile, spline, tube

LEAVES_PER_STEM = (15, 13, 14, 11)
MONSTERA_LEAVES = 13
GOLDEN_ANGLE = math.pi * (3 - math.sqrt(5))
CLEARANCE = 0.030  # least distance between points of two midribs, metres


def rubber_plant():
    """The pot stands on y = 0, in a saucer 22 mm deep; about 1.2 m tall."""
    generator = random.Random(3)
    mesh = Mesh("rubber_plant")
    outside = profile(
        "0,0 98,0 102,3 105,20 138,205 139,212 150,214 153,218 156,252 154,257 147,259 141,256 "
        "138,248 136,225 130,200"
    )
    mesh.add("pot", lathe(outside, 48))
    saucer = profile("0,-22 120,-22 125,-20 147,8 146,11 142,10.5 122,-11 0,-11.9")
    mesh.add("pot", lathe(saucer, 48))
    mesh.add("soil", _soil(generator, 0.1375, 0.232))
    taken = []
    for k, count in enumerate(LEAVES_PER_STEM):
        _stem(mesh, generator, k, count, taken)
    return mesh


def _soil(generator, radius, height):
    """Crumbs: a disk whose points lie up to 3 mm high or low."""
    rows = []
    for r in range(8):
        ring = radius * (1 - r / 7)
        angles = (-2 * math.pi * c / 32 for c in range(32))
        rows.append([])
        for angle in angles:
            y = height + (generator.uniform(-0.003, 0.003) if 0 < r < 7 else 0)
            rows[-1].append((ring * math.cos(angle), y, ring * math.sin(angle)))
    return surfaces.short_cut(surfaces.grid(rows, wrap_columns=True))


def _stem(mesh, generator, k, count, taken):
    heading = 2 * math.pi * k / len(LEAVES_PER_STEM) + 0.7
    height = generator.uniform(0.68, 0.98) if k else 1.02
    lean = 0.05 + 0.20 * generator.random()
    tip = (lean * math.cos(heading), 0.23 + height, lean * math.sin(heading))
    root = (0.045 * math.cos(heading), 0.22, 0.045 * math.sin(heading))
    middle = vectors.add(vectors.mix(root, tip, 0.5), (0.02 * math.sin(heading), 0.02, 0.0))
    path = spline([root, middle, tip], 8)
    radii = [0.0085 - 0.0055 * i / (len(path) - 1) for i in range(len(path))]
    mesh.add("stem", tube(path, radii, 10))
    for i in range(count):
        t = 0.20 + 0.80 * (i + 0.5 * (i == count - 1)) / count
        foot = path[min(round(t * (len(path) - 1)), len(path) - 1)]
        length = (0.21 - 0.06 * t) * generator.uniform(0.88, 1.12)
        rise = math.radians(8 + 58 * t**1.5) + generator.uniform(-0.12, 0.12)
        droop = 1.6 * generator.uniform(0.3, 0.7)
        for attempt in range(14):
            turn = heading + i * GOLDEN_ANGLE + generator.uniform(-0.3, 0.3) + 0.25 * attempt
            pitch = rise + 0.03 * attempt
            start, direction = _stalk(foot, turn, pitch, 0.035)
            card = Card(start, turn, pitch, (length, 0.54 * length), droop, 0.35)
            samples = [card.point(u, v) for u in (0.15, 0.5, 0.85) for v in (-0.7, 0, 0.7)]
            if _free(samples, taken):
                taken.append(samples)
                end = vectors.add(start, vectors.scale(direction, 0.004))
                mesh.add("stem", tube([foot, start, end], [0.003, 0.0024, 0.0015], 6, (0, 1, 0.1)))
                mesh.add("leaf", card.surface(6, 4))
                break


def _stalk(foot, turn, rise, length):
    """Its end, and its direction."""
    direction = vectors.rotate_y((math.cos(rise), math.sin(rise), 0), turn)
    return vectors.add(foot, vectors.scale(direction, length)), direction


def _free(samples, taken):
    return all(math.dist(p, q) >= CLEARANCE for other in taken for p in samples for q in other)


def monstera():
    """The pot stands on y = 0; about 0.9 m tall, on long stalks from one root."""
    generator = random.Random(9)
    mesh = Mesh("monstera")
    outside = spline(profile("86,0 112,28 136,90 140,150 126,210 112,232"), 5)
    lip = profile("112,240 117,246 118,252 114,256 108,254 105,244 108,225 112,200")
    mesh.add("pot", lathe([(0, 0), (0.08, 0.0)] + outside + lip, 64))
    mesh.add("soil", _soil(generator, 0.110, 0.222))
    for k in range(MONSTERA_LEAVES):
        t = (k + 0.5) / MONSTERA_LEAVES  # from the innermost, upright and young, to the outermost
        turn = k * GOLDEN_ANGLE + 0.4
        out = 0.06 + 0.30 * t + generator.uniform(-0.02, 0.02)
        top = 0.22 + (0.62 - 0.40 * t**1.4) * generator.uniform(0.92, 1.08)
        knots = [(0.02, 0.215, 0), (0.25 * out, 0.55 * top + 0.10, 0), (out, top, 0)]
        path = spline([vectors.rotate_y(p, turn) for p in knots], 7)
        radii = [0.0065 - 0.0025 * i / (len(path) - 1) for i in range(len(path))]
        across = vectors.rotate_y((0, 0, 1), turn)
        mesh.add("stem", tube(path, radii, 8, across))
        size = (0.21 + 0.10 * t) * generator.uniform(0.92, 1.08)
        rise, droop = math.radians(32 - 44 * t), generator.uniform(0.5, 0.9)
        lean = turn + generator.uniform(-0.35, 0.35)
        back, _ = _stalk(path[-1], lean, rise, -0.255 * size)  # the stalk joins within the card
        card = Card(back, lean, rise + 0.255 * droop, (size, size), droop, 0.16)
        shift = vectors.subtract(path[-1], card.point(0.255, 0))
        card.foot = vectors.add(back, shift)
        mesh.add("leaf", card.surface(8, 8))
    return mesh
