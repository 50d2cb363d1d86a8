# textures/flag_base.png: three bands, blue, gold, blue, with threads. python3 make_flag_texture.py
import pathlib, random, struct, zlib

WIDE, HIGH = 96, 60                                 # pixels
BANDS = [(38, 66, 128), (220, 199, 120), (38, 66, 128)]


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


random.seed(1)
warp = [random.uniform(-5, 5) for _ in range(WIDE)]
weft = [random.uniform(-5, 5) for _ in range(HIGH)]
rows = b"".join(b"\0" + bytes(max(0, min(255, round(part + warp[x] + weft[y]))) for x in range(WIDE) for part in BANDS[y * 3 // HIGH])
                for y in range(HIGH))
image = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDE, HIGH, 8, 2, 0, 0, 0)) + \
    chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
(pathlib.Path(__file__).parents[1] / "textures/flag_base.png").write_bytes(image)
