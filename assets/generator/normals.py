"""Normal maps in OpenGL's convention (+Y up) from heights."""

import math

from generator.png import Image


def normal_map(heights, relief):
    """RGB for `2 c - 1` of a tileable height field.

    `relief` is the height of 1, in widths of the map; the map's pixels are square.
    """
    width, count = len(heights[0]), len(heights)
    slope = relief * width / 2  # over the central differences, two pixels apart
    rows = []
    for r, row in enumerate(heights):
        above, below = heights[r - 1], heights[(r + 1) % count]
        line = bytearray()
        for left, right, up, down in zip(row[-1:] + row[:-1], row[1:] + row[:1], above, below):
            x, y = slope * (left - right), slope * (down - up)
            scale = 127.5 / math.sqrt(x * x + y * y + 1)
            line += bytes((int(x * scale + 128), int(y * scale + 128), int(scale + 128)))
        rows.append(bytes(line))
    return Image(width, rows, 3)
