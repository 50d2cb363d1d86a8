#!/usr/bin/python3
"""JSON scenes against images by another hand.

    viewer_scenes.py make              draws tests/golden/viewer_*.png from the format's description,
                                       with nothing of the program: a rasteriser in plain Python
    viewer_scenes.py check PLUMBLINE   what `plumbline render` makes of them may differ by 1 of 255
                                       but for few pixels at edges

SOURCES (c): C4 C5 C6 C8 C10 C17 C18 C19.
"""

import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "assets/scenes/viewer"
GOLDEN = ROOT / "tests/golden"
IMAGES = [(name, way) for name in ("shapes", "rings", "below") for way in ("unlit", "lit")] + [
    ("rings", "textured")]
OPTIONS = {"unlit": [], "lit": ["--shading", "blinn_phong"], "textured": ["--textures"]}
EDGE_PIXELS = 30
SAMPLES = ((0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75))


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def less(a, b):
    return [x - y for x, y in zip(a, b)]


def unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a] if length > 0 else a


def element(e):
    if "scale" in e:
        m = [[0.0] * 4 for _ in range(4)]
        for i in range(3):
            m[i][i] = e["scale"][i]
        m[3][3] = 1
        return m
    if "rotate" in e:
        angle, axis = math.radians(e["rotate"][0]), unit(e["rotate"][1:])
        c, s = math.cos(angle), math.sin(angle)
        x, y, z = axis
        return [[c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s, 0],
                [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s, 0],
                [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c), 0],
                [0, 0, 0, 1]]
    if "translate" in e:
        t = e["translate"]
        return [[1, 0, 0, t[0]], [0, 1, 0, t[1]], [0, 0, 1, t[2]], [0, 0, 0, 1]]
    position = e["lookat"]["position"]
    ahead = unit(less(e["lookat"]["target"], position))
    right = unit(cross(ahead, e["lookat"]["up"]))
    up = cross(right, ahead)
    return [[right[i], up[i], -ahead[i], position[i]] for i in range(3)] + [[0, 0, 0, 1]]


def transform(thing):
    m = [[float(i == j) for j in range(4)] for i in range(4)]
    for e in thing.get("transform", []):
        m = times(element(e), m)
    return m


def apply(m, p, w=1.0):
    return [dot(m[i][:3], p) + m[i][3] * w for i in range(3)]


def read_ply(path):
    data = path.read_bytes()
    at = data.index(b"end_header\n") + 11
    head, body = data[:at].decode().splitlines(), data[at:]
    names, kinds, counts = [], [], {}
    for line in head:
        word = line.split()
        if word[0] == "element":
            counts[word[1]] = int(word[2])
        if word[0] == "property" and word[1] != "list":
            kinds.append(word[1])
            names.append(word[2])
    rows, faces = [], []
    if "ascii" in head[1]:
        lines = body.decode().splitlines()
        rows = [[float(x) for x in line.split()] for line in lines[:counts["vertex"]]]
        faces = [[int(x) for x in line.split()[1:]] for line in lines[counts["vertex"]:]]
    else:
        form = "<" + "".join({"float": "f", "uchar": "B"}[kind] for kind in kinds)
        size = struct.calcsize(form)
        rows = [struct.unpack_from(form, body, i * size) for i in range(counts["vertex"])]
        start = counts["vertex"] * size
        faces = [struct.unpack_from("<3I", body, start + i * 13 + 1) for i in range(counts["face"])]
    column = {name: i for i, name in enumerate(names)}
    coded = kinds[column["red"]] == "uchar"
    vertices = []
    for row in rows:
        take = lambda *keys: [row[column[key]] for key in keys]
        color = take("red", "green", "blue")
        vertices.append({"p": take("x", "y", "z"),
                         "c": [(c / 255) ** 2.2 for c in color] if coded else color,
                         "n": take("nx", "ny", "nz") if "nx" in column else None,
                         "t": take("s", "t") if "s" in column else None})
    return vertices, faces


def mesh_of(thing):
    if "filename" in thing:
        return read_ply(SCENES / thing["filename"])
    triples = lambda key: [thing[key][i:i + 3] for i in range(0, len(thing[key]), 3)]
    return [{"p": p, "c": c, "n": None, "t": None}
            for p, c in zip(triples("vertices"), triples("vertex_colors"))], triples("faces")


