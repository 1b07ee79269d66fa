"""A seat cushion to be displaced: two coarse sheets that share their rim."""

import math

from generator import surfaces
from generator.mesh import Mesh, Surface
from generator.surfaces import tube
from generator.vectors import Frame

SEAT = 0.45  # height of the chair's seat
CUSHION = (0.012, SEAT + 0.034, 0)  # where the cushion's middle is on the chair
HALF, RISE, SINK = 0.195, 0.050, 0.022  # half its width, and how high and low its middle bulges
CELLS = 26


def cushion():
    """Lies where the chair's seat is; both sheets map the texture's square from rim to rim."""
    lines = []
    for k in range(CELLS + 1):
        s = 2 * k / CELLS - 1
        lines.append(0.45 * s + 0.55 * math.sin(math.pi / 2 * s))
    mesh = Mesh("cushion", normals=False)
    sheets = [_sheet(lines, RISE), _sheet(lines, -SINK)]
    count = len(sheets[0].points)
    faces = sheets[0].faces + [[i + count for i in f[::-1]] for f in sheets[1].faces]
    points, uvs = sheets[0].points + sheets[1].points, sheets[0].uvs + sheets[1].uvs
    mesh.add("cushion", Surface(points, faces, uvs=uvs), Frame(CUSHION))
    return mesh


def _sheet(lines, rise):
    """Over the square [-1, 1]^2, as seen from above; u along X, v along -Z."""
    rows, uvs = [], []
    for b in lines:
        rows.append([_point(a, b, rise) for a in lines])
        uvs.append([((a + 1) / 2, (b + 1) / 2) for a in lines])
    return surfaces.grid(rows, uvs=uvs)


def _point(a, b, rise):
    """The square with rounded corners, bulging towards its middle."""
    x, z = a * math.sqrt(1 - 0.16 * b * b), b * math.sqrt(1 - 0.16 * a * a)
    bulge = max((1 - a * a) * (1 - b * b), 0.0) ** 0.42
    return (HALF * x, rise * bulge, -HALF * z)


def piping():
    """The cord that is sewn about the rim, about the origin."""
    steps, path = 24, []
    for side in range(4):
        for k in range(steps):
            s = math.sin(math.pi / 2 * (2 * k / steps - 1))
            a, b = ((s, -1), (1, s), (-s, 1), (-1, -s))[side]
            path.append(_point(a, b, 0))
    return tube(path + path[:1], [0.0055] * (len(path) + 1), 10, (0, 1, 0))
