"""Writes the image and film seeds below corpus/: tiny files of every kind that is read.

All is made from the formats' specifications with the standard library, so that each file holds
what its name says and nothing else.
"""

import json
import pathlib
import struct
import zlib

CORPUS = pathlib.Path(__file__).parent / "corpus"


def write(folder, name, data):
    (CORPUS / folder / name).write_bytes(data)


# --- PNG ------------------------------------------------------------------------------------------

PNG_CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}  # by colour type


def png_chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(color_type, depth, extra=b"", interlaced=False, side=2):
    row_bytes = (side * PNG_CHANNELS[color_type] * depth + 7) // 8
    passes = [(1, 1), (1, 1), (2, 1)] if interlaced else [(side, side)]  # of a side of 2
    data = b""
    for width, height in passes:
        for y in range(height):
            pass_bytes = row_bytes if not interlaced else (
                (width * PNG_CHANNELS[color_type] * depth + 7) // 8)
            data += bytes([y % 5]) + bytes((37 * (i + y)) % 256 for i in range(pass_bytes))
    header = struct.pack(">IIBBBBB", side, side, depth, color_type, 0, 0, int(interlaced))
    return (b"\x89PNG\r\n\x1a\n" + png_chunk(b"IHDR", header) + extra
            + png_chunk(b"IDAT", zlib.compress(data)) + png_chunk(b"IEND", b""))


def write_pngs():
    for color_type, depths in {0: (1, 2, 4, 8, 16), 2: (8, 16), 4: (8, 16), 6: (8, 16)}.items():
        for depth in depths:
            write("texture", f"png-{color_type}-{depth}.png", png(color_type, depth))
    palette = png_chunk(b"PLTE", bytes(range(12))) + png_chunk(b"tRNS", b"\x00\x80\xff")
    write("texture", "png-palette.png", png(3, 2, palette))
    write("texture", "png-key.png", png(2, 8, png_chunk(b"tRNS", b"\0\x01\0\x02\0\x03")))
    write("texture", "png-interlaced.png", png(2, 8, interlaced=True))
    write("texture", "png-rows.png", png(0, 8, side=6))


# --- JPEG: blocks of one grey each ----------------------------------------------------------------


def jpeg_segment(marker, data):
    return b"\xff" + bytes([marker]) + struct.pack(">H", len(data) + 2) + data


def huffman_table(kind_and_id, symbols):
    """A table whose codes have two bits, for up to three symbols."""
    return bytes([kind_and_id, 0, len(symbols)] + [0] * 14 + symbols)


def jpeg(sampling, progressive=False, restart=0):
    """`sampling` gives each component's factors, e.g. [0x22, 0x11, 0x11]."""
    start = 0xC2 if progressive else 0xC0
    parts = b"".join(bytes([i + 1, s, 0]) for i, s in enumerate(sampling))
    blocks = sum((s >> 4) * (s & 15) for s in sampling) if len(sampling) > 1 else 1
    side = 8 * (sampling[0] >> 4)
    data = b"\xff\xd8" + jpeg_segment(0xDB, b"\0" + b"\x08" * 64)
    data += jpeg_segment(start, struct.pack(">BHHB", 8, side, side, len(sampling)) + parts)
    data += jpeg_segment(0xC4, huffman_table(0x00, [0, 1, 2]) + huffman_table(0x10, [0, 1, 0x11]))
    if restart:
        data += jpeg_segment(0xDD, struct.pack(">H", restart))

    def scan(components, first, last, bits):
        selectors = b"".join(bytes([i + 1, 0]) for i in components)
        bits += "1" * (-len(bits) % 8)
        coded = bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))
        header = bytes([len(components)]) + selectors + bytes([first, last, 0])
        return jpeg_segment(0xDA, header) + coded.replace(b"\xff", b"\xff\0")

    everything = range(len(sampling))
    if progressive:
        data += scan(everything, 0, 0, "011" * blocks)  # DC: one bit, which is 1
        for component in everything:  # AC: one coefficient of -1, then the end of the block
            factors = sampling[component]
            count = (factors >> 4) * (factors & 15) if len(sampling) > 1 else 1
            data += scan([component], 1, 63, "01000" * count)
    else:
        data += scan(everything, 0, 63, "01101000" * blocks)
    return data + b"\xff\xd9"