def triangles(scene):
    """Corners in world space: place, normal, colour, texture coordinates."""
    for thing in scene["objects"]:
        m = transform(thing)
        columns = [[m[i][j] for i in range(3)] for j in range(3)]
        inverse_transpose = [cross(columns[(j + 1) % 3], columns[(j + 2) % 3]) for j in range(3)]
        sign = 1 if dot(columns[0], inverse_transpose[0]) > 0 else -1
        turned = lambda n: unit([sign * sum(inverse_transpose[j][i] * n[j] for j in range(3))
                                 for i in range(3)])
        vertices, faces = mesh_of(thing)
        for face in faces:
            corners = [vertices[i] for i in face]
            flat = cross(less(corners[1]["p"], corners[0]["p"]), less(corners[2]["p"], corners[0]["p"]))
            yield [(apply(m, c["p"]), turned(c["n"] or flat), c["c"], c["t"]) for c in corners]


def linear(code):
    c = code / 255
    return c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4


def code(light):
    c = min(max(light, 0), 1)
    return round(255 * (12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055))


def texture_at(image, t):
    """Between texel centres, repeated; v points up."""
    width, height, pixels = image
    x, y = t[0] * width - 0.5, (1 - t[1]) * height - 0.5
    x0, y0 = math.floor(x), math.floor(y)
    color = [0.0] * 3
    for j in (0, 1):
        for i in (0, 1):
            weight = (x - x0 if i else 1 - x + x0) * (y - y0 if j else 1 - y + y0)
            at = ((y0 + j) % height * width + (x0 + i) % width) * 3
            for k in range(3):
                color[k] += weight * linear(pixels[at + k])
    return color


def lit(color, normal, place, eye):
    to_light, n, to_eye = unit([1, 1, 1]), unit(normal), unit(less(eye, place))
    facing = dot(n, to_light)
    mirrored = [2 * facing * n[i] - to_light[i] for i in range(3)]
    share = 0.1 + max(facing, 0) + 0.5 * max(dot(mirrored, to_eye), 0) ** 32
    return [c * share for c in color]


def clipped(corners, near):
    """What lies beyond the near plane, as triangles; corners are (camera place, rest…)."""
    inside = []
    for i, a in enumerate(corners):
        b = corners[(i + 1) % len(corners)]
        da, db = -a[0][2] - near, -b[0][2] - near
        if da >= 0:
            inside.append(a)
        if (da >= 0) != (db >= 0):
            s = da / (da - db)
            inside.append(tuple([x + (y - x) * s for x, y in zip(u, v)] if u else None
                                for u, v in zip(a, b)))
    return [(inside[0], inside[i], inside[i + 1]) for i in range(1, len(inside) - 1)]


def draw(name, way):
    scene = json.loads((SCENES / f"{name}.json").read_text())
    camera = scene["camera"]
    width, height = camera["resolution"]
    s, near, far = camera["s"], camera["z_near"], camera["z_far"]
    m = transform(camera)
    eye = [m[i][3] for i in range(3)]
    to_camera = lambda p: [dot([m[i][j] for i in range(3)], less(p, eye)) for j in range(3)]
    image = read_png(SCENES / "ring.png") if way == "textured" else None
    places = [(x, y) for y in range(height) for x in range(width)]
    depth = [[math.inf] * 4 for _ in places]
    color = [[scene["background"]] * 4 for _ in places]
    for world in triangles(scene):
        for corners in clipped([(to_camera(p), n, c, t, p) for p, n, c, t in world], near):
            z = [-c[0][2] for c in corners]
            at = [(width * (c[0][0] / d + s * width / height) / (2 * s * width / height),
                   height * (s - c[0][1] / d) / (2 * s)) for c, d in zip(corners, z)]
            area = ((at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) -
                    (at[1][1] - at[0][1]) * (at[2][0] - at[0][0]))
            if area == 0:
                continue
            left, right = (int(f(a[0] for a in at)) for f in (min, max))
            top, bottom = (int(f(a[1] for a in at)) for f in (min, max))
            for y in range(max(top - 1, 0), min(bottom + 2, height)):
                for x in range(max(left - 1, 0), min(right + 2, width)):
                    for k, (dx, dy) in enumerate(SAMPLES):
                        px, py = x + dx, y + dy
                        w = [((at[(i + 2) % 3][0] - at[(i + 1) % 3][0]) * (py - at[(i + 1) % 3][1]) -
                              (at[(i + 2) % 3][1] - at[(i + 1) % 3][1]) * (px - at[(i + 1) % 3][0])) / area
                             for i in range(3)]
                        if min(w) < 0:
                            continue
                        away = 1 / sum(w[i] / z[i] for i in range(3))
                        place = y * width + x
                        if away > far or away >= depth[place][k]:
                            continue
                        share = [w[i] / z[i] * away for i in range(3)]
                        mix = lambda part: [sum(share[i] * corners[i][part][j] for i in range(3))
                                            for j in range(len(corners[0][part]))]
                        seen = mix(2)
                        if image and corners[0][3]:
                            seen = texture_at(image, mix(3))
                        if way == "lit":
                            seen = lit(seen, mix(1), mix(4), eye)
                        depth[place][k] = away
                        color[place] = color[place][:k] + [seen] + color[place][k + 1:]
    pixels = bytes(code(sum(min(max(sample[i], 0), 1) for sample in four) / 4)
                   for four in color for i in range(3))
    write_png(GOLDEN / f"viewer_{name}_{way}.png", width, height, pixels)


