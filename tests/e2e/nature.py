#!/usr/bin/env python3
"""The garden report's rows, tried by their keys in a window: `nature`, and the small game `cans`.
SOURCES B8 to B26, B36."""
import math
import os
import pathlib
import shutil
import sys
import time

from png import read_png
from support import Program, expect, home, read_json, settings_in, virtual_screen

program_file = sys.argv[1]
images = os.environ.get("PL_E2E_IMAGES")  # a folder: keeps what was on the screen

RECORDED = "recording the camera path"


class Scene:
    """A scene in a window, images of it, and ways of its camera."""

    def __init__(self, screen, folder, scene):
        self.data = folder / "data" / "plumbline"
        self.name = pathlib.Path(scene).stem
        self.report = folder / f"{self.name}.json"
        self.game = Program([program_file, "play", scene, "--size", "640x360", "--level", "low", "--report", str(self.report)],
                            settings_in(folder, screen), folder / f"{self.name}.txt")
        self.game.ready(self.data / "shots")

    def image(self, name):
        """What the program saves of its own screen, in rows of (r, g, b)."""
        file = self.game.screenshot(self.data / "shots")
        if images:
            shutil.copy(file, pathlib.Path(images) / f"{self.name}_{name}.png")
        return read_png(file)

    def seen(self, name, condition, message):
        """The first image that is as wanted: shaders that nobody has compiled yet come one a frame."""
        def look():
            rows = self.image(name)
            return rows if condition(rows) else None
        return self.game.until(look, message)

    def at_rest(self, name, condition=lambda _: True, message="it does not come to rest", rest_s=1):
        """The same, once the image has stayed for so long."""
        first, since_s = self.seen(name, condition, message), time.monotonic()

        def stays(rows):
            nonlocal first, since_s
            if difference(first, rows) > 0.8 or not condition(rows):
                first, since_s = rows, time.monotonic()
            return time.monotonic() - since_s > rest_s
        return self.seen(name, stays, message)

    def way(self, doing):
        """The poses (time, place, quaternion) of the camera while something is done."""
        file = self.data / "camera_paths" / f"{self.name}.path"
        file.unlink(missing_ok=True)
        ways = self.game.log().count(RECORDED)
        self.game.press("KP_0")
        self.game.until_said(RECORDED, ways + 1)
        self.game.screenshot(self.data / "shots")  # a frame before it, and one after
        doing()
        time.sleep(0.3)
        self.game.screenshot(self.data / "shots")
        self.game.press("KP_0")
        self.game.until(file.exists, "no camera path")
        lines = file.read_text().splitlines()
        poses = [[float(word) for word in line.split()] for line in lines if line[0].isdigit()]
        return [(pose[0], pose[1:4], pose[4:8]) for pose in poses]

    def end(self):
        self.game.process.terminate()
        self.game.wait(30)
        return read_json(self.report)


def scenery(rows):
    """What no message is written over and no sail passes: the upper left part, below the corner."""
    return [pixel for row in rows[40:200] for pixel in row[20:440]]


def mean(rows):
    pixels = scenery(rows)
    return [sum(pixel[i] for pixel in pixels) / len(pixels) for i in range(3)]


def spread(rows):
    """How far the pixels' green is from its mean, on average."""
    middle, pixels = mean(rows)[1], scenery(rows)
    return sum(abs(pixel[1] - middle) for pixel in pixels) / len(pixels)


def difference(a, b):
    pairs = list(zip(scenery(a), scenery(b)))
    return sum(abs(p[i] - q[i]) for p, q in pairs for i in range(3)) / (3 * len(pairs))


def yaw(pose):
    w, x, y, z = pose[2]
    return math.degrees(2 * math.atan2(y, w))


def turned(way):
    """Degrees to the left."""
    return (yaw(way[-1]) - yaw(way[0]) + 180) % 360 - 180


def fastest(way):
    """The highest speed over the ground in half a second, m/s: who begins to walk in the air falls first."""
    level = [(time_s, (place[0], place[2])) for time_s, place, _ in way]
    return max(math.dist(a[1], b[1]) / (b[0] - a[0]) for a in level for b in level if 0.4 < b[0] - a[0] < 0.6)


def lands(scene):
    """Waits until whoever began to walk in the air has fallen to the ground: a slow machine takes longer for it."""
    def falls_no_more():
        way = scene.way(lambda: time.sleep(0.3))
        return len(way) > 2 and abs(way[-1][1][1] - way[0][1][1]) < 1e-3
    scene.game.until(falls_no_more, "it falls for ever")


def starts_as_the_report(scene):
    scene.image("start")
    still = scene.way(lambda: time.sleep(0.5))
    place = still[0][1]
    expect(math.dist(place, (9.81, 3.01, -20.23)) < 1e-3, f"the camera starts at {place}")


