"""A ladder-back chair, and a pedestal table."""

import math

from generator import surfaces, vectors
from generator.cushion import CUSHION, SEAT, piping
from generator.mesh import Mesh
from generator.surfaces import lathe, profile, spline, tube
from generator.vectors import Frame

TABLE_TOP = 0.745
TABLE_RADIUS = 0.40


def chair():
    """The chair stands on y = 0 and faces +X."""
    mesh = Mesh("chair")
    front, back, half = 0.19, -0.19, 0.20
    leg = [(0, 0)] + spline(profile("12,0 14,30 17,120 19,280 19,450"), 4)
    leg += profile("17,454 0,455")
    rake = profile("-30,0 0,220 0,450 -30,750 -85,1020")
    finial = spline(profile("0,0 8,0 14.5,6 16,14 12,24 6,29 0,30"), 3)
    for z in (-half, half):
        mesh.add("chairwood", lathe(leg, 24, True), Frame((front, 0, z)))
        post = spline([(back + x, y, z) for x, y in rake], 6)
        radii = [0.013 + 0.006 * math.sin(math.pi * min(i / 18, 0.6)) for i in range(len(post))]
        mesh.add("chairwood", tube(post, radii, 16, textured=True))
        mesh.add("chairwood", lathe(finial, 16, True), Frame(vectors.add(post[-1], (0, -0.003, 0))))
    for y, x in ((0.66, back - 0.017), (0.81, back - 0.037), (0.95, back - 0.066)):
        mesh.add("chairwood", _slat(x, y, half))
    for y in (0.14, 0.25):
        for z in (-half, half):
            mesh.add("chairwood", _rod((back - 0.008, y, z), (front, y, z)))
    for x, y in ((front, 0.19), (front, 0.31), (back - 0.003, 0.22)):
        mesh.add("chairwood", _rod((x, y, -half), (x, y, half)))
    mesh.add("rush", _seat(0.42, 0.43, 0.022, 0.10), Frame((0, SEAT - 0.012, 0)))
    mesh.add("piping", piping(), Frame(CUSHION))
    return mesh


def _rod(start, end):
    path = [vectors.mix(start, end, k / 6) for k in range(7)]
    radii = [0.008 + 0.003 * math.sin(math.pi * k / 6) for k in range(7)]
    return tube(path, radii, 14, (0.1, 1, 0.2), textured=True)


def _slat(x, y, half):
    """A bent board between the posts, hollow towards the sitter."""
    rows = []
    quarter = [(-0.5, -0.36), (-0.36, -0.5)]
    outline = quarter + [(-v, u) for u, v in quarter]
    outline += [(-u, -v) for u, v in outline]
    for k in range(17):
        t = k / 8 - 1
        bend = x - 0.035 * (1 - t * t)
        tall = 0.055 + 0.02 * (1 - t * t)
        rows.append([(bend + 0.011 * u, y + tall * v, t * half) for u, v in outline])
    return surfaces.closed(rows, smooth=False)


def _seat(depth, width, half_thickness, squareness, steps=16):
    """A pad about the origin: a rounded rectangle in plan, thickest in the middle."""
    rows = []
    for i in range(steps + 1):
        latitude = math.pi * (i / steps - 0.5)
        rise = math.sin(latitude)
        rise = math.copysign(abs(rise) ** 1.15, rise) * half_thickness
        spread = max(math.cos(latitude), 0.0) ** 0.5
        row = []
        for k in range(2 * steps):
            angle = -math.pi * k / steps
            c, s = math.cos(angle), math.sin(angle)
            norm = (abs(c) ** (1 / squareness) + abs(s) ** (1 / squareness)) ** squareness
            row.append((depth / 2 * spread * c / norm, rise, width / 2 * spread * s / norm))
        rows.append(row)
    return surfaces.grid(rows, wrap_columns=True)


def table():
    """A round table on a turned column with three feet, standing on y = 0."""
    mesh = Mesh("table")
    edge = profile("-20,-26 -6,-18 -2,-12 0,-8 -2,-3 -5,0")
    rim = [(TABLE_RADIUS + x, TABLE_TOP + y) for x, y in edge]
    mesh.add("oak", lathe([(0, rim[0][1])] + rim + [(0, rim[-1][1])], 64, True))
    column = profile(
        "0,130 30,132 45,150 48,200 44,235 30,250 34,265 28,280 40,360 46,420 36,530 26,600 "
        "34,615 28,630 34,670 75,705 80,719.5"
    )
    mesh.add("oak", lathe(spline(column, 3), 32, True))
    bend = profile("20,190 90,185 180,110 250,45 300,22 335,21")
    path = spline([(x, y, 0) for x, y in bend], 4)
    radii = [0.026 - 0.006 * i / (len(path) - 1) for i in range(len(path))]
    foot = tube(path, radii, 20, textured=True)
    for k in range(3):
        mesh.add("oak", foot, vectors.about_y((0, 0, 0), math.radians(120 * k + 75)))
    return mesh
