"""Surfaces of signed distance fields by naive surface nets (Gibson 1998)."""

import itertools
import math

from generator import vectors
from generator.mesh import Surface
from generator.surfaces import short_cut

BLOCK = 4  # cells along the side of a block that is skipped or walked as a whole
EVENINGS = 2  # passes that spread the points evenly
SLACK = 1.3  # how much the field may overestimate distances


def ellipsoid(p, center, radii):
    """An estimate of the signed distance to an axis-aligned ellipsoid, exact at its surface."""
    q = [(p[k] - center[k]) / radii[k] for k in range(3)]
    inner = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
    outer = math.sqrt(sum((q[k] / radii[k]) ** 2 for k in range(3)))
    return -min(radii) if outer == 0 else inner * (inner - 1) / outer


def capsule(p, a, b, radius_a, radius_b):
    """Distance to the segment from `a` to `b` less a radius that goes from one to the other."""
    along = vectors.subtract(b, a)
    offset = vectors.subtract(p, a)
    t = min(max(vectors.dot(offset, along) / vectors.dot(along, along), 0.0), 1.0)
    nearest = vectors.subtract(offset, vectors.scale(along, t))
    return vectors.length(nearest) - (radius_a + (radius_b - radius_a) * t)


def blend(a, b, width):
    """The union of two fields, rounded where they differ by less than `width`."""
    h = max(width - abs(a - b), 0.0) / width
    return min(a, b) - h * h * width / 4


def carve(a, b, width):
    """Field `a` less field `b`, rounded."""
    return -blend(-a, b, width)


def surface_net(field, low, high, cell):
    """The zero surface of `field` between two corners, with one point per cell it crosses."""
    counts = [math.ceil((high[k] - low[k]) / cell) for k in range(3)]
    values = {}

    def position(i):
        return tuple(low[k] + i[k] * cell for k in range(3))

    def value(i):
        if i not in values:
            values[i] = field(position(i))
        return values[i]

    points, index, active = [], {}, []
    for base in _blocks(counts):
        reach = BLOCK * cell * math.sqrt(3) / 2
        if abs(field(position([b + BLOCK / 2 for b in base]))) > reach * SLACK:
            continue
        for offset in itertools.product(range(BLOCK), repeat=3):
            i = tuple(b + o for b, o in zip(base, offset))
            point = _crossing(i, value)
            if point:
                index[i] = len(points)
                active.append(i)
                points.append(_onto(field, position(point), cell))
    faces = _quads(active, index, value)
    for _ in range(EVENINGS):
        points = _evened(points, faces, field, cell)
    return short_cut(Surface(points, faces))


def _evened(points, faces, field, cell):
    """Each point half way to the mean of its neighbours, and back onto the surface.

    Evenly spread points make area-weighted normals smooth, which refraction shows.
    """
    sums, counts = [(0.0, 0.0, 0.0)] * len(points), [0] * len(points)
    for face in faces:
        for k, corner in enumerate(face):
            sums[corner] = vectors.add(sums[corner], points[face[k - 1]])
            counts[corner] += 1
    result = []
    for p, total, count in zip(points, sums, counts):
        result.append(_onto(field, vectors.mix(p, vectors.scale(total, 1 / count), 0.5), cell))
    return result


def _blocks(counts):
    return itertools.product(*(range(0, count, BLOCK) for count in counts))


CORNERS = list(itertools.product((0, 1), repeat=3))
EDGES = [(a, b) for a, b in itertools.product(CORNERS, CORNERS) if math.dist(a, b) == 1 and a < b]


def _crossing(i, value):
    """The mean of where the field changes sign along the edges of cell `i`, in cells; or None."""
    at = {c: value((i[0] + c[0], i[1] + c[1], i[2] + c[2])) for c in CORNERS}
    if (min(at.values()) < 0) == (max(at.values()) < 0):
        return None
    found = []
    for a, b in EDGES:
        if (at[a] < 0) != (at[b] < 0):
            found.append(vectors.mix(a, b, at[a] / (at[a] - at[b])))
    return tuple(i[k] + sum(f[k] for f in found) / len(found) for k in range(3))


def _onto(field, p, cell):
    """`p` moved onto the surface by one Newton step, of half a cell at most."""
    step = cell * 0.01
    value = field(p)
    gradient = []
    for k in range(3):
        ahead = list(p)
        ahead[k] += step
        gradient.append((field(ahead) - value) / step)
    distance = value / vectors.length(gradient)
    distance = min(max(distance, -cell / 2), cell / 2)
    return vectors.subtract(p, vectors.scale(vectors.normalize(gradient), distance))


def _quads(active, index, value):
    """A quad about each lattice edge along which the field changes sign."""
    faces = []
    for i in active:
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            ahead = tuple(c + (k == axis) for k, c in enumerate(i))
            if (value(i) < 0) == (value(ahead) < 0):
                continue
            around = [(0, 0), (-1, 0), (-1, -1), (0, -1)]
            cells = []
            for du, dv in around:
                cell = list(i)
                cell[u] += du
                cell[v] += dv
                cells.append(tuple(cell))
            if all(c in index for c in cells):
                quad = [index[c] for c in cells]
                faces.append(quad if value(i) < 0 else quad[::-1])
    return faces