def moves_and_turns(scene):
    ahead = scene.way(lambda: scene.game.hold("w", 2))
    gone = [b - a for a, b in zip(ahead[0][1], ahead[-1][1])]
    expect(gone[0] < -1 and gone[2] > 2, f"W goes towards the origin: {gone}")
    back = scene.way(lambda: scene.game.hold("Down", 2))
    expect(back[-1][1][2] < back[0][1][2] - 2, "so does the arrow down, backwards")
    expect(turned(scene.way(lambda: scene.game.hold("q", 1))) > 40, "Q turns to the left")
    expect(turned(scene.way(lambda: scene.game.hold("e", 1))) < -40, "E turns to the right")
    slow = fastest(scene.way(lambda: scene.game.hold("w", 1.5)))
    scene.game.hold("s", 1.5)
    for _ in range(3):
        scene.game.do("click", 4)
        time.sleep(0.3)  # not all in one frame: one that takes too long drops what came in it
    fast = fastest(scene.way(lambda: scene.game.hold("w", 1.5)))
    scene.game.hold("s", 1.5)
    expect(1.6 < fast / slow < 2.4, f"three notches of the wheel: {slow:.2f}, then {fast:.2f} m/s")
    scene.image("moved")


def walks_and_orbits(scene):
    """U: past orbiting to walking, from where the scene starts; then flying, and orbiting what is seen."""
    scene.game.press("u", 2)
    lands(scene)
    slow = scene.way(lambda: scene.game.hold("w", 0.9))
    expect(abs(slow[-1][1][1] - 1.65) < 0.15, f"eyes are {slow[-1][1][1]:.2f} m over the lawn, at {slow[-1][1]}")
    scene.image("walking")
    scene.game.hold("s", 2.5)  # far enough back for the fast way: the house is near
    for _ in range(3):
        scene.game.do("click", 4)
        time.sleep(0.3)  # not all in one frame: one that takes too long drops what came in it
    fast = scene.way(lambda: scene.game.hold("w", 0.9))
    expect(1.5 < fastest(fast) / fastest(slow) < 2.5, f"three notches: {fastest(slow):.2f}, then {fastest(fast):.2f} m/s")
    scene.game.hold("s", 1.5)
    scene.game.press("u")
    scene.game.hold("c", 1)
    expect(scene.way(lambda: time.sleep(0.5))[-1][1][1] > 2.5, "C goes up in flight")
    scene.game.press("u")
    around = scene.way(lambda: scene.game.hold("e", 1))
    expect(math.dist(around[0][1], around[-1][1]) > 1, "E goes round what is seen")


def shows_wires_and_points(scene):
    filled = scene.at_rest("filled")
    scene.game.press("m")
    wires = scene.at_rest("wires_m", lambda rows: difference(filled, rows) > 8, "M shows wires")
    scene.game.press("v")
    scene.seen("points_v", lambda rows: difference(rows, wires) > 4, "V shows points")
    scene.game.press("n")
    scene.seen("filled_n", lambda rows: difference(filled, rows) < 3, "N fills again")


def fog_grows_denser(scene):
    clear = scene.at_rest("fog_off")
    scene.game.press("f")
    for _ in range(3):  # before the last shader is there some things stand without fog
        foggy = scene.at_rest("fog_on_f", lambda rows: difference(clear, rows) > 4, "F brings fog")
        scene.game.press("KP_Multiply", 4)
        scene.seen("fog_denser", lambda rows: spread(rows) < 0.8 * spread(foggy), f"denser fog levels all, more than {spread(foggy):.1f}")
        scene.game.press("KP_Divide", 4)
        thinner = scene.at_rest("fog_thinner")
        if difference(thinner, foggy) < 3:
            break
    expect(difference(thinner, foggy) < 3, f"and thinner again: {difference(thinner, foggy):.1f}")
    scene.game.press("KP_Decimal", 4)
    scene.seen("fog_evening", lambda rows: mean(rows)[0] > mean(rows)[2], "the fifth colour is an evening's")
    scene.game.press("KP_Decimal", 2)
    scene.game.press("f")
    scene.seen("fog_off_again", lambda rows: difference(clear, rows) < 3, "F takes it away")


def turns_the_sun(scene):
    noon = scene.at_rest("sun")
    scene.game.press("j", 2)
    began_s = time.monotonic()
    scene.seen("sun_turns", lambda rows: difference(noon, rows) > 2, "J turns the sun")
    turned_s = time.monotonic() - began_s
    scene.game.press("l")
    later = scene.at_rest("sun_turned_j")
    time.sleep(turned_s)
    expect(difference(later, scene.image("sun_stopped_l")) < 1.5, "L stops it")


def dims_the_light(scene):
    before = sum(mean(scene.at_rest("light")))
    scene.game.press("KP_Subtract", 6)
    scene.seen("light_minus", lambda rows: sum(mean(rows)) < 0.75 * before, f"keypad -: not darker than {before:.0f}")