def write_png(path, width, height, pixels):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + pixels[y * width * 3:(y + 1) * width * 3] for y in range(height))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" +
                     chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def read_png(path):
    """8 bit a part, RGB or RGBA; as (width, height, RGB bytes)."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IHDR":
            width, height, _, color = struct.unpack_from(">IIBB", data, at + 8)
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += 12 + size
    step = {2: 3, 6: 4}[color]
    line, raw, rows, before = width * step, zlib.decompress(packed), b"", bytes(width * step)
    for y in range(height):
        kind, row = raw[y * (line + 1)], bytearray(raw[y * (line + 1) + 1:(y + 1) * (line + 1)])
        for i in range(line):
            a = row[i - step] if i >= step else 0
            b, c = before[i], before[i - step] if i >= step else 0
            guess = a + b - c
            nearest = min((abs(guess - a), 0, a), (abs(guess - b), 1, b), (abs(guess - c), 2, c))[2]
            row[i] = (row[i] + [0, a, b, (a + b) // 2, nearest][kind]) & 255
        before = row
        rows += bytes(row) if step == 3 else bytes(x for i, x in enumerate(row) if i % 4 < 3)
    return width, height, rows


def check_flats(got, wanted):
    """How textures are filtered is nobody's rule: where the image is flat they agree."""
    width, height, pixels = wanted
    pixel = lambda image, x, y: image[2][(y * width + x) * 3:(y * width + x) * 3 + 3]
    flats = [(x, y) for y in range(4, height - 4) for x in range(4, width - 4)
             if all(pixel(wanted, x + i, y + j) == pixel(wanted, x, y)
                    for j in range(-4, 5) for i in range(-4, 5)) and pixel(wanted, x, y) != pixel(wanted, 0, 0)]
    most = max(max(abs(a - b) for a, b in zip(pixel(got, x, y), pixel(wanted, x, y))) for x, y in flats)
    print(f"textured: {len(flats)} flat pixels, {most} apart at most")
    assert len(flats) > 1000 and most <= 3


def check(program):
    worst = []
    with tempfile.TemporaryDirectory() as folder:
        for name, way in IMAGES:
            shown = pathlib.Path(folder) / f"{name}_{way}.png"
            subprocess.run([program, "render", SCENES / f"{name}.json", "--out", shown, *OPTIONS[way]],
                           check=True, timeout=120)
            got, wanted = read_png(shown), read_png(GOLDEN / f"viewer_{name}_{way}.png")
            assert got[:2] == wanted[:2], f"{name} {way}: {got[:2]} for {wanted[:2]}"
            if way == "textured":
                check_flats(got, wanted)
                continue
            far_off = sum(max(abs(got[2][i + k] - wanted[2][i + k]) for k in range(3)) > 1
                          for i in range(0, len(got[2]), 3))
            print(f"{name} {way}: {far_off} pixels differ by more than 1")
            if far_off > EDGE_PIXELS:
                worst.append(f"{name} {way}")
    assert not worst, f"more than {EDGE_PIXELS} pixels off: {worst}"


if __name__ == "__main__":
    if sys.argv[1] == "make":
        for name, way in IMAGES:
            draw(name, way)
    else:
        check(sys.argv[2])
