#!/usr/bin/env python3
"""The book's stages in a window, one after the other: each opens with its own controls, its keys do what
docs/SOURCES.md says of rows A1 to A39, and an image of each is kept (PL_E2E_IMAGES)."""
import os
import pathlib
import shutil
import subprocess
import sys
import time

from png import read_png
from support import Program, Recording, app_settings, expect, home, settings_in, virtual_screen

program_file = sys.argv[1]
images = os.environ.get("PL_E2E_IMAGES")

BACKGROUND = (153, 166, 217)
RED = lambda p: p[0] > 25 and p[0] > 2 * p[1] + 10 and p[0] > 2 * p[2] + 10
BLUE = lambda p: p[2] > 15 and p[2] > 2 * p[0] and p[2] > 1.7 * p[1]
GREEN = lambda p: p[1] > 15 and p[1] > 1.7 * p[0] and p[1] > 1.7 * p[2]
YELLOW = lambda p: p[0] > 25 and 0.6 * p[0] < p[1] < p[0] and p[2] < 0.5 * p[0]
PURPLE = lambda p: p[0] > 8 and p[2] > 8 and 0.6 < p[0] / p[2] < 1.7 and p[1] < 0.5 * min(p[0], p[2])


class Stage:
    """One stage in a window of 640 x 480, with nothing written over the image."""

    def __init__(self, screen, folder, name):
        self.name = name
        self.folder = folder / name
        self.folder.mkdir()
        self.shots = self.folder / "data" / "plumbline" / "shots"
        settings = self.folder / "config" / "plumbline" / "app.toml"
        settings.parent.mkdir(parents=True)
        settings.write_text(app_settings("[image]\nrender_scale = 1.0\n"))  # colours as they were drawn, not scaled up
        self.game = Program([program_file, "play", f"book/{name}", "--size", "640x480", "--level", "high"],
                            settings_in(self.folder, screen), self.folder / "log.txt")

    def __enter__(self):
        self.game.ready(self.shots)
        self.point(4, 4)
        self.press("F1")
        self.again()
        return self

    def __exit__(self, failed, *_):
        try:
            if not failed:
                self.keep("end")
                expect("error" not in self.game.log(), self.game.log())
        finally:
            self.game.stop()

    def again(self):
        """From the start, standing still."""
        self.press("r")

    def image(self):
        self.last = self.game.screenshot(self.shots)
        if images:
            shutil.copy(self.last, pathlib.Path(images) / f"book_{self.name}_last.png")
        return read_png(self.last)[:330]  # below, messages may stand

    def at_rest(self, rest_s=0.7):
        """The image that has stayed for so long."""
        first, since_s = self.image(), time.monotonic()

        def stays():
            nonlocal first, since_s
            rows = self.image()
            if rows != first:
                first, since_s = rows, time.monotonic()
            return time.monotonic() - since_s > rest_s
        self.game.until(stays, f"{self.name}: it does not come to rest")
        return first

    def keep(self, words):
        self.image()
        if images:
            shutil.copy(self.last, pathlib.Path(images) / f"book_{self.name}_{words}.png")

    def point(self, x, y):
        self.game.do("mousemove", "--window", self.game.window, int(x), int(y))

    def press(self, key, times=1):
        """A frame has seen it when this returns."""
        self.game.press(key, times, 0.05)
        self.game.screenshot(self.shots)


def share(rows, wanted):
    return sum(wanted(pixel) for row in rows for pixel in row) / (len(rows) * len(rows[0]))


def middle(rows, wanted):
    """Where the pixels of a colour are, in the mean."""
    places = [(x, y) for y, row in enumerate(rows) for x, pixel in enumerate(row) if wanted(pixel)]
    expect(places, "none of that colour is in the image")
    return sum(x for x, _ in places) / len(places), sum(y for _, y in places) / len(places)


def until(stage, condition, message):
    def look():
        rows = stage.image()
        return rows if condition(rows) else None
    return stage.game.until(look, f"{stage.name}: {message}")


def window(stage):
    rows = stage.at_rest()
    expect(all(pixel == BACKGROUND for row in rows for pixel in row), f"cleared to {rows[240][320]}")


def box(stage):
    rows = stage.at_rest()
    expect(rows[4][4] == BACKGROUND, f"behind the box: {rows[4][4]}")
    expect(rows[240][320] == (255, 51, 51), f"the box: {rows[240][320]}")
    stage.press("w")
    until(stage, lambda wires: 0 < share(wires, RED) < 0.5 * share(rows, RED), "W shows wires")
    stage.press("w")


