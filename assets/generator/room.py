"""The room's fixed parts: walls and floor, wainscot, window and a picture frame."""

import math

from generator import surfaces
from generator.mesh import Mesh
from generator.surfaces import box, extrusion, moulding, profile, rectangle
from generator.vectors import Frame, about_y

LEFT, RIGHT, BACK, NEAR = -1.65, 2.65, -1.70, 4.9  # the walls, metres
DADO, CEILING = 0.93, 3.2  # heights of the wainscot and of the room
WINDOW_Z, WINDOW_Y = (-0.75, 0.85), (1.00, 2.60)
REVEAL = 0.16  # depth of the window's opening
CHAIR_RAIL = profile("-55,0 -55,16 -48,20 -30,22 -24,26 -18,34 -10,40 -4,42 4,42 7,41 9,38 9,0")
SKIRTING = profile("0,0 0,24 105,24 110,23 114,18 124,12 130,11 133,8 133,0")
PANEL = profile("0,0 0,14 3,17 8,18 13,16 18,10 24,5 30,4 32,0")


def walls():
    """Four walls, the left one about the window, ceiling and floor; texture coordinates in metres.

    Those of the floor are turned by half a right angle, as a herringbone parquet is laid.
    """
    mesh = Mesh("walls")
    wide, deep = RIGHT - LEFT, NEAR - BACK
    _wall(mesh, Frame((LEFT, 0, BACK)), wide)
    _wall(mesh, Frame((RIGHT, 0, NEAR), (-1, 0, 0)), wide)
    _wall(mesh, about_y((RIGHT, 0, BACK), -math.pi / 2), deep)
    hole = (NEAR - WINDOW_Z[1], NEAR - WINDOW_Z[0])
    _wall(mesh, about_y((LEFT, 0, NEAR), math.pi / 2), deep, hole, WINDOW_Y)
    downward = Frame((LEFT, CEILING, BACK), (1, 0, 0), (0, 0, 1))
    mesh.add("ceiling", rectangle(wide, deep), downward)
    floor = rectangle(wide, deep)
    half = math.sqrt(0.5)
    floor.uvs = [((u - v) * half, (u + v) * half) for u, v in floor.uvs]
    mesh.add("floor", floor, Frame((LEFT, 0, NEAR), (1, 0, 0), (0, 0, -1)))
    return mesh


def _wall(mesh, frame, span, hole_x=None, hole_y=None):
    """Panelling colour up to the dado, wallpaper above, about a hole if there is one."""

    def piece(material, x, y):
        place = Frame(frame.point((x[0], y[0], 0)), frame.x, frame.y)
        surface = rectangle(x[1] - x[0], y[1] - y[0])
        surface.uvs = [(u + x[0], v + y[0]) for u, v in surface.uvs]
        mesh.add(material, surface, place)

    piece("panelling", (0, span), (0, DADO))
    if hole_x is None:
        piece("wall", (0, span), (DADO, CEILING))
        return
    piece("wall", (0, span), (DADO, hole_y[0]))
    piece("wall", (0, span), (hole_y[1], CEILING))
    piece("wall", (0, hole_x[0]), hole_y)
    piece("wall", (hole_x[1], span), hole_y)


def wainscot():
    """Panelling with skirting and chair rail along the back wall and the left one."""
    mesh = Mesh("wainscot")
    _panelling(mesh, Frame((LEFT, 0, BACK)), RIGHT - LEFT, 6)
    _panelling(mesh, about_y((LEFT, 0, NEAR), math.pi / 2), NEAR - BACK, 9)
    return mesh


def _panelling(mesh, frame, span, panels):
    """`frame`: X along the foot of the wall, Z into the room."""

    def place(x, y):
        return Frame(frame.point((x, y, 0)), frame.x, frame.y)

    mesh.add("panelling", extrusion(SKIRTING, span), place(0, 0))
    mesh.add("panelling", extrusion(CHAIR_RAIL, span), place(0, DADO))
    stile, pitch = 0.10, span / panels
    for k in range(panels):
        size = (pitch - stile, DADO - 0.055 - 0.133 - 2 * 0.07)
        center = place((k + 0.5) * pitch, 0.133 + 0.07 + size[1] / 2)
        mesh.add("panelling", moulding(*size, PANEL), center)


def window():
    """Casing, sill, sash and glazing bars of the window in the left wall."""
    mesh = Mesh("window")
    width, height = WINDOW_Z[1] - WINDOW_Z[0], WINDOW_Y[1] - WINDOW_Y[0]
    middle = (LEFT, sum(WINDOW_Y) / 2, sum(WINDOW_Z) / 2)
    inward = about_y(middle, math.pi / 2)  # X towards -Z, Z into the room
    casing = profile("0,0 0,20 4,26 12,28 20,24 26,18 70,16 76,20 82,20 86,16")
    casing.append((0.086, -REVEAL))
    mesh.add("trim", moulding(width + 0.172, height + 0.172, casing), inward)

    def bar(x, y, size):
        mesh.add("trim", box(size, 0.004), Frame(inward.point((x, y, -REVEAL + 0.03)), inward.x))

    for sign in (-1, 1):
        bar(sign * (width / 2 - 0.025), 0, (0.05, height, 0.045))
        bar(0, sign * (height / 2 - 0.025), (width - 0.1, 0.05, 0.045))
    for x in (-width / 6, width / 6):
        bar(x, 0, (0.022, height - 0.1, 0.030))
    for x in (-width / 3, 0, width / 3):
        bar(x, 0.12, (width / 3 - 0.022 - (0.039 if x else 0), 0.022, 0.030))
    sill = Frame(inward.point((0, -height / 2 - 0.012, -0.04)), inward.x)
    mesh.add("trim", box((width + 0.26, 0.030, 0.20), 0.006), sill)
    return mesh


def picture_frame():
    """A mounted landscape in a frame of 0.46 by 0.58 metres about the origin, its back on z = 0."""
    mesh = Mesh("picture_frame")
    section = profile("0,0 0,22 3,26 8,27 14,24 20,18 26,16 30,17 32,16 32,6")
    mesh.add("walnut", moulding(0.46, 0.58, section))
    mesh.add("mount", box((0.40, 0.52, 0.006), 0.001), Frame((0, 0, 0.0055)))
    mesh.add("print_sky", box((0.22, 0.28, 0.002), 0.0005), Frame((0, 0.02, 0.0085)))
    mesh.add("print_hills", _hills(-0.01, 0.7, 0.00965))
    mesh.add("print_land", _hills(-0.05, 2.2, 0.0098))
    return mesh


def _hills(base, swell, rise):
    """The part of the print below a skyline, `rise` metres off the wall."""
    rows = [[], []]
    for k in range(33):
        x = 0.108 * (k / 16 - 1)
        skyline = base + 0.022 * math.sin(17 * x + swell) + 0.007 * math.sin(61 * x + 3 * swell)
        rows[0].append((x, -0.118, rise))
        rows[1].append((x, skyline, rise))
    return surfaces.grid(rows, smooth=False)
