#!/usr/bin/env python3
"""Models of every kind look as they were made: no side white, black, inside out, mirrored or lying,
none at another scale; broken ones are one line and exit code 4, whatever they hold."""
import math
import os
import pathlib
import random
import resource
import struct
import subprocess
import sys
import tempfile

import model_files
from png import read_png

program = sys.argv[1]
sanitized = b"__asan_init" in pathlib.Path(program).read_bytes()
folder = pathlib.Path(tempfile.mkdtemp())
environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
environment.update(HOME=str(folder), XDG_CONFIG_HOME=str(folder / "config"), XDG_DATA_HOME=str(folder / "data"))
WIDTH, HEIGHT = 320, 240
FOV_Y_RAD = math.radians(60)
EYE = (4.0, 4.0, 6.0)


def run(*words, code=0):
    done = subprocess.run([program, *map(str, words)], env=environment, capture_output=True, text=True, errors="replace", timeout=120)
    output = done.stdout + done.stderr
    assert done.returncode == code, f"{words}: exit {done.returncode}, expected {code}\n{output}"
    assert "terminate called" not in output, output
    return output


def angles():
    """Of a look from EYE at the origin: yaw to the left, pitch up."""
    away = math.hypot(EYE[0], EYE[2])
    return math.atan2(EYE[0], EYE[2]), -math.atan2(EYE[1], away)


def pixel_of(point):
    """Where the camera sees a place."""
    yaw, pitch = angles()
    x, y, z = (point[i] - EYE[i] for i in range(3))
    x, z = x * math.cos(yaw) - z * math.sin(yaw), x * math.sin(yaw) + z * math.cos(yaw)
    y, z = y * math.cos(pitch) + z * math.sin(pitch), -y * math.sin(pitch) + z * math.cos(pitch)
    scale = HEIGHT / 2 / math.tan(FOV_Y_RAD / 2) / -z
    return int(WIDTH / 2 + x * scale), int(HEIGHT / 2 - y * scale)


def image_of(file, *more):
    yaw, pitch = map(math.degrees, angles())
    out = folder / "image.png"
    run("render", file, "--out", out, "--size", f"{WIDTH}x{HEIGHT}", "--camera",
        f"{EYE[0]},{EYE[1]},{EYE[2]},{yaw:.6f},{pitch:.6f}", *more)
    return read_png(out)


def places_on(side, half):
    """Near the four corners of a side, and its middle."""
    corners = model_files.side_corners(side, half)
    middle = tuple(sum(corner[i] for corner in corners) / 4 for i in range(3))
    return [tuple(middle[i] + share * (corner[i] - middle[i]) for i in range(3)) for corner in corners for share in (0.88,)] + [middle]


def colors_on(image, side, half=model_files.HALF_M):
    return [image[y][x] for x, y in map(pixel_of, places_on(side, half))]


def expect_colors(name, image, wanted, half=model_files.HALF_M):
    for side, color in wanted.items():
        seen = colors_on(image, side, half)
        assert all(abs(a - b) <= 2 for pixel in seen for a, b in zip(pixel, color)), f"{name}: side {side} is {seen}, not {color}"


def expect_shaded(name, image, half=model_files.HALF_M):
    """The sun shines from above, a little from the right and from the front; nothing is flat or lost."""
    top, right, front = (sum(sum(pixel) for pixel in colors_on(image, side, half)) / 15 for side in ("+y", "+x", "+z"))
    assert 254 > top > right + 5 > front + 10 > 30, f"{name}: {top:.0f} above, {right:.0f} right, {front:.0f} in front"


# FAULTS 29: embedded textures were dropped, vertex colours white, nothing was animated.
def every_kind_looks_as_it_was_made(kinds):
    seen_sides = {side: model_files.COLORS[side] for side in ("+x", "+y", "+z")}
    for name, has_colors in kinds.items():
        if has_colors:
            expect_colors(name, image_of(folder / name, "--shading", "unlit"), seen_sides)
        else:
            expect_shaded(name, image_of(folder / name))