def switches_the_flashlight(scene):
    """In the dusk that dims_the_light left, on the fence: beside it are the spotlight and the sails."""

    def difference_on_fence(a, b):
        pairs = [(p, q) for rows in zip(a[205:245], b[205:245]) for p, q in zip(rows[0][300:420], rows[1][300:420])]
        return sum(abs(p[i] - q[i]) for p, q in pairs for i in range(3)) / (3 * len(pairs))

    scene.game.press("KP_Subtract", 8)
    dark = scene.at_rest("dusk")
    for key in "yp":
        scene.game.press(key)
        scene.seen(f"flashlight_{key}", lambda rows: difference_on_fence(dark, rows) > 2, f"{key} switches the flashlight on")
        scene.game.press(key)
        scene.seen(f"flashlight_{key}_off", lambda rows: difference_on_fence(dark, rows) < 0.4, f"{key} switches it off")


def aims_the_spotlight(scene):
    before = scene.at_rest("spot")
    scene.game.do("keydown", "1")
    for _ in range(10):
        scene.game.do("mousemove_relative", "--", 6, 4)
    scene.seen("spot_aimed_1", lambda rows: difference(before, rows) > 0.4, "1 and the mouse aim the spotlight")
    scene.game.do("keyup", "1")
    scene.game.press("KP_Add", 14)


def records_and_plays_the_camera(scene):
    def fly():
        scene.game.hold("w", 1.5)
        scene.game.hold("q", 1)
    recorded = scene.way(fly)
    expect(len(recorded) > 8 and recorded[-1][0] > 2.5, f"{len(recorded)} poses in {recorded[-1][0]:.1f} s")
    there = scene.at_rest("way_end")
    scene.game.press("space")
    began_s = time.monotonic()
    scene.seen("way_plays", lambda rows: difference(there, rows) > 2, "the image is taken from the way")
    scene.seen("way_over", lambda rows: difference(there, rows) < 3, "and from where one is, when it is over")
    expect(time.monotonic() - began_s > 0.5 * recorded[-1][0], "it was over too soon")
    file = scene.data / "camera_paths" / "nature.path"
    file.write_text("plumbline camera path 1\n0 1 2\n")
    scene.game.press("r")
    scene.game.until_said("nature.path:2: 3 numbers; expected 8 numbers")
    scene.image("way_fault")
    # The report's own kind of file: half a second high above, looking down.
    file.write_text("0.1 -1 0.1 0 25 0\n" * 600)
    scene.game.press("r")
    scene.game.until_said("camera path loaded (10.0 s)")
    scene.game.press("space")
    scene.seen("way_of_the_report", lambda rows: difference(there, rows) > 10, "it is seen from above")


def the_game_is_won_and_lost(screen, folder):
    easy = folder / "easy.toml"
    easy.write_text('[scene]\nbase = "cans.toml"\n[player]\nyaw_deg = 5.3\npitch_deg = -1\n[goal]\ncount = 2\n')
    scene = Scene(screen, folder, str(easy))

    def green(rows):
        return sum(pixel[1] > pixel[0] + 30 and pixel[1] > pixel[2] + 30 for row in rows[:110] for pixel in row[:260])

    def red(rows):
        return sum(pixel[0] > pixel[1] + 60 and pixel[0] > pixel[2] + 60 for row in rows[:110] for pixel in row[:260])

    expect(green(scene.image("start")) < 10, "nothing is won yet")
    for _ in range(6):
        if green(scene.image("playing")) > 30:
            break
        scene.game.do("mousedown", 1)
        time.sleep(1.5)
        scene.game.do("mouseup", 1)
        time.sleep(2)  # it flies, and they fall
    scene.seen("won", lambda rows: green(rows) > 30, "it says that it is won, in green")
    scene.game.press("r")
    scene.seen("again", lambda rows: green(rows) < 10, "and no more after the next start")
    scene.end()
    scene = Scene(screen, folder, "cans")
    expect(red(scene.image("begins")) < 10, "nothing is lost yet")
    scene.game.do("mousemove_relative", "--", 900, 0)
    for _ in range(14):
        scene.game.do("click", 1)
        time.sleep(0.2)
    scene.seen("lost", lambda rows: red(rows) > 30, "it says that it is lost, in red")
    scene.end()


def main():
    with virtual_screen("640x360") as screen, home() as folder:
        seen = set()
        # Each from the start: where moving has led depends on how fast the machine draws.
        for doings in ((starts_as_the_report, moves_and_turns),
                       (shows_wires_and_points, fog_grows_denser, turns_the_sun, dims_the_light, switches_the_flashlight,
                        aims_the_spotlight, records_and_plays_the_camera),
                       (walks_and_orbits,)):
            scene = Scene(screen, folder, "nature")
            try:
                for doing in doings:
                    doing(scene)
                seen |= {action for action, count in scene.end()["actions_seen"].items() if count > 0}
            finally:
                scene.game.stop()
        for action in ("camera_record", "camera_play", "camera_reload", "aim_spot", "fog_denser", "flashlight", "push"):
            expect(action in seen, f"{action} was seen: {seen}")
        the_game_is_won_and_lost(screen, folder)


main()
