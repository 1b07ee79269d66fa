"""A rubber plant in a terracotta pot."""

import math
import random

from generator import surfaces, vectors
from generator.mesh import Mesh
from generator.surfaces import lathe, profile, spline, tube
from generator.vectors import Frame

LEAVES_PER_STEM = (15, 13, 14, 11)
GOLDEN_ANGLE = math.pi * (3 - math.sqrt(5))
CLEARANCE = 0.030  # least distance between points of two midribs, metres


def potted_plant():
    """The pot stands on y = 0, in a saucer 22 mm deep; about 1.2 m tall."""
    generator = random.Random(3)
    mesh = Mesh("potted_plant")
    outside = profile(
        "0,0 98,0 102,3 105,20 138,205 139,212 150,214 153,218 156,252 154,257 147,259 141,256 "
        "138,248 136,225 130,200"
    )
    mesh.add("terracotta", lathe(outside, 96))
    saucer = profile("0,-22 120,-22 125,-20 147,8 146,11 142,10.5 122,-11 0,-11.9")
    mesh.add("terracotta", lathe(saucer, 96))
    mesh.add("soil", _soil(generator))
    taken = []
    for k, count in enumerate(LEAVES_PER_STEM):
        _stem(mesh, generator, k, count, taken)
    return mesh


def _soil(generator):
    """Crumbs: a disk whose points lie up to 3 mm high or low."""
    rows = []
    for r in range(10):
        radius = 0.1375 * (1 - r / 9)
        angles = (-2 * math.pi * c / 48 for c in range(48))
        rows.append([])
        for angle in angles:
            y = 0.232 + (generator.uniform(-0.003, 0.003) if 0 < r < 9 else 0)
            rows[-1].append((radius * math.cos(angle), y, radius * math.sin(angle)))
    return surfaces.triangulated(surfaces.grid(rows, wrap_columns=True))


def _stem(mesh, generator, k, count, taken):
    heading = 2 * math.pi * k / len(LEAVES_PER_STEM) + 0.7
    height = generator.uniform(0.68, 0.98) if k else 1.02
    lean = 0.05 + 0.20 * generator.random()
    tip = (lean * math.cos(heading), 0.23 + height, lean * math.sin(heading))
    root = (0.045 * math.cos(heading), 0.22, 0.045 * math.sin(heading))
    middle = vectors.add(vectors.mix(root, tip, 0.5), (0.02 * math.sin(heading), 0.02, 0.0))
    path = spline([root, middle, tip], 20)
    radii = [0.0085 - 0.0055 * i / (len(path) - 1) for i in range(len(path))]
    mesh.add("stem", tube(path, radii, 16))
    for i in range(count):
        t = 0.20 + 0.80 * (i + 0.5 * (i == count - 1)) / count
        foot = path[min(int(t * (len(path) - 1)), len(path) - 1)]
        size = (0.19 - 0.06 * t) * generator.uniform(0.88, 1.12)
        rise = math.radians(8 + 58 * t**1.5) + generator.uniform(-0.12, 0.12)
        for attempt in range(14):
            turn = heading + i * GOLDEN_ANGLE + generator.uniform(-0.3, 0.3) + 0.25 * attempt
            leaf = Leaf(foot, turn, rise + 0.03 * attempt, size, generator.uniform(0.3, 0.7))
            if not leaf.touches(taken):
                taken.append(leaf.samples)
                mesh.add("stem", leaf.stalk())
                mesh.add(generator.choice(["leaf", "leaf", "youngleaf", "oldleaf"]), leaf.blade())
                break


class Leaf:
    """A blade bent along its midrib and folded up a little across it."""

    def __init__(self, foot, turn, rise, size, droop):
        self.foot, self.turn, self.rise, self.size, self.droop = foot, turn, rise, size, droop
        self.samples = [self._point(u, v) for u in (0.15, 0.5, 0.85) for v in (-0.7, 0, 0.7)]

    def touches(self, others):
        return any(
            vectors.length(vectors.subtract(p, q)) < CLEARANCE
            for other in others
            for p in self.samples
            for q in other
        )

    def _midrib(self, u):
        """The point `u` of the way from the end of the stalk to the tip, and the pitch there."""
        steps = 12
        stalk = 0.035
        x, y = stalk * math.cos(self.rise), stalk * math.sin(self.rise)
        for i in range(steps):
            pitch = self.rise - self.droop * 1.6 * u * (i + 0.5) / steps
            x += self.size * u / steps * math.cos(pitch)
            y += self.size * u / steps * math.sin(pitch)
        return x, y, self.rise - self.droop * 1.6 * u

    def _point(self, u, v):
        x, y, pitch = self._midrib(u)
        half = 0.235 * self.size * max(math.sin(math.pi * u**0.85), 0) ** 0.8 * (1 - 0.25 * u)
        fold = 0.35 * abs(v) + 0.10 * v * v
        ripple = 0.05 * math.sin(9 * u + 2 * self.turn) * v * v
        up = half * (fold + ripple)
        local = (x - up * math.sin(pitch), y + up * math.cos(pitch), half * v)
        return vectors.add(self.foot, vectors.rotate_y(local, self.turn))

    def stalk(self):
        x, y, _ = self._midrib(0.04)
        end = vectors.add(self.foot, vectors.rotate_y((x, y - 0.001, 0), self.turn))
        path = [vectors.mix(self.foot, end, t / 4) for t in range(5)]
        across = vectors.rotate_y((0, 0, 1), self.turn)
        return tube(path, [0.0032, 0.0028, 0.0025, 0.0022, 0.0015], 10, across)

    def blade(self):
        rows = [[self._point(i / 18, k / 4 - 1) for k in range(9)] for i in range(19)]
        return surfaces.triangulated(surfaces.grid(rows))
