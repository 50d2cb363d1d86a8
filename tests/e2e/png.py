"""Pictures as rows of (r, g, b), without a library: 8-bit RGB, not interlaced, as the program writes them."""
import pathlib
import struct
import zlib


def read_png(file):
    data = pathlib.Path(file).read_bytes()
    place, packed = 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color, *_ = struct.unpack(">IIBBBBB", body)
            assert (depth, color) == (8, 2), (depth, color)
        if kind == b"IDAT":
            packed += body
        place += 12 + length
    raw, stride, rows = zlib.decompress(packed), 3 * width, []
    before = bytearray(stride)
    for y in range(height):
        how, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride) if how else ():
            left, up, corner = (row[i - 3] if i >= 3 else 0), before[i], (before[i - 3] if i >= 3 else 0)
            if how == 4:
                base = left + up - corner
                guess = min((left, up, corner), key=lambda value: abs(base - value))
            else:
                guess = (0, left, up, (left + up) // 2)[how]
            row[i] = (row[i] + guess) & 255
        rows.append(row)
        before = row
    return [[tuple(row[3 * x:3 * x + 3]) for x in range(width)] for row in rows]
