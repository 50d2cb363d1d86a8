#!/usr/bin/python3
"""Writes assets/scenes/viewer: JSON scenes with inline triangles, ASCII and binary PLY, colours as
floats and as bytes, texture coordinates with their image, up along +Y, +Z and -Y."""

import json
import math
import pathlib
import struct
import zlib

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "scenes/viewer"


def chequer(u, v):
    """0 or 1: the image that both texture and colours of the ring are made from."""
    return (int(u * 8) + int(v * 4)) % 2


def ring(around=48, across=24, large=1.0, small=0.4):
    """A torus about z; u runs around, v across. Seams have vertices of their own."""
    vertices, faces = [], []
    for i in range(around + 1):
        for j in range(across + 1):
            a, b = math.tau * i / around, math.tau * j / across
            normal = (math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), math.sin(b))
            place = (math.cos(a) * (large + small * math.cos(b)),
                     math.sin(a) * (large + small * math.cos(b)), small * math.sin(b))
            vertices.append((place, normal, (i / around, j / across)))
    for i in range(around):
        for j in range(across):
            a, b = i * (across + 1) + j, (i + 1) * (across + 1) + j
            faces += [(a, b, b + 1), (a, b + 1, a + 1)]
    return vertices, faces


def ball(around=32, down=16):
    vertices = [(math.sin(math.pi * j / down) * math.cos(math.tau * i / around),
                 math.sin(math.pi * j / down) * math.sin(math.tau * i / around),
                 math.cos(math.pi * j / down))
                for j in range(down + 1) for i in range(around)]
    faces = []
    for j in range(down):
        for i in range(around):
            a, b = j * around + i, j * around + (i + 1) % around
            if j > 0:
                faces.append((a, a + around, b))
            if j < down - 1:
                faces.append((b, a + around, b + around))
    return vertices, faces


def write_ring():
    vertices, faces = ring()
    head = ("ply\nformat binary_little_endian 1.0\ncomment a ring\n"
            f"element vertex {len(vertices)}\n" +
            "".join(f"property {kind} {name}\n" for kind, name in
                    [("float", n) for n in ("x", "y", "z", "nx", "ny", "nz", "s", "t")] +
                    [("uchar", n) for n in ("red", "green", "blue", "alpha")]) +
            f"element face {len(faces)}\nproperty list uchar uint vertex_indices\nend_header\n")
    body = b""
    for place, normal, (u, v) in vertices:
        red = round(60 + 180 * u)
        green = 40 + 150 * chequer(min(u, 0.999), min(v, 0.999))
        body += struct.pack("<8f4B", *place, *normal, u, v, red, green, 12, 255)
    for face in faces:
        body += struct.pack("<B3I", 3, *face)
    (FOLDER / "ring.ply").write_bytes(head.encode() + body)


def write_image(side=64):
    rows = b""
    for y in range(side):
        v = 1 - (y + 0.5) / side
        row = b"".join(bytes((230, 200, 60) if chequer((x + 0.5) / side, v) else (30, 60, 120))
                       for x in range(side))
        rows += b"\0" + row

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    (FOLDER / "ring.png").write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)) +
        chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def write_ball():
    """ASCII, linear colours as floats, one of them above 1; no normals: flat."""
    vertices, faces = ball()
    lines = ["ply", "format ascii 1.0", f"element vertex {len(vertices)}"]
    lines += [f"property float {name}" for name in ("x", "y", "z", "red", "green", "blue")]
    lines += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    for x, y, z in vertices:
        lines.append(f"{x:.6f} {y:.6f} {z:.6f} {0.02 + 0.3 * (x + 1):.6f} {0.1 + 0.6 * (z + 1):.6f} 0.35")
    lines += ["3 %d %d %d" % face for face in faces]
    (FOLDER / "ball.ply").write_text("\n".join(lines) + "\n")


def look(position, target, up):
    return [{"lookat": {"position": position, "target": target, "up": up}}]


def scene(name, camera, objects, background=(0.5, 0.5, 0.5)):
    whole = {"camera": camera, "background": list(background), "objects": objects}
    (FOLDER / f"{name}.json").write_text(json.dumps(whole, indent=1) + "\n")


TETRAHEDRON = {
    "vertices": [0, 1, 0, -1, -1, 1, 1, -1, 1, 0, -1, -1],
    "faces": [0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2],
    "vertex_colors": [0.9, 0.9, 0.2, 0.8, 0.1, 0.1, 0.1, 0.7, 0.1, 0.1, 0.2, 0.9],
}
SHEET = {
    "vertices": [-2, -1, -0.5, 2, -1, 0.5, 2, 1.2, 0.5, -2, 1.2, -0.5],
    "faces": [0, 1, 2, 0, 2, 3],
    "vertex_colors": [0.05, 0.05, 0.05, 0.6, 0.3, 0.1, 0.9, 0.8, 0.7, 0.2, 0.5, 0.6],
}

if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    write_ring()
    write_image()
    write_ball()
    # The transforms turn, then scale: their normals need the inverse transpose.
    scene("shapes",
          {"resolution": [320, 240], "s": 0.5, "z_near": 0.5, "z_far": 30,
           "transform": look([1, 1.5, 6], [0, 0, 0], [0, 1, 0])},
          [{**TETRAHEDRON, "transform": [{"rotate": [35, 1, 2, 0.5]}, {"scale": [1.4, 0.8, 1.1]},
                                         {"translate": [-0.6, 0.1, 0]}]},
           {**SHEET, "transform": [{"rotate": [-20, 0, 1, 0]}, {"translate": [0.3, 0, -0.4]}]}])
    scene("rings",
          {"resolution": [320, 240], "s": 0.4, "z_near": 0.1, "z_far": 40,
           "transform": look([5, -4, 3], [0, 0, 0.2], [0, 0, 1])},
          [{"filename": "ring.ply"},
           {"filename": "ring.ply", "transform": [{"rotate": [90, 1, 0, 0]}, {"translate": [1, 0, 0]}]},
           {"filename": "ball.ply", "transform": [{"scale": [0.35, 0.35, 0.5]}]}])
    scene("below",
          {"resolution": [240, 320], "s": 0.6, "z_near": 0.1, "z_far": 9.2,
           "transform": look([0, -3, -8], [0, 0, 0], [0, -1, 0])},
          [{"filename": "ball.ply", "transform": [{"scale": [2, 1.2, 2]}, {"rotate": [25, 0, 0, 1]}]},
           {"filename": "ring.ply", "transform": [{"scale": [1.6, 1.6, -1.6]}, {"rotate": [70, 1, 0, 0]}]}],
          (0.02, 0.05, 0.2))
