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
    """A window with a model in it, and pictures of it."""

    def __init__(self, screen, folder):
        self.folder, self.environment = folder, settings_in(folder, screen)
        self.shots = folder / "data" / "plumbline" / "shots"
        self.game = Program([program_file, "play", str(folder / "colored.glb"), "--size", "640x480", "--level", "high"],
                            self.environment, folder / "log.txt")
        self.wait_for_title("colored")
        self.game.do("windowfocus", self.game.window)
        time.sleep(2)

    def wait_for_title(self, words):
        for _ in range(300):
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", words], env=self.environment,
                                   capture_output=True, text=True).stdout.split()
            if found:
                self.game.window = found[-1]
                return
            time.sleep(0.1)
        raise AssertionError(f"no window \"{words}\" within 30 s:\n" + self.game.log())

    def drop(self, file):
        subprocess.run([sys.executable, str(pathlib.Path(__file__).with_name("drop_file.py")), self.game.window, str(file)],
                       env=self.environment, check=True, timeout=90)

    def press(self, key):
        self.game.press(key, 1, 0.6)

    def picture(self):
        return read_png(self.game.screenshot(self.shots))

    def lit(self):
        """The share of pixels with a colour, which all but the model lack."""
        rows = upper(self.picture())
        strong = [pixel for row in rows for pixel in row if max(pixel) - min(pixel) > 90]
        return len(strong) / (len(rows) * len(rows[0])), rows


def upper(rows):
    """What no message is written over."""
    return rows[:330]


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
    share, _ = viewer.lit()
    plain = viewer.picture()
    expect(share > 0.05, f"the model is {share:.3f} of the picture")
    expect(corner(plain) != foot(plain), "the ground is no background")
    viewer.press("F10")
    without = viewer.picture()
    expect(foot(without) == corner(without), f"without ground: {foot(without)} below, {corner(without)} above")
    viewer.press("F2")
    white = viewer.picture()
    expect(corner(white) == (255, 255, 255), f"the second background is {corner(white)}")
    bluish = lambda pixel: pixel[2] > 200 and pixel[0] < 120 and 80 < pixel[1] < 190
    before = count(white, bluish)
    viewer.press("alt+n")
    normals = viewer.picture()
    expect(count(normals, bluish) > before + 6, "normals are drawn")
    viewer.press("alt+n")
    expect(same(viewer.picture(), white), "and go away")
    grey = lambda pixel: max(pixel) - min(pixel) < 6 and 60 < pixel[0] < 215
    before = count(white, grey)
    viewer.press("alt+g")
    expect(count(viewer.picture(), grey) > before + 200, "the grid is drawn")
    viewer.press("alt+g")
    viewer.press("alt+x")
    expect(not same(viewer.picture(), white), "axes are drawn")
    viewer.press("alt+x")
    viewer.press("v")
    expect(viewer.lit()[0] < 0.6 * share, "of a wireframe one sees through most")
    viewer.press("v")
    expect(same(viewer.picture(), white), "everything is as it was")
    viewer.press("alt+t")
    first = viewer.picture()
    time.sleep(1)
    expect(not same(viewer.picture(), first), "the turntable turns")
    viewer.press("alt+t")


def dragging_turns_the_model_and_the_wheel_zooms(viewer):
    first, _ = viewer.lit()
    viewer.game.do("mousemove", "--window", viewer.game.window, 200, 130)
    for _ in range(4):
        viewer.game.do("click", 4)
        time.sleep(0.1)
    time.sleep(1)
    nearer, before = viewer.lit()
    expect(nearer > 1.4 * first, f"the wheel zooms: {first:.3f}, then {nearer:.3f}")
    viewer.game.do("mousedown", 1)
    for _ in range(10):
        viewer.game.do("mousemove_relative", "--", 8, 0)
        time.sleep(0.05)
    viewer.game.do("mouseup", 1)
    time.sleep(0.5)
    expect(upper(viewer.picture()) != before, "dragging turns it")


def a_dropped_file_opens(viewer):
    for name in ("box.dae", "my model é.fbx", "skinned.glb"):
        viewer.drop(viewer.folder / name)
        viewer.wait_for_title(pathlib.Path(name).stem.split()[0])
        time.sleep(1)
        share, _ = viewer.lit()
        expect(share > 0.03, f"{name}: {share:.3f} of the picture is the model")


def one_that_cannot_be_read_leaves_what_was_there(viewer):
    broken = viewer.folder / "broken.fbx"
    broken.write_bytes(b"Kaydara FBX Binary  \0" + bytes(200))
    viewer.drop(broken)
    time.sleep(3)
    viewer.wait_for_title("skinned")
    expect(viewer.game.log().count("broken.fbx is refused") == 1, viewer.game.log())
    expect(viewer.lit()[0] > 0.03, "the model before is still there")


def a_saved_model_shows_anew(viewer):
    file = viewer.folder / "skinned.glb"
    thick, _ = viewer.lit()
    file.write_bytes(model_files.colored_glb((0.1, 1.5, 0.1)))
    for _ in range(100):
        thin, _ = viewer.lit()
        if thin < thick / 2:
            break
        time.sleep(0.2)
    expect(thin < thick / 2, f"{thick:.3f} before, {thin:.3f} after the save")
    # A fault is said until the next good save, other messages for some seconds only.
    good = file.read_bytes()
    written = []
    for content in (good, b"glTF, half of it", good):
        file.write_bytes(content)
        time.sleep(12)
        rows = viewer.picture()
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
            viewer.game.press("Escape")
            time.sleep(1)
        finally:
            viewer.game.stop()


main()
