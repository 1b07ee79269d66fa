"""A chased metal panel, as normals: a rosette in a braid, scrolls in the corners, a beaded frame.

All lengths are in widths of the panel. Frame and scrolls have the symmetry of a square, so only an
eighth of them is drawn.
"""

import functools
import math
import random

from generator import fields, noise
from generator.brush import Canvas
from generator.normals import normal_map

SIZE = 1024
GOLDEN_ANGLE = math.pi * (3 - math.sqrt(5))
PETALS = 16
SEEDS_WITHIN, PETALS_WITHIN = 0.066, 0.188  # radii of the rosette's parts
BRAID, BRAID_WAVES = 0.232, 24  # mean radius, crossings
MEDALLION = BRAID + 0.045
FRAME = (0.030, 0.105)  # from the edge, where the frame begins and ends
BEADS = 20  # from corner to corner


def normals():
    generator = random.Random(81)
    relief = _symmetric(_border)
    hammer = _hammer(generator)
    brushed = noise.octave(SIZE, SIZE, 8, SIZE, generator)
    turned = noise.octave(SIZE, 8, SIZE, 4, generator)[0]

    def finished(place, height, seed, dent, line):
        """Dents in the sunk ground, straight brush lines on the frame, turned ones within."""
        x, y = place
        radius = math.hypot(x, y)
        if radius < MEDALLION:
            height = max(_medallion(radius, math.atan2(y, x)), 0.8 * _round(-seed, 0.012))
            line = turned[int(radius * 1.2 * SIZE) % SIZE]
        ground = math.exp(-((height / 0.004) ** 2))
        return height + 0.0019 * ground * dent + 0.00009 * line

    places = fields.field(SIZE, SIZE, lambda u, v: (u - 0.5, v - 0.5))
    heights = fields.combined(finished, places, relief, _seeds(), hammer, brushed)
    return normal_map(heights, 1.0)


def _symmetric(height):
    """`height(column, row)` between the panel's left edge and its diagonal, and all its images."""
    half = SIZE // 2
    quarter = [[height(c, r) if c <= r else 0.0 for c in range(half)] for r in range(half)]
    for r in range(half):
        for c in range(r + 1, half):
            quarter[r][c] = quarter[c][r]
    top = [row + row[::-1] for row in quarter]
    return top + top[::-1]


def _border(column, row):
    """The frame, and the scrolls between it and the medallion."""
    edge, along = (column + 0.5) / SIZE, 0.5 - (row + 0.5) / SIZE
    if edge < FRAME[1] + 0.012:
        return _frame(edge, along)
    return _round(-_scrolls()[row][column], 0.020)


def _round(inside, radius):
    """The height of a round ridge `inside` its outline, which is `radius` half-wide at most."""
    if inside <= 0:
        return 0.0
    inside = min(inside, radius)
    return math.sqrt(inside * (2 * radius - inside))


def _ring(distance, half):
    """A round bar of half-width `half`."""
    return math.sqrt(max(half * half - distance * distance, 0.0))


def _slope(value, start, end):
    """A straight chamfer: 0 up to `start`, 1 from `end` on."""
    return min(max((value - start) / (end - start), 0.0), 1.0)


def _frame(edge, along):
    """Two raised fillets with a bead course between them, and a stud in each corner."""
    outer = 0.016 * (1 - _slope(edge, FRAME[0], FRAME[0] + 0.010))
    inner = 0.016 * _slope(edge, FRAME[1] - 0.022, FRAME[1] - 0.012)
    inner *= 1 - _slope(edge, FRAME[1], FRAME[1] + 0.012)
    middle = (FRAME[0] + FRAME[1]) / 2 - 0.003
    pitch = (1 - 2 * middle) / BEADS
    at = (0.5 - middle - abs(along)) / pitch  # counted from the corner
    nearest = round(at)
    if nearest == 0:
        bead = 1.15 * _ring(math.hypot(at * pitch, edge - middle), 0.0225)
        return max(outer, inner, bead)
    bead = _ring(math.hypot((at - nearest) * pitch, edge - middle), 0.0165)
    spacer = 0.55 * _ring(math.hypot((at % 1 - 0.5) * pitch * 2.4, edge - middle), 0.011)
    return max(outer, inner, bead, spacer if nearest > 1 or at > 1 else 0.0)


def _medallion(radius, angle):
    """Two whorls of petals, and about them a braid of two strands between two wires."""
    height = 0.0
    for whorl, (first, last, rise) in enumerate(
        ((SEEDS_WITHIN * 0.9, 0.140, 0.020), (SEEDS_WITHIN, PETALS_WITHIN, 0.012))
    ):
        height = max(height, _petal(radius, angle, first, last, whorl / 2) * rise)
    wires = max(_ring(radius - BRAID + 0.036, 0.0055), _ring(radius - BRAID - 0.036, 0.0055))
    phase = angle * BRAID_WAVES / 2
    strands = []
    for sign in (-1, 1):
        center = BRAID + sign * 0.015 * math.sin(phase)
        lift = 0.0035 * sign * math.cos(phase)  # which of the two is on top
        tilt = math.hypot(1.0, 0.015 * BRAID_WAVES / 2 / BRAID * math.cos(phase))
        bar = _ring((radius - center) / tilt, 0.0105)
        strands.append(bar + lift + 0.0035 if bar > 0 else 0.0)
    eye = _ring(math.hypot(radius - BRAID, _from_eye(phase)), 0.0050)
    return max(height, wires, eye, *strands)