def lighting(stage):
    rows = stage.at_rest()
    balls = [[pixel for row in rows[60:235] for pixel in row[low:high] if RED(pixel) or min(pixel) > 225]
             for low, high in ((60, 235), (235, 405), (405, 580))]
    brightest = [max(map(sum, ball)) for ball in balls]
    expect(len(set(balls[0])) <= 3, f"ambient light alone is even: {len(set(balls[0]))} colours")
    expect(brightest[0] + 120 < brightest[1] < brightest[2] - 120, f"each part adds light: {brightest}")
    expect(any(min(pixel) > 200 for pixel in balls[2]), "the highlight is white")
    flat, smooth = ({pixel for row in rows[262:330] for pixel in row[low:high] if pixel[1] > 1.5 * pixel[0]}
                    for low, high in ((150, 315), (325, 490)))
    expect(len(flat) > 20 and len(flat) < 0.9 * len(smooth), f"{len(flat)} shades flat, {len(smooth)} smooth")


def depth(stage):
    def seen():
        rows = stage.at_rest(0.2)
        return [share(rows, color) for color in (RED, BLUE, GREEN)]

    stage.at_rest()
    less = seen()
    expect(min(less) > 0.002, f"LESS: all three are seen: {less}")
    shares = {}
    for name in ("always", "never", "greater", "off", "less"):
        stage.press("t")
        shares[name] = seen()
        stage.keep(name)
    expect(shares["always"][2] > 1.3 * less[2] and shares["always"][0] < less[0], f"ALWAYS: {shares['always']}, LESS: {less}")
    expect(shares["off"] == shares["always"], "without a test as with ALWAYS")
    expect(max(shares["never"] + shares["greater"]) == 0, "NEVER and GREATER let nothing through")
    expect(shares["less"] == less, "and back")


def camera(stage):
    first = stage.at_rest()
    at_start = share(first, RED)
    stage.press("x")
    until(stage, lambda rows: 0.4 < share(rows, RED) / at_start < 0.75, "X: 20 m instead of 15")
    stage.press("z", 2)
    until(stage, lambda rows: 1.8 < share(rows, RED) / at_start < 3.2, "Z twice: 10 m")
    stage.press("x")
    until(stage, lambda rows: abs(share(rows, RED) - at_start) < 0.0005, "X again: 15 m")
    for there, back in (("Left", "Right"), ("Up", "Down")):
        stage.press(there, 4)
        until(stage, lambda rows: rows != first, f"{there} turns")
        stage.keep(there.lower())
        stage.press(back, 4)
        until(stage, lambda rows: abs(share(rows, RED) - at_start) < 0.0005, f"{back} turns back")
    stage.game.hold("Right", 0.8)
    expect(stage.at_rest(0.2) != first, "what is held goes on")


def falling_cube(stage):
    high = middle(stage.image(), RED)[1]
    low = until(stage, lambda rows: middle(rows, RED)[1] > high + 20, "the box falls")
    stage.keep("falling")
    expect(share(low, RED) > 0.001, "and is still there")


def many_objects(stage):
    until(stage, lambda rows: share(rows, RED) > 0.001 and share(rows, BLUE) > 0.001, "a red box and a blue one")


def debug_drawing(stage):
    before = stage.at_rest(1)
    stage.press("b")
    boxes = stage.at_rest(0.2)
    stage.keep("boxes")
    lines = sum(a != b for one, other in zip(before, boxes) for a, b in zip(one, other))
    expect(lines > 300, f"B draws boxes: {lines} pixels")
    stage.press("b")
    stage.press("s")
    shapes = stage.at_rest(0.2)
    stage.keep("shapes")
    expect(shapes != before and shapes != boxes, "S draws shapes, which are not the boxes")
    stage.press("s")
    stage.press("w")
    until(stage, lambda rows: share(rows, RED) < 0.6 * share(before, RED), "W shows wires")
    stage.press("w")
    until(stage, lambda rows: abs(share(rows, RED) - share(before, RED)) < 0.0005, "and all is as it was")


