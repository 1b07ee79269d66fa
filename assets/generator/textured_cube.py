"""A cube with rounded edges, each of whose faces bears the whole texture."""

import math

from generator.mesh import Mesh, Surface

HALF, RADIUS, STEPS = 0.5, 0.012, 4  # half its side, radius of its edges, and cuts of half an edge
FACES = (  # the directions of u and v; outside is u x v
    ((1, 0, 0), (0, 1, 0)), ((-1, 0, 0), (0, 1, 0)), ((0, 0, -1), (0, 1, 0)),
    ((0, 0, 1), (0, 1, 0)), ((1, 0, 0), (0, 0, -1)), ((1, 0, 0), (0, 0, 1)),
)


def textured_cube():
    """A unit cube about the origin."""
    bends = [math.tan(math.pi / 4 * k / STEPS) for k in range(STEPS, 0, -1)]
    low = [-(HALF - RADIUS) - RADIUS * bend for bend in bends]
    lines = low + [RADIUS - HALF, HALF - RADIUS] + [-x for x in reversed(low)]
    whole = Surface([], [], [], uvs=[])
    for across, up in FACES:
        face = _face(lines, across, up)
        first = len(whole.points)
        whole.faces += [[first + corner for corner in quad] for quad in face.faces]
        whole.points += face.points
        whole.normals += face.normals
        whole.uvs += face.uvs
    mesh = Mesh("textured_cube")
    mesh.add("cube", whole)
    return mesh


def _face(lines, across, up):
    """The part of the cube that is nearer to this face than to any other."""
    outward = (
        across[1] * up[2] - across[2] * up[1],
        across[2] * up[0] - across[0] * up[2],
        across[0] * up[1] - across[1] * up[0],
    )
    inner, count = HALF - RADIUS, len(lines)
    points, normals, uvs = [], [], []
    for t in lines:
        for s in lines:
            cube = [s * a + t * b + HALF * c for a, b, c in zip(across, up, outward)]
            core = [min(max(x, -inner), inner) for x in cube]
            off = [x - y for x, y in zip(cube, core)]
            length = math.sqrt(sum(x * x for x in off))
            normals.append(tuple(x / length for x in off))
            points.append(tuple(y + RADIUS * n for y, n in zip(core, normals[-1])))
            uvs.append((s + 0.5, t + 0.5))
    faces = []
    for r in range(count - 1):
        for c in range(count - 1):
            here = r * count + c
            faces.append([here, here + 1, here + count + 1, here + count])
    return Surface(points, faces, normals, uvs=uvs)
