#!/usr/bin/env python3
"""Bad input and rough handling of the image: files that are missing, an image of 16384 px, a window that is
resized all the time. FAULTS J."""
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import time
import zlib

from png import read_png
from support import Program, expect, home, settings_in, virtual_screen

program_file = sys.argv[1]
sanitized = b"__asan_init" in pathlib.Path(program_file).read_bytes()
SCENE = """
[scene]
title = "what is not there"
[[material]]
name = "base"
base_color_map = "gone_base.png"
[[material]]
name = "maps"
normal_map = "gone_normal.png"
orm_map = "gone_orm.png"
height_map = "gone_height.png"
[sun]
[sky]
skybox = "gone_sky"
[[entity]]
name = "box"
primitive = { box = [2, 2, 2] }
material = "base"
sound = { file = "gone.ogg" }
[[entity]]
name = "ball"
primitive = { sphere = 1 }
material = "maps"
position_m = [3, 0, 0]
[[entity]]
name = "model"
model = "gone.glb"
position_m = [-3, 0, 0]
"""


def rendered(scene, folder, environment, *words, code=0):
    file = folder / "image.png"
    done = subprocess.run([program_file, "render", scene, "--size", "320x180", "--out", file, *words], env=environment,
                          capture_output=True, text=True, timeout=120)
    expect(done.returncode == code, f"render {scene}: exit {done.returncode}\n{done.stderr}")
    return done.stderr


def missing_files_of_every_kind(folder, environment):
    """A line for each file, with its place in the scene, and an image all the same; without a shader there is none."""
    scene = folder / "gone.toml"
    scene.write_text(SCENE)
    said = rendered(scene, folder, environment)
    for name in ("gone_base.png", "gone_normal.png", "gone_orm.png", "gone_height.png", "gone_sky", "gone.ogg", "gone.glb"):
        line = 1 + SCENE[:SCENE.index(name)].count("\n")
        expect(len(re.findall(rf"gone\.toml:{line}:\d+: warning: .*\"{re.escape(name)}\" does not exist; ", said)) == 1,
               f"not one line for {name} at line {line}:\n{said}")
    colors = {pixel for row in read_png(folder / "image.png") for pixel in map(tuple, row)}
    expect(len(colors) > 20, f"an image of {len(colors)} colours")
    (folder / "gone_sky").mkdir()
    expect('"gone_sky" holds no px.exr, .png or .jpg' in rendered(scene, folder, environment), "an empty sky is not told")
    # Where all six are expected, one that is missing is told and the others are shown.
    sky = pathlib.Path("assets/skies/clouds")
    for face in list(sky.glob("*.png"))[1:]:
        (folder / "gone_sky" / face.name).symlink_to(face.absolute())
    said = rendered(scene, folder, environment)
    expect(said.count("gone_sky") >= 1, f"a missing face is not told:\n{said}")
    data = folder / "own data"
    data.mkdir()
    for name in ("assets", "config"):
        (data / name).symlink_to(pathlib.Path(name).absolute())
    shutil.copytree("shaders", data / "shaders")
    (data / "shaders/mesh.frag").unlink()
    said = rendered("falling_cube", folder, {**environment, "PLUMBLINE_DATA": str(data)}, code=3)
    expect(said.count("\n") == 1 and "mesh.frag: No such file" in said, f"a missing shader:\n{said}")


def memory_that_is_refused(folder, environment):
    """Drivers crash where it is refused to them while they draw: the limit is looked at before."""
    if sanitized:
        return
    done = subprocess.run([program_file, "render", "garden", "--out", folder / "image.png"], env=environment, text=True,
                          capture_output=True, timeout=120,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (800_000 * 1024,) * 2))
    expect(done.returncode == 3 and done.stderr.count("\n") == 1 and "(ulimit -v) leaves less" in done.stderr,
           f"exit {done.returncode}: {done.stderr}")


def a_map_of_every_format(folder, environment):
    """An EXR as base_color_map once ended the program, at live reload as well."""
    scene = folder / "maps.toml"
    scene.write_text('[scene]\ntitle = "maps"\n[[material]]\nname = "m"\nbase_color_map = "a.exr"\nnormal_map = "a.exr"\n'
                     'orm_map = "a.exr"\nheight_map = "a.exr"\nheight_depth = 0.1\nshading = "pbr"\n[sun]\n[[entity]]\n'
                     'name = "a"\nprimitive = { box = [4, 4, 4] }\nmaterial = "m"\n')
    shutil.copy(sorted(pathlib.Path("assets/skies").rglob("*.exr"))[0], folder / "a.exr")
    said = rendered(scene, folder, environment)
    expect(said == "", said)


def write_black_png(file, width, height, channels):
    def chunk(kind, body):
        return len(body).to_bytes(4, "big") + kind + body + zlib.crc32(kind + body).to_bytes(4, "big")
    packer, row = zlib.compressobj(1), bytes(1 + width * channels)
    packed = b"".join(packer.compress(row) for _ in range(height)) + packer.flush()
    head = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes([8, 2 if channels == 3 else 0, 0, 0, 0])
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", packed) + chunk(b"IEND", b""))


def an_image_of_16384_pixels(folder, environment):
    """800 MiB are refused in one line; 192 are taken, and no more is held of them than a window can show."""
    scene = folder / "large.toml"
    scene.write_text('[scene]\ntitle = "large"\n[[material]]\nname = "m"\nbase_color_map = "large.png"\n[sun]\n[[entity]]\n'
                     'name = "a"\nprimitive = { box = [4, 4, 4] }\nmaterial = "m"\n')
    for height, refusals in ((16384, 1), (4096, 0)):
        write_black_png(folder / "large.png", 16384, height, 3)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        said = rendered(scene, folder, environment)
        expect(said.count("large.png is refused") == refusals and said.count("\n") == refusals, said)
        most_mib = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
        expect(sanitized or most_mib < 480, f"16384 x {height}: {most_mib} MiB, {before / 1024} before")


def a_window_that_is_resized_all_the_time(folder, environment):
    (folder / "config/plumbline/app.toml").unlink()  # as many frames as it can
    game = Program([program_file, "play", "playroom", "--size", "480x270"], environment, folder / "sizes.txt")
    chance = random.Random(11)
    try:
        for _ in range(200):
            game.do("windowsize", game.window, chance.randint(1, 1200), chance.randint(1, 700))
            time.sleep(0.02)
            expect(game.process.poll() is None, f"it ended:\n{game.log()}")
        game.do("windowsize", game.window, 640, 360)
        game.focus()

        def image():
            rows = read_png(game.screenshot(folder / "data/plumbline/shots"))
            return rows if (len(rows[0]), len(rows)) == (640, 360) else None
        rows = game.until(image, "no image of 640 x 360")
        expect(len({tuple(pixel) for row in rows for pixel in row}) > 100, "nothing is in the image")
        expect("error" not in game.log(), game.log())
    finally:
        game.stop()


def main():
    with virtual_screen() as screen:
        for test in (missing_files_of_every_kind, memory_that_is_refused, a_map_of_every_format, an_image_of_16384_pixels,
                     a_window_that_is_resized_all_the_time):
            with home() as folder:
                test(folder, settings_in(folder, screen))


main()
