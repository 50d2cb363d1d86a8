#!/usr/bin/env python3
"""Models in a window: a file dropped on it opens, one that cannot be read says so and leaves what was
there, the aids draw what they promise, and a saved model shows anew."""
import os
import pathlib
import subprocess
import sys
import time

import model_files
from png import read_png
from support import Program, expect, home, settings_in, virtual_screen

program_file = sys.argv[1]


class Viewer:
    """A window with a model in it, and images of it."""

    def __init__(self, screen, folder):
        self.folder, self.environment = folder, settings_in(folder, screen)
        self.shots = folder / "data" / "plumbline" / "shots"
        self.game = Program([program_file, "play", str(folder / "colored.glb"), "--size", "640x480", "--level", "high"],
                            self.environment, folder / "log.txt")
        self.wait_for_title("colored")
        self.game.ready(self.shots)

    def wait_for_title(self, words):
        self.game.window = self.game.until(lambda: self.game.window_named(words), f"no window \"{words}\"")

    def drop(self, file):
        subprocess.run([sys.executable, str(pathlib.Path(__file__).with_name("drop_file.py")), self.game.window, str(file)],
                       env=self.environment, check=True, timeout=90)

    def press(self, key):
        """A frame has seen it when this returns."""
        self.game.press(key)
        self.image()

    def image(self):
        return read_png(self.game.screenshot(self.shots))

    def seen(self, condition, message):
        """The first image that is as wanted: shaders that nobody has compiled yet come one a frame."""
        def look():
            rows = self.image()
            return rows if condition(rows) else None
        return self.game.until(look, message)

    def at_rest(self):
        """The image that has stayed for a second."""
        first, since_s = self.image(), time.monotonic()

        def stays(rows):
            nonlocal first, since_s
            if not same(first, rows):
                first, since_s = rows, time.monotonic()
            return time.monotonic() - since_s > 1
        return self.seen(stays, "it does not come to rest")

    def lit(self):
        """The share of pixels with a colour, which all but the model lack."""
        return lit(self.image())


def upper(rows):
    """What no message is written over."""
    return rows[:330]


def lit(rows):
    pixels = [pixel for row in upper(rows) for pixel in row]
    return sum(max(pixel) - min(pixel) > 90 for pixel in pixels) / len(pixels)


def same(a, b):
    return upper(a) == upper(b)


def corner(rows):
    """The background."""
    return rows[4][-4]


def foot(rows):
    """In front of everything: the ground, where there is one."""
    return rows[-4][6]


def count(rows, wanted):
    return sum(wanted(pixel) for row in upper(rows) for pixel in row)


def aids_draw_what_they_promise(viewer):
    plain = viewer.at_rest()
    share = lit(plain)
    expect(share > 0.05, f"the model is {share:.3f} of the image")
    expect(corner(plain) != foot(plain), "the ground is no background")
    viewer.press("F10")
    viewer.seen(lambda rows: foot(rows) == corner(rows), "without ground the background is below too")
    viewer.press("F2")
    viewer.seen(lambda rows: corner(rows) == (255, 255, 255), "the second background is white")
    white = viewer.at_rest()
    bluish = lambda pixel: pixel[2] > 200 and pixel[0] < 120 and 80 < pixel[1] < 190
    before = count(white, bluish)
    viewer.press("alt+n")
    viewer.seen(lambda rows: count(rows, bluish) > before + 6, "normals are drawn")
    viewer.press("alt+n")
    viewer.seen(lambda rows: same(rows, white), "and go away")
    grey = lambda pixel: max(pixel) - min(pixel) < 6 and 60 < pixel[0] < 215
    before = count(white, grey)
    viewer.press("alt+g")
    viewer.seen(lambda rows: count(rows, grey) > before + 200, "the grid is drawn")
    viewer.press("alt+g")
    viewer.seen(lambda rows: same(rows, white), "and goes away")
    viewer.press("alt+x")
    viewer.seen(lambda rows: not same(rows, white), "axes are drawn")
    viewer.press("alt+x")
    viewer.seen(lambda rows: same(rows, white), "and go away")
    viewer.press("v")
    viewer.seen(lambda rows: lit(rows) < 0.6 * share, "of a wireframe one sees through most")
    viewer.press("v")
    viewer.seen(lambda rows: same(rows, white), "everything is as it was")
    viewer.press("alt+t")
    first = viewer.image()
    viewer.seen(lambda rows: not same(rows, first), "the turntable turns")
    viewer.press("alt+t")


def dragging_turns_the_model_and_the_wheel_zooms(viewer):
    first = lit(viewer.at_rest())
    viewer.game.do("mousemove", "--window", viewer.game.window, 200, 130)
    viewer.game.do("click", "--repeat", 4, "--delay", 100, 4)
    viewer.seen(lambda rows: lit(rows) > 1.4 * first, f"the wheel zooms: not 1.4 times {first:.3f}")
    before = viewer.at_rest()
    viewer.game.do("mousedown", 1)
    for _ in range(10):
        viewer.game.do("mousemove_relative", "--", 8, 0)
        time.sleep(0.05)
    viewer.game.do("mouseup", 1)
    viewer.seen(lambda rows: not same(rows, before), "dragging turns it")


def a_dropped_file_opens(viewer):
    for name in ("box.dae", "my model é.fbx", "skinned.glb"):
        viewer.drop(viewer.folder / name)
        viewer.wait_for_title(pathlib.Path(name).stem.split()[0])
        viewer.seen(lambda rows: lit(rows) > 0.03, f"{name}: the model is not in the image")


def one_that_cannot_be_read_leaves_what_was_there(viewer):
    broken = viewer.folder / "broken.fbx"
    broken.write_bytes(b"Kaydara FBX Binary  \0" + bytes(200))
    viewer.drop(broken)
    viewer.game.until_said("broken.fbx is refused")
    viewer.wait_for_title("skinned")
    share = viewer.lit()
    expect(share > 0.03, f"the model before is still there: {share:.3f}")
    expect(viewer.game.log().count("broken.fbx is refused") == 1, viewer.game.log())


def a_saved_model_shows_anew(viewer):
    file = viewer.folder / "skinned.glb"
    thick = viewer.lit()
    file.write_bytes(model_files.colored_glb((0.1, 1.5, 0.1)))
    viewer.seen(lambda rows: lit(rows) < thick / 2, f"{thick:.3f} before, and no less after the save")
    # A fault is said until the next good save, other messages for some seconds only.
    good = file.read_bytes()
    written = []
    for content in (good, b"glTF, half of it", good):
        file.write_bytes(content)
        time.sleep(9)  # a line of 100 letters stands for 8
        rows = viewer.image()
        written.append(sum(max(pixel) < 130 for row in rows[330:450] for pixel in row))
        expect(any(max(pixel) - min(pixel) > 90 for row in upper(rows) for pixel in row), "the model of the last good save is there")
    expect(written[1] > max(written[0], written[2]) + 1500, f"so many pixels have a message behind them: {written}")


def main():
    with virtual_screen() as screen, home() as folder:
        model_files.write_all(folder)
        (folder / "my model é.fbx").write_bytes(model_files.fbx())
        viewer = Viewer(screen, folder)
        try:
            aids_draw_what_they_promise(viewer)
            dragging_turns_the_model_and_the_wheel_zooms(viewer)
            a_dropped_file_opens(viewer)
            one_that_cannot_be_read_leaves_what_was_there(viewer)
            a_saved_model_shows_anew(viewer)
            expect(viewer.game.process.poll() is None, "it ended:\n" + viewer.game.log())
        finally:
            viewer.game.stop()


main()