def ray_and_drag(stage):
    x, y = middle(stage.at_rest(1), BLUE)
    stage.point(x, y)
    stage.game.do("mousedown", 1)
    for _ in range(12):
        stage.game.do("mousemove_relative", "--", 8, -8)
        time.sleep(0.05)

    def is_dragged(rows):
        now_x, now_y = middle(rows, BLUE)
        return now_x > x + 50 and now_y < y - 50
    until(stage, is_dragged, f"the blue box is dragged from {x:.0f}, {y:.0f}")
    stage.keep("dragged")
    stage.game.do("mouseup", 1)
    stage.point(500, 60)
    stage.game.do("click", 3)
    until(stage, lambda rows: share(rows, PURPLE) > 0.0005, "the right button shoots")
    stage.keep("shot")
    stage.point(*middle(stage.image(), RED))
    stage.press("d")
    until(stage, lambda rows: share(rows, RED) == 0, "D deletes the red box")


def events(stage):
    stage.press("p")
    stage.again()
    until(stage, lambda rows: share(rows, YELLOW) == 0 and share(rows, RED) > 0.0005, "red in the air")
    stage.keep("air")
    stage.press("p")
    until(stage, lambda rows: share(rows, YELLOW) > 0.0005 and share(rows, RED) == 0, "yellow on the ground")


def trigger(stage):
    stage.press("p")
    stage.again()
    expect(share(stage.at_rest(0.3), GREEN) < 0.02, "no green box yet")
    stage.keep("before")
    stage.press("p")
    until(stage, lambda rows: share(rows, GREEN) > 0.01, "a green box appears")


def forces(stage):
    before = middle(stage.at_rest(), RED)
    stage.point(*before)
    stage.game.do("keydown", "g")
    until(stage, lambda rows: middle(rows, RED)[1] < before[1] - 30, f"G lifts the red box from {before}")
    stage.game.do("keyup", "g")
    stage.keep("lifted")
    rows = stage.at_rest()
    x, y = middle(rows, BLUE)
    stage.point(x - 4, y + 20)
    stage.press("e")
    stage.keep("exploding")
    after = until(stage, lambda later: share(later, BLUE) == 0 or abs(middle(later, BLUE)[0] - x) +
                  abs(middle(later, BLUE)[1] - y) > 15, "E throws the blue boxes apart")
    expect(after != rows, "E changes the image")


def shapes(stage):
    rows = until(stage, lambda rows: all(share(rows, color) > 0.0003 for color in (RED, BLUE, YELLOW, PURPLE)),
                 "pyramid, ball, cylinder and dumbbell are seen")
    expect(rows[4][4] == BACKGROUND, "against the background")


def filters(stage):
    rows = stage.at_rest(1)
    expect(share(rows, RED) > 0.01 and share(rows, BLUE) > 0.01, "boxes and balls in the same places")


STAGES = (window, box, lighting, depth, camera, falling_cube, many_objects, debug_drawing, ray_and_drag, events,
          trigger, forces, shapes, filters)


def stages_open(screen, folder, wanted):
    for stage_of in STAGES:
        if wanted and stage_of.__name__ not in wanted:
            continue
        with Stage(screen, folder, stage_of.__name__) as stage:
            stage_of(stage)


def what_was_done_replays(screen, folder):
    """Shots, drags, lifts, explosions and deletions come back bit for bit, whatever the window's size."""
    environment = settings_in(folder, screen)
    tape = folder / "done.tape"
    game = Program([program_file, "play", "book/ray_and_drag", "--size", "640x480", "--record", str(tape)],
                   environment, folder / "log.txt")
    try:
        game.ready(folder / "data/plumbline/shots")
        for x, y, button in ((500, 60, 3), (320, 215, 3), (300, 212, 1)):
            game.do("mousemove", "--window", game.window, x, y)
            game.do("mousedown", button)
            time.sleep(0.4)
            game.do("mousemove_relative", "--", 20, -20)
            time.sleep(0.4)
            game.do("mouseup", button)
        game.hold("g", 0.8)
        game.press("e")
        game.press("d")
        time.sleep(1)
        game.process.terminate()
        expect(game.wait(60) == 130, game.log())
    finally:
        game.stop()
    done = Recording(tape)
    expect(done.whole and done.has_pointer and {"shoot", "grab", "lift", "explode", "remove"} <= done.told, done.told)
    again = subprocess.run([program_file, "play", "book/ray_and_drag", "--size", "320x180", "--replay", str(tape)],
                           env=environment, capture_output=True, text=True, timeout=120)
    expect(again.returncode == 0, f"replay: exit {again.returncode}\n{again.stderr}")


if __name__ == "__main__":
    with virtual_screen() as screen, home() as folder:
        stages_open(screen, folder, sys.argv[2:])
        what_was_done_replays(screen, folder)