def _from_eye(phase):
    """The arc to the middle of the nearest eye of the braid."""
    return (phase % math.pi - math.pi / 2) * 2 * BRAID / BRAID_WAVES


def _petal(radius, angle, first, last, shift):
    """0 to 1: a boat-shaped petal with a crease along its middle."""
    t = (radius - first) / (last - first)
    if not 0.0 < t < 1.0:
        return 0.0
    step = 2 * math.pi / PETALS
    across = ((angle / step + shift) % 1.0 - 0.5) * step * radius
    half = step * first * 0.5 + (step * radius * 0.48 - step * first * 0.5) * min(1.6 * t, 1.0)
    half *= math.sqrt(max(1 - max(t - 0.55, 0.0) ** 2 / 0.2025, 0.0))
    if abs(across) >= half:
        return 0.0
    body = math.sqrt(1 - (across / half) ** 2) * (0.55 + 0.45 * math.sin(math.pi * t**0.7))
    return body * (1 - 0.30 * math.exp(-((across / 0.0022) ** 2)))


def _seeds():
    """Distances, in widths, to the seeds of a sunflower in the middle."""
    canvas = Canvas(SIZE, SIZE, 1.0)
    count = 60
    for k in range(count):
        radius = SEEDS_WITHIN * 0.94 * math.sqrt((k + 0.5) / count)
        turn = k * GOLDEN_ANGLE
        canvas.dot(0.5 + radius * math.cos(turn), 0.5 + radius * math.sin(turn), 0.0078)
    return [[d / SIZE for d in row] for row in canvas.distances]


@functools.cache
def _scrolls():
    """Distances, in widths, to the scrolls of the upper left corner; points have y down."""
    canvas = Canvas(SIZE, SIZE, 2.0)
    for swap in (False, True):

        def draw(points, radii):
            placed = [(b, a) if swap else (a, b) for a, b in points]
            canvas.stroke([(x, 1 - y) for x, y in placed], radii)

        stem = [(0.142, 0.142), (0.185, 0.152), (0.235, 0.146)] + _spiral(0.297, 0.200, 0.066, 15)
        draw(stem, [0.004, 0.012, 0.012] + [0.0115 - 0.0003 * k for k in range(15)])
        draw([(0.297, 0.200)] * 2, [0.0135] * 2)
        for k, size in enumerate((0.036, 0.044, 0.046)):  # leaves on the inside of the stem
            foot = (0.176 + 0.028 * k, 0.152)
            draw(_leaf(foot, 0.95 - 0.06 * k, size), [0.005, 0.0105, 0.001])
        for angle, size in ((-0.55, 0.042), (0.25, 0.046), (1.0, 0.040)):  # and off the volute
            foot = (0.297 + 0.062 * math.cos(angle), 0.200 + 0.062 * math.sin(angle))
            draw(_leaf(foot, angle + 0.75, size), [0.005, 0.0100, 0.001])
        tendril = [(0.330, 0.138), (0.372, 0.128), (0.412, 0.142), (0.430, 0.166), (0.414, 0.180)]
        draw(tendril, [0.003, 0.0085, 0.0085, 0.0075, 0.0085])
        for k in range(3):  # half a palmette in the middle of the side
            angle = -math.pi / 2 - 0.62 * k
            foot = (0.5 + 0.020 * math.cos(angle), 0.200 + 0.020 * math.sin(angle))
            draw(_leaf(foot, angle, 0.062 - 0.008 * k, 0.0), [0.004, 0.0125 - 0.001 * k, 0.001])
        draw([(0.5, 0.200)] * 2, [0.0145] * 2)
    canvas.stroke([(0.150, 0.850), (0.225, 0.775), (0.285, 0.715)], [0.004, 0.022, 0.002])
    return [[d / SIZE for d in row] for row in canvas.distances]


def _leaf(foot, angle, size, bend=0.22):
    """Three knots from `foot` in the direction `angle`, bent to one side."""
    c, s = math.cos(angle), math.sin(angle)
    middle = (foot[0] + size * (0.5 * c - bend * s), foot[1] + size * (0.5 * s + bend * c))
    return [foot, middle, (foot[0] + size * c, foot[1] + size * s)]


def _spiral(x, y, radius, knots):
    """A turn and a half inwards about (x, y), from its top."""
    points = []
    for k in range(knots):
        t = k / (knots - 1)
        angle = 3 * math.pi * t - math.pi / 2
        r = radius * (1 - 0.74 * t)
        points.append((x + r * math.cos(angle), y + r * math.sin(angle)))
    return points


def _hammer(generator):
    """Shallow dents, as deep as 1: the square of the distance to the nearest of many points."""
    cells = 88
    spots = [
        [(i + generator.random(), j + generator.random()) for i in range(cells)]
        for j in range(cells)
    ]

    def dent(u, v):
        x, y = u * cells, v * cells
        i, j = int(x), int(y)
        best = 4.0
        for dj in (-1, 0, 1):
            row, y0 = spots[(j + dj) % cells], (j + dj) // cells * cells
            for di in (-1, 0, 1):
                sx, sy = row[(i + di) % cells]
                ex = sx + (i + di) // cells * cells - x
                ey = sy + y0 - y
                d = ex * ex + ey * ey
                if d < best:
                    best = d
        return min(best, 1.0) - 0.4

    return fields.field(SIZE, SIZE, dent)
