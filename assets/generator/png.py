"""PNG files (ISO/IEC 15948): 8-bit grey, RGB and RGBA, and 16-bit grey."""

import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"
COLOR_TYPES = {1: 0, 3: 2, 4: 6}  # by the number of channels
SUB, UP = 1, 2


class Image:
    """Rows of bytes from the top; samples of 16 bits are big-endian, as PNG wants them."""

    def __init__(self, width, rows, channels, bits=8):
        self.width = width
        self.rows = rows
        self.channels = channels
        self.bits = bits

    def encoded(self):
        """The file's bytes: of the filters Sub and Up, the one that compresses better."""
        packed = min((zlib.compress(self._filtered(f), 9) for f in (SUB, UP)), key=len)
        chunks = [(b"IHDR", self._header()), (b"IDAT", packed), (b"IEND", b"")]
        return SIGNATURE + b"".join(_chunk(kind, data) for kind, data in chunks)

    def is_in(self, data):
        """Whether `data` is a file of ours with this very picture, however it was compressed."""
        chunks = dict(_chunks(data))
        if chunks.get(b"IHDR") != self._header():
            return False
        try:
            stream = zlib.decompress(chunks.get(b"IDAT", b""))
        except zlib.error:
            return False
        return stream in (self._filtered(SUB), self._filtered(UP))

    def _header(self):
        size = self.width, len(self.rows)
        return struct.pack(">IIBBBBB", *size, self.bits, COLOR_TYPES[self.channels], 0, 0, 0)

    def _filtered(self, kind):
        step = self.channels * self.bits // 8
        above = bytes(len(self.rows[0]))
        stream = bytearray()
        for row in self.rows:
            before = bytes(step) + row[:-step] if kind == SUB else above
            stream.append(kind)
            stream += bytes((a - b) & 255 for a, b in zip(row, before))
            above = row
        return bytes(stream)


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _chunks(data):
    """Kind and body of each chunk; none where `data` is no PNG."""
    at = len(SIGNATURE) if data.startswith(SIGNATURE) else len(data)
    while at + 12 <= len(data):
        (size,) = struct.unpack_from(">I", data, at)
        yield data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        at += 12 + size


def grey(field):
    """8 bits from a field of numbers in [0, 1]."""
    return Image(len(field[0]), [bytes(map(_byte, row)) for row in field], 1)


def grey16(field):
    """16 bits from a field of numbers in [0, 1]."""
    rows = []
    for row in field:
        levels = [round(65535 * min(max(v, 0.0), 1.0)) for v in row]
        rows.append(struct.pack(f">{len(levels)}H", *levels))
    return Image(len(field[0]), rows, 1, 16)


def color(field):
    """8 bits from a field of sRGB-encoded (r, g, b) or (r, g, b, a) in [0, 1]."""
    rows = [bytes(_byte(v) for pixel in row for v in pixel) for row in field]
    return Image(len(field[0]), rows, len(field[0][0]))


def _byte(value):
    return 0 if value <= 0.0 else 255 if value >= 1.0 else int(255 * value + 0.5)
