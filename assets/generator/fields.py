"""Fields: a number, or a tuple, for each pixel, in rows from the top of the picture.

Row 0 lies at v = 1, as in a texture; pixel centres are at (column + 1/2) / width.
"""


def field(width, height, value):
    """`value(u, v)` at every pixel's centre."""
    us = [(c + 0.5) / width for c in range(width)]
    return [[value(u, v) for u in us] for v in ((height - r - 0.5) / height for r in range(height))]


def combined(function, *fields):
    """`function` of the fields' values, pixel by pixel."""
    return [[function(*values) for values in zip(*rows)] for rows in zip(*fields)]