def write_jpegs():
    write("texture", "jpeg-grey.jpg", jpeg([0x11]))
    write("texture", "jpeg-444.jpg", jpeg([0x11, 0x11, 0x11]))
    write("texture", "jpeg-420.jpg", jpeg([0x22, 0x11, 0x11]))
    write("texture", "jpeg-cmyk.jpg", jpeg([0x11, 0x11, 0x11, 0x11]))
    write("texture", "jpeg-progressive.jpg", jpeg([0x11], progressive=True))
    write("texture", "jpeg-progressive-420.jpg", jpeg([0x22, 0x11, 0x11], progressive=True))
    write("texture", "jpeg-restart.jpg", jpeg([0x11], restart=1))


# --- TGA, BMP, HDR --------------------------------------------------------------------------------


def tga(kind, depth, data, palette=b"", palette_depth=0):
    entries = 2 if palette else 0
    return struct.pack("<BBBHHBHHHHBB", 0, int(bool(palette)), kind, 0, entries, palette_depth, 0, 0,
                       2, 2, depth, 0x20) + palette + data


def write_tgas():
    write("texture", "tga-rgb.tga", tga(2, 24, bytes(range(12))))
    write("texture", "tga-rgba.tga", tga(2, 32, bytes(range(16))))
    write("texture", "tga-16.tga", tga(2, 16, bytes(range(8))))
    write("texture", "tga-grey.tga", tga(3, 8, bytes(range(4))))
    write("texture", "tga-rle.tga", tga(10, 24, b"\x82\x01\x02\x03\x00\x04\x05\x06"))
    write("texture", "tga-palette.tga", tga(1, 8, b"\0\1\1\0", b"\1\2\3\4\5\6", 24))


def bmp(depth, rows, palette=b"", compression=0, masks=b""):
    offset = 14 + 40 + len(masks) + len(palette)
    header = struct.pack("<IiiHHIIiiII", 40, 2, 2, 1, depth, compression, len(rows), 0, 0,
                         len(palette) // 4, 0)
    return (b"BM" + struct.pack("<IHHI", offset + len(rows), 0, 0, offset) + header + masks + palette
            + rows)


def write_bmps():
    write("texture", "bmp-1.bmp", bmp(1, b"\x40\0\0\0" * 2, bytes(range(8))))
    write("texture", "bmp-4.bmp", bmp(4, b"\x01\0\0\0" * 2, bytes(range(8))))
    write("texture", "bmp-8.bmp", bmp(8, b"\x01\0\0\0" * 2, bytes(range(8))))
    write("texture", "bmp-24.bmp", bmp(24, bytes(range(16))))
    write("texture", "bmp-32.bmp", bmp(32, bytes(range(16))))
    masks = struct.pack("<III", 0xF800, 0x07E0, 0x001F)
    write("texture", "bmp-16-masks.bmp", bmp(16, bytes(range(8)), b"", 3, masks))
    old = b"BM" + struct.pack("<IHHI", 42, 0, 0, 26) + struct.pack("<IHHHH", 12, 2, 2, 1, 24)
    write("texture", "bmp-old.bmp", old + bytes(range(16)))


HDR_START = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"


def flat_hdr():
    return HDR_START + b"-Y 2 +X 1\n" + b"\x80\x40\x20\x81" * 2


def write_hdrs():
    write("texture", "hdr-flat.hdr", flat_hdr())
    runs = b"\x02\x02\x00\x08" + b"\x88\x40" * 3 + b"\x08" + bytes(range(124, 132))
    write("texture", "hdr-runs.hdr", HDR_START + b"-Y 1 +X 8\n" + runs)


# --- EXR, PFM -------------------------------------------------------------------------------------

EXR_COMPRESSIONS = {"none": 0, "rle": 1, "zips": 2, "zip": 3, "piz": 4, "pxr24": 5, "b44": 6}


def exr(compression, pixel_type=2, tiled=False, width=4, height=2):
    """Black pictures, so that any compression stores them plainly: never larger than they are."""

    def attribute(name, kind, value):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(value)) + value

    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    channels = b"".join(name + b"\0" + struct.pack("<IBxxxII", pixel_type, 0, 1, 1)
                        for name in (b"B", b"G", b"R")) + b"\0"
    header = (attribute(b"channels", b"chlist", channels)
              + attribute(b"compression", b"compression", bytes([EXR_COMPRESSIONS[compression]]))
              + attribute(b"dataWindow", b"box2i", window)
              + attribute(b"displayWindow", b"box2i", window)
              + attribute(b"lineOrder", b"lineOrder", b"\0")
              + attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1))
              + attribute(b"screenWindowCenter", b"v2f", struct.pack("<ff", 0, 0))
              + attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)))
    if tiled:
        header += attribute(b"tiles", b"tiledesc", struct.pack("<IIB", width, height, 0))
    start = b"\x76\x2f\x31\x01" + struct.pack("<I", 0x202 if tiled else 2) + header + b"\0"
    row = bytes(width * 3 * (2 if pixel_type == 1 else 4))
    rows_per_chunk = height if tiled or compression not in ("none", "rle", "zips") else 1
    chunks = []
    for y in range(0, height, rows_per_chunk):
        data = row * rows_per_chunk
        if compression.startswith("zip"):  # bytes' differences from 128, of zeros: one 0, then 128s
            data = min(zlib.compress(b"\0" + b"\x80" * (len(data) - 1)), data, key=len)
        place = struct.pack("<iiii", 0, 0, 0, 0) if tiled else struct.pack("<i", y)
        chunks.append(place + struct.pack("<I", len(data)) + data)
    at = len(start) + 8 * len(chunks)
    table = b""
    for chunk in chunks:
        table += struct.pack("<Q", at)
        at += len(chunk)
    return start + table + b"".join(chunks)


