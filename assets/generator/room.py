"""The room's fixed parts: floorboards, wainscot, window and a picture frame."""

import math
import random

from generator import surfaces
from generator.mesh import Mesh
from generator.surfaces import box, extrusion, moulding, profile, rectangle
from generator.vectors import Frame, about_y

LEFT, RIGHT, BACK, NEAR = -1.65, 2.65, -1.70, 4.9  # the walls, metres
BOARD, GAP = 0.150, 0.0025  # width of a floorboard, and the gap between two
DADO, CEILING = 0.93, 3.2  # heights of the wainscot and of the room
WINDOW_Z, WINDOW_Y = (-1.10, 1.00), (1.00, 2.55)
REVEAL = 0.16  # depth of the window's opening
CHAIR_RAIL = profile("-55,0 -55,16 -48,20 -30,22 -24,26 -18,34 -10,40 -4,42 4,42 7,41 9,38 9,0")
SKIRTING = profile("0,0 0,24 105,24 110,23 114,18 124,12 130,11 133,8 133,0")
PANEL = profile("0,0 0,14 3,17 8,18 13,16 18,10 24,5 30,4 32,0")


def floorboards():
    """Boards along Z whose tops are the plane y = 0, in five browns."""
    generator = random.Random(7)
    mesh = Mesh("floorboards")
    x = LEFT - 0.1
    while x < RIGHT:
        z = BACK - generator.uniform(0.0, 1.6)
        while z < NEAR:
            span = generator.uniform(1.5, 2.6)
            frame = Frame((x + BOARD / 2, 0, z), (-1, 0, 0))
            mesh.add(f"board{generator.randrange(5)}", _board(span - GAP), frame)
            z += span
        x += BOARD
    return mesh


def _board(span):
    """The visible sides of a board along -Z whose top is y = 0, with bevelled edges."""
    edge, bevel, thick = (BOARD - GAP) / 2, 0.0018, 0.02
    left = [(-edge, -thick), (-edge, -bevel), (bevel - edge, 0)]
    across = left + [(-x, y) for x, y in left[::-1]]
    cuts = round(span / surfaces.PIECE)
    inner = [bevel + (span - 2 * bevel) * k / cuts for k in range(cuts + 1)]
    along = [(0, -thick), (0, -bevel)] + [(z, 0) for z in inner] + [(span, -bevel), (span, -thick)]
    rows = [[(x, min(y, top), -z) for x, y in across] for z, top in along]
    return surfaces.grid(rows, smooth=False)


def walls():
    """Four walls, the left one about the window, the ceiling, and what lies under the boards."""
    mesh = Mesh("walls")
    wide, deep = RIGHT - LEFT, NEAR - BACK
    _wall(mesh, Frame((LEFT, 0, BACK)), wide)
    _wall(mesh, Frame((RIGHT, 0, NEAR), (-1, 0, 0)), wide)
    _wall(mesh, about_y((RIGHT, 0, BACK), -math.pi / 2), deep)
    hole = (NEAR - WINDOW_Z[1], NEAR - WINDOW_Z[0])
    _wall(mesh, about_y((LEFT, 0, NEAR), math.pi / 2), deep, hole, WINDOW_Y)
    downward = Frame((LEFT, CEILING, BACK), (1, 0, 0), (0, 0, 1))
    mesh.add("ceiling", rectangle(wide, deep), downward)
    upward = Frame((LEFT - 0.2, -0.02, NEAR), (1, 0, 0), (0, 0, -1))
    mesh.add("gaps", rectangle(wide + 0.4, deep), upward)
    return mesh


def _wall(mesh, frame, span, hole_x=None, hole_y=None):
    """Panelling colour up to the dado, plaster above, about a hole if there is one."""

    def piece(material, x, y):
        place = Frame(frame.point((x[0], y[0], 0)), frame.x, frame.y)
        mesh.add(material, rectangle(x[1] - x[0], y[1] - y[0]), place)

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
