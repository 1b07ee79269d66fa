"""Colours as sRGB-encoded triples in [0, 1]."""


def rgb(text):
    """ "#rrggbb" as a triple."""
    return tuple(int(text[k : k + 2], 16) / 255 for k in (1, 3, 5))


def blended(a, b, t):
    """`a` at t = 0, `b` at t = 1."""
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def shaded(a, factor):
    """`a` with each channel multiplied by `factor`."""
    return tuple(p * factor for p in a)
