"""Tileable noise: random numbers on a lattice, interpolated by cubic B-splines, in octaves."""

import math


def octave(width, height, columns, rows, generator):
    """Noise with `columns` x `rows` lattice points; its variance is 1/3, most of it in [-1, 1]."""
    lattice = [[generator.uniform(-1, 1) for _ in range(columns)] for _ in range(rows)]
    across, along = _weights(width, columns), _weights(height, rows)
    wide = [
        [a * row[i] + b * row[j] + c * row[k] + d * row[m] for i, a, j, b, k, c, m, d in across]
        for row in lattice
    ]
    gain = 1 / _spline_deviation() ** 2  # the spline's means have a smaller variance
    result = []
    for i, a, j, b, k, c, m, d in along:
        a, b, c, d = a * gain, b * gain, c * gain, d * gain
        four = zip(wide[i], wide[j], wide[k], wide[m])
        result.append([a * p + b * q + c * r + d * s for p, q, r, s in four])
    return result


def octaves(width, height, columns, rows, count, generator, gain=0.5):
    """`count` octaves, each twice as fine as the one before and `gain` times as strong."""
    total = octave(width, height, columns, rows, generator)
    strength = 1.0
    for k in range(1, count):
        strength *= gain
        scale = 2**k
        finer = octave(
            width, height, min(columns * scale, width), min(rows * scale, height), generator
        )
        total = [[a + strength * b for a, b in zip(p, q)] for p, q in zip(total, finer)]
    return total


def _weights(size, count):
    """For each pixel, four lattice points and the weights of the uniform cubic B-spline."""
    found = []
    for pixel in range(size):
        at = (pixel + 0.5) / size * count
        i = math.floor(at)
        t = at - i
        a, d = (1 - t) ** 3 / 6, t**3 / 6
        b = (3 * t**3 - 6 * t * t + 4) / 6
        points = [(i + k - 1) % count for k in range(4)]
        found.append((points[0], a, points[1], b, points[2], 1 - a - b - d, points[3], d))
    return found


def _spline_deviation():
    """Of the means, in one dimension, of independent numbers of deviation 1."""
    return math.sqrt(151 / 315)  # the integral of the squared cubic B-spline
