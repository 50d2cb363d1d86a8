#!/usr/bin/env python3
"""play and render --hour: the sky of that hour, and lamps that wait for the dark."""
import subprocess
import sys
import time

from png import read_png
from support import Program, expect, home, settings_in, virtual_screen

program_file = sys.argv[1]

SCENE = """
[scene]
title = "a lamp over a floor"
[player]
position_m = [0, 0, 6]
[time]
hour = 9
[sun]
[sky]
model = "atmosphere"
[[entity]]
name = "floor"
primitive = { box = [20, 0.2, 20] }
body = { kind = "static" }
position_m = [0, -0.1, 0]
[[entity]]
name = "lamp"
position_m = [0, 1, 0]
light = { color = [1, 0.1, 0.1], intensity = 4, radius_m = 5, on = "dark" }
"""


def mean(rows, left, right, top, bottom):
    """Of a part of the image that is given by shares of its sides: the mean (r, g, b)."""
    height, width = len(rows), len(rows[0])
    part = [pixel for row in rows[int(top * height):int(bottom * height)]
            for pixel in row[int(left * width):int(right * width)]]
    return [sum(pixel[i] for pixel in part) / len(part) for i in range(3)]


def judge(noon, night, what):
    """Blue sky over a white floor at noon; at night a dark one, over a floor that a red lamp lights."""
    sky, dark_sky = (mean(rows, 0.3, 0.7, 0.12, 0.3) for rows in (noon, night))
    floor, lit_floor = (mean(rows, 0.4, 0.6, 0.55, 0.75) for rows in (noon, night))
    expect(sky[2] > 90 and sky[2] > sky[0], f"{what}: no blue sky at noon: {sky}")
    expect(sum(dark_sky) < 0.3 * sum(sky), f"{what}: the sky at night is as at noon: {dark_sky}, {sky}")
    expect(floor[0] < 1.5 * floor[1], f"{what}: the lamp shines at noon: {floor}")
    expect(lit_floor[0] > 40 and lit_floor[0] > 2 * lit_floor[1], f"{what}: no lamp at night: {lit_floor}")


def rendered(scene, hour, folder, environment):
    file = folder / f"hour_{hour}.png"
    subprocess.run([program_file, "render", scene, "--hour", str(hour), "--size", "320x180", "--out", file,
                    "--camera", "0,1.7,6,0,0"], env=environment, check=True, timeout=120)
    return read_png(file)


def played(scene, hour, folder, environment):
    game = Program([program_file, "play", scene, "--hour", str(hour), "--size", "320x180", "--no-sound"], environment,
                   folder / f"{hour}.txt")
    shots = folder / "data/plumbline/shots"
    rows, light, since_s = None, [0.0], 0.0

    def stays():
        """Shaders that nobody has compiled yet come one a frame, however long one takes."""
        nonlocal rows, light, since_s
        rows = read_png(game.screenshot(shots))
        before, light = light, mean(rows, 0.4, 0.6, 0.55, 0.75)
        if abs(light[0] - before[0]) > 1:
            since_s = time.monotonic()
        return time.monotonic() - since_s > 3
    try:
        game.ready(shots)
        game.until(stays, "it does not come to rest")
        return rows
    finally:
        game.stop()


def main():
    with virtual_screen() as screen, home() as folder:
        environment = settings_in(folder, screen)
        scene = folder / "lamp.toml"
        scene.write_text(SCENE)
        for show in (rendered, played):
            judge(show(scene, 12, folder, environment), show(scene, 0.5, folder, environment), show.__name__)
        for command in ("play", "render"):
            done = subprocess.run([program_file, command, "falling_cube", "--hour", "12"], env=environment, capture_output=True,
                                  text=True, timeout=60)
            expect(done.returncode == 2 and done.stderr.count("the scene has no [time]") == 1, f"{command}: {done.returncode}, {done.stderr}")


main()