def write_pictures():
    for name in EXR_COMPRESSIONS:
        write("picture", f"exr-{name}.exr", exr(name))
    write("picture", "exr-half.exr", exr("none", pixel_type=1))
    write("picture", "exr-tiled.exr", exr("zip", tiled=True))
    write("picture", "little.pfm", b"PF\n2 1\n-1.0\n" + struct.pack("<6f", *range(6)))
    write("picture", "flat.hdr", flat_hdr())
    write("picture", "rgb.png", png(2, 8))
    write("picture", "big.pfm", b"PF\n2 1\n1.0\n" + struct.pack(">6f", *range(6)))


# --- Films, without their checksums ---------------------------------------------------------------


def film(width, height, blocks):
    pixels = width * height

    def chunk(numbers):
        data = b"".join(n.to_bytes(16, "little", signed=True) for n in numbers)
        return zlib.compress(b"".join(data[byte::16] for byte in range(16)), 1)

    chunks = [chunk([(i + 1) << 70 for i in range(3 * pixels)]),
              chunk([(i % 5 + 1) << 70 for i in range(8 * pixels)])]
    description = json.dumps({
        "scene_hash": "0123456789abcdef", "settings": {"seed": "0", "size": f"{width}x{height}"},
        "devices": ["a device"], "width": width, "height": height, "unit_exponent": 3,
        "blocks": blocks, "non_finite_samples": 0, "cut_paths": 1, "non_finite_pixels": 0,
        "overflowed_pixels": 0, "chunk_bytes": [len(c) for c in chunks]}).encode()
    return (b"CALOFILM" + struct.pack("<IIQ", 1, len(description), 0) + description
            + b"".join(chunks))


def write_films():
    write("film", "one.film", film(1, 1, [[0, 8]]))
    write("film", "parts.film", film(2, 3, [[0, 2], [5, 9], [1000, 1001]]))
    write("film", "empty.film", film(3, 1, []))


write_pngs()
write_jpegs()
write_tgas()
write_bmps()
write_hdrs()
write_pictures()
write_films()
