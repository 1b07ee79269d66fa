"""Primitive surfaces: grids, boxes with bevels, lathes, tubes and mouldings."""

import math

from generator import vectors
from generator.mesh import Surface

PIECE = 0.3  # metres that long things are cut into: small boxes make fast bounding volumes


def grid(rows, wrap_rows=False, wrap_columns=False, smooth=True, uvs=None):
    """Quads over rows of points; outside is (along a row) x (to the next row).

    `uvs`, in rows as well, are the points' texture coordinates.
    """
    count, width = len(rows), len(rows[0])
    faces = []
    for r in range(count if wrap_rows else count - 1):
        for c in range(width if wrap_columns else width - 1):
            here, there = r * width, (r + 1) % count * width
            d = (c + 1) % width
            faces.append([here + c, here + d, there + d, there + c])
    points = [p for row in rows for p in row]
    return Surface(points, faces, smooth=smooth, uvs=uvs and [t for row in uvs for t in row])


def measured(rows):
    """Texture coordinates in metres: u along the rows, v from row to row, by their mean lengths."""
    columns = list(zip(*rows))
    us, vs = [0.0], [0.0]
    for left, right in zip(columns, columns[1:]):
        us.append(us[-1] + sum(map(math.dist, left, right)) / len(left))
    for low, high in zip(rows, rows[1:]):
        vs.append(vs[-1] + sum(map(math.dist, low, high)) / len(low))
    return [[(u, v) for u in us] for v in vs]


def short_cut(surface):
    """The quads of `surface` from an end of their shorter diagonal, along which readers cut them.

    Bent quads that are cut along the longer one may cross themselves.
    """
    faces, points = [], surface.points
    for a, b, c, d in surface.faces:
        shorter = math.dist(points[a], points[c]) < math.dist(points[b], points[d])
        faces.append([a, b, c, d] if shorter else [b, c, d, a])
    return Surface(points, faces, surface.normals, surface.smooth, surface.uvs)


def box(size, bevel):
    """A box about the origin whose bevels are shaded round.

    Each corner becomes three points, one to a face, which bear that face's normal.
    """
    half = [s / 2 for s in size]
    bevel = min(bevel, *half)
    signs = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    points, normals, index = [], [], {}
    for sign in signs:
        for axis in range(3):
            inset = [h - (0 if k == axis else bevel) for k, h in enumerate(half)]
            index[sign, axis] = len(points)
            points.append(tuple(s * i for s, i in zip(sign, inset)))
            normals.append(tuple(sign[k] if k == axis else 0 for k in range(3)))
    faces = []

    def emit(corners, outward):
        a, b, c = (points[corners[k]] for k in range(3))
        normal = vectors.cross(vectors.subtract(b, a), vectors.subtract(c, a))
        faces.append(corners if vectors.dot(normal, outward) > 0 else corners[::-1])

    def signed(pattern, axes):
        sign = [0, 0, 0]
        for axis, value in zip(axes, pattern):
            sign[axis] = value
        return tuple(sign)

    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for s in (-1, 1):
            around = [(s, -1, -1), (s, 1, -1), (s, 1, 1), (s, -1, 1)]
            outward = signed((s,), (axis,))
            emit([index[signed(p, (axis, u, v)), axis] for p in around], outward)
            for t in (-1, 1):
                low, high = (signed((e, s, t), (axis, u, v)) for e in (-1, 1))
                corners = [index[low, u], index[high, u], index[high, v], index[low, v]]
                emit(corners, signed((s, t), (u, v)))
    for sign in signs:
        emit([index[sign, axis] for axis in range(3)], sign)
    return Surface(points, faces, normals)


def beam(start, end, width, depth, bevel, side=(1, 0, 0)):
    """A box from `start` to `end`, `width` metres along `side` and `depth` across both."""
    axis = vectors.subtract(end, start)
    frame = vectors.Frame(vectors.mix(start, end, 0.5), side, axis)
    return box((width, vectors.length(axis), depth), bevel).placed(frame)