def what_moves_is_where_its_keys_say():
    # A quarter of a turn to the left: the front looks right, the left side to the front.
    half = (model_files.HALF_M[2], model_files.HALF_M[1], model_files.HALF_M[0])
    turned = {"+x": model_files.COLORS["+z"], "+z": model_files.COLORS["-x"], "+y": model_files.COLORS["+y"]}
    for name in ("animated.glb", "skinned.glb"):
        expect_colors(name, image_of(folder / name, "--shading", "unlit", "--at", 0.5), turned, half)


def a_millimetre_and_ten_kilometres_fill_the_image():
    """As a metre does, side by side and with the same shadow."""
    images, darks = {}, []
    for metres in (1.0, 0.001, 10_000.0):
        file = folder / "sized.glb"
        file.write_bytes(model_files.colored_glb(half=(metres / 2, metres / 2, metres / 2)))
        out = folder / "sized.png"
        run("render", file, "--out", out, "--size", f"{WIDTH}x{HEIGHT}", "--shading", "unlit")
        image = read_png(out)
        shares = [sum(pixel == model_files.COLORS[side] for row in image for pixel in row) / (WIDTH * HEIGHT)
                  for side in ("+x", "+y", "+z")]
        assert sum(shares) > 0.1 and min(shares) > 0.002, f"{metres} m: sides are {shares} of the image"
        images[metres] = shares
        assert all(abs(a - b) < 0.003 for a, b in zip(shares, images[1.0])), images
        if metres > 500:
            continue  # the ground is no wider than 10 km
        # From where the shadow falls to: behind, to the left, above.
        eye = ",".join(f"{share * metres:.7g}" for share in (-1.6, 2.4, -0.6))
        run("render", file, "--out", out, "--size", f"{WIDTH}x{HEIGHT}", "--camera", f"{eye},-110.56,-54.55")
        ground = [sum(pixel) for row in read_png(out) for pixel in row if max(pixel) - min(pixel) < 30]
        lit = max(ground)
        dark = sum(60 < value < lit * 0.75 for value in ground) / (WIDTH * HEIGHT)
        assert dark > 0.01, f"{metres} m: {dark:.3f} of the image is shadow"
        darks.append(dark)
    assert abs(darks[0] - darks[1]) < 0.003, darks


def expect_refused(file):
    output = run("check", file, code=4)
    lines = [line for line in output.splitlines() if file.name in line]
    assert len(lines) == 1, f"{file}: told {len(lines)} times\n{output}"


# EXPERIENCE G25, FAULTS 17
def cut_files_are_refused(kinds):
    for name in ("embedded.glb", "separate.gltf", "ascii.ply", "binary.ply", "ascii.stl", "binary.stl", "box.dae", "box.fbx"):
        data = (folder / name).read_bytes()
        file = folder / ("cut" + pathlib.Path(name).suffix)
        # Whoever cuts blanks, or the name behind "endsolid", takes nothing away.
        whole = len(data.rstrip()) - (4 if name == "ascii.stl" else 0)
        for i in range(12):
            file.write_bytes(data[:whole * i // 12])
            expect_refused(file)


def wild_numbers_are_refused():
    for name, changes in {
            "box.dae": ((b'count="72"', b'count="4000000000"'), (b">0 1 2 0 2 3<", b">0 1 2 0 2 99999999<"),
                        (b"meter=\"0.01\"", b"meter=\"1e300\"")),
            "box.fbx": ((b"*72", b"*4000000000"), (b"0,1,2,-4", b"0,1,2,-99999999"), (b"*24 {", b"*-1 {"),
                        (b"100,200\n", b"200,200\n")),
            "ascii.stl": ((b"vertex 1 ", b"vertex nan "), (b"vertex 1 ", b"vertex 1e999 ")),
            "binary.stl": ((struct.pack("<I", 12), struct.pack("<I", 0xFFFFFFFF)),),
    }.items():
        data = (folder / name).read_bytes()
        for old, new in changes:
            assert old in data, (name, old)
            file = folder / ("wild" + pathlib.Path(name).suffix)
            file.write_bytes(data.replace(old, new, 1))
            expect_refused(file)


def a_side_that_is_nowhere_is_left_out():
    for name, old, new in (("box.fbx", b"a: 100,", b"a: nan,"), ("colored.glb", struct.pack("<f", 1.5), struct.pack("<f", math.nan))):
        file = folder / ("nowhere" + pathlib.Path(name).suffix)
        file.write_bytes((folder / name).read_bytes().replace(old, new, 1))
        output = run("check", file, code=0 if name == "box.fbx" else 4)
        assert "is left out: its vertex 0 is not finite" in output or "it holds no triangles" in output, output


def a_model_that_grows_without_end_is_limited():
    """Each node of this Collada file shows the one before it twice: 2^40 of them."""
    text = (folder / "box.dae").read_text()
    start = text.index("<library_visual_scenes>")
    nodes = '<library_nodes><node id="n0"><instance_geometry url="#g"/></node>' + "".join(
        f'<node id="n{i}"><instance_node url="#n{i - 1}"/><instance_node url="#n{i - 1}"/></node>' for i in range(1, 41))
    scene = ('</library_nodes><library_visual_scenes><visual_scene id="s"><node id="n"><instance_node url="#n40"/></node>'
             '</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>')
    file = folder / "endless.dae"
    file.write_text(text[:start] + nodes + scene)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    expect_refused(file)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert sanitized or after.ru_maxrss < 700 * 1024, f"{after.ru_maxrss / 1024} MiB"
    assert after.ru_utime - before.ru_utime < 15, f"{after.ru_utime - before.ru_utime} s of CPU time"


# FAULTS 34: one saw nothing of a surface that is made the other way round.
def a_surface_is_seen_from_behind():
    file = folder / "behind.stl"
    file.write_text("solid a\nfacet normal 0 0 0\nouter loop\nvertex -1 0 -1\nvertex 0 0 1\nvertex 1 0 -1\nendloop\nendfacet\n"
                    "endsolid a\n")
    x, y = pixel_of((0.0, -0.3, 0.0))
    for name, text in (("front", file.read_text()), ("back", file.read_text().replace("vertex 0 0 1\nvertex 1 0 -1", "vertex 1 0 -1\nvertex 0 0 1"))):
        file.write_text(text)
        yaw, pitch = map(math.degrees, angles())
        out = folder / "image.png"
        run("render", file, "--out", out, "--size", f"{WIDTH}x{HEIGHT}", "--shading", "unlit", "--camera",
            f"{EYE[0]},{EYE[1]},{EYE[2]},{yaw:.6f},{pitch:.6f}")
        assert tuple(read_png(out)[y][x]) == (255, 255, 255), f"{name}: {read_png(out)[y][x]}"


def utf16_is_named():
    file = folder / "wide.obj"
    file.write_bytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".encode("utf-16"))
    assert "its text is UTF-16; save it as UTF-8" in run("check", file, code=4)


def noise_never_crashes():
    """Bytes changed at random: read or refused, never more."""
    chance = random.Random(1)
    for name in ("box.dae", "box.fbx", "ascii.stl", "binary.stl", "skinned.glb"):
        data = (folder / name).read_bytes()
        for _ in range(10):
            noisy = bytearray(data)
            for _ in range(20):
                noisy[chance.randrange(len(noisy))] = chance.randrange(256)
            file = folder / ("noisy" + pathlib.Path(name).suffix)
            file.write_bytes(noisy)
            done = subprocess.run([program, "check", file], env=environment, capture_output=True, timeout=120)
            assert done.returncode in (0, 4), (name, done)
    assert not list(folder.rglob("crash*")), "a crash report was left"


def main():
    kinds = model_files.write_all(folder)
    every_kind_looks_as_it_was_made(kinds)
    what_moves_is_where_its_keys_say()
    a_millimetre_and_ten_kilometres_fill_the_image()
    cut_files_are_refused(kinds)
    wild_numbers_are_refused()
    a_side_that_is_nowhere_is_left_out()
    a_model_that_grows_without_end_is_limited()
    a_surface_is_seen_from_behind()
    utf16_is_named()
    noise_never_crashes()


main()