def spline(controls, steps):
    """Points along a Catmull-Rom curve through `controls`, tuples of any dimension."""
    points = []
    for i in range(len(controls) - 1):
        a = controls[max(i - 1, 0)]
        b, c = controls[i], controls[i + 1]
        d = controls[min(i + 2, len(controls) - 1)]
        for step in range(steps):
            t = step / steps
            points.append(tuple(_catmull_rom(*numbers, t) for numbers in zip(a, b, c, d)))
    return points + [tuple(controls[-1])]


def _catmull_rom(p, q, r, s, t):
    """From q at t = 0 to r at t = 1."""
    square, cube = 2 * p - 5 * q + 4 * r - s, 3 * q - p - 3 * r + s
    return q + 0.5 * t * (r - p + t * (square + t * cube))


def profile(millimetres):
    """Pairs such as "30,0 28,5.5", in metres."""
    pairs = (word.split(",") for word in millimetres.split())
    return [(float(a) / 1000, float(b) / 1000) for a, b in pairs]


def closed(rows, smooth=True):
    """A grid whose rows close, with texture coordinates in metres and a seam for them."""
    rows = [row + row[:1] for row in rows]
    return grid(rows, smooth=smooth, uvs=measured(rows))


def lathe(outline, segments, textured=False):
    """An outline of (radius, y), from the bottom up the outside, turned about +Y."""
    rows = []
    for radius, y in outline:
        angles = (-2 * math.pi * k / segments for k in range(segments))
        rows.append([(radius * math.cos(a), y, radius * math.sin(a)) for a in angles])
    return closed(rows) if textured else grid(rows, wrap_columns=True)


def tube(path, radii, segments, side=(0.0, 0.0, 1.0), textured=False):
    """A round tube with closed ends along `path`; `side` is never parallel to it."""
    rows = []
    for i, p in enumerate(path):
        ahead = vectors.subtract(path[min(i + 1, len(path) - 1)], path[max(i - 1, 0)])
        frame = vectors.Frame(p, side, ahead)
        angles = [-2 * math.pi * k / segments for k in range(segments)]
        rows.append(
            [frame.point((radii[i] * math.cos(a), 0, radii[i] * math.sin(a))) for a in angles]
        )
    rows = [[path[0]] * segments] + rows + [[path[-1]] * segments]
    return closed(rows) if textured else grid(rows, wrap_columns=True)


def moulding(width, height, section):
    """A mitred frame about the origin in the plane z = 0, as seen from +Z.

    `section` runs from the outer edge inwards: (inset from the rectangle, height above z = 0).
    """
    cuts = [max(1, round(side / PIECE)) for side in (width, height, width, height)]
    rows = []
    for inset, rise in section:
        x, y = width / 2 - inset, height / 2 - inset
        corners = [(-x, -y, rise), (x, -y, rise), (x, y, rise), (-x, y, rise)]
        row = []
        for k, count in enumerate(cuts):
            row += [vectors.mix(corners[k], corners[(k + 1) % 4], i / count) for i in range(count)]
        rows.append(row)
    return grid(rows, wrap_columns=True, smooth=False)


def extrusion(section, span):
    """A moulding along X from 0 to `span`; `section` lists (y, z) from the bottom up its front."""
    count = max(1, round(span / PIECE))
    rows = [[(span * k / count, y, z) for k in range(count + 1)] for y, z in section]
    return grid(rows, smooth=False)


def rectangle(width, height):
    """From (0, 0, 0) to (width, height, 0), in pieces, facing +Z; texture coordinates in metres."""
    across, up = (max(1, round(side / PIECE)) for side in (width, height))
    rows = [
        [(width * c / across, height * r / up, 0) for c in range(across + 1)] for r in range(up + 1)
    ]
    return grid(rows, smooth=False, uvs=[[p[:2] for p in row] for row in rows])
