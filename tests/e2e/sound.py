#!/usr/bin/env python3
"""What the program plays, through OpenAL's writer of wave files: heard in play, silent when muted and
while the world stands still, the same on both sides in mono."""
import array
import struct
import sys
import time

from support import Program, app_settings, expect, home, settings_in, virtual_screen

program_file = sys.argv[1]

# A loop of noise on the right of an ear that looks at it from the left, and nothing else.
SCENE = """
[scene]
title = "a stream on the right"
[player]
position_m = [0, 0, 0]
yaw_deg = 0
[[entity]]
name = "ground"
primitive = { plane = [40, 40] }
body = { kind = "static" }
[[entity]]
name = "stream"
position_m = [3, 1.6, 0]
sound = { file = "sounds/loop_fountain.ogg", gain = 1, radius_m = 60 }
"""


def samples_of(file):
    """Left and right of a wave file that its writer may not have closed, -1 to 1, and its rate."""
    data = file.read_bytes()
    at, left, right, rate, bits, is_float = 12, [], [], 0, 16, False
    while at + 8 <= len(data):
        name, size = struct.unpack("<4sI", data[at:at + 8])
        body = data[at + 8:at + 8 + size] if 0 < size <= len(data) else data[at + 8:]
        if name == b"fmt ":
            _, channels, rate, _, _, bits = struct.unpack("<HHIIHH", body[:16])
            is_float = len(body) >= 26 and body[24:26] == b"\x03\x00"
            expect(channels == 2, f"{channels} channels")
        if name == b"data":
            values = array.array("h" if bits == 16 else ("f" if is_float else "i"))
            frame = 2 * values.itemsize
            values.frombytes(body[:len(body) // frame * frame])
            scale = 1.0 if is_float else 2.0 ** (bits - 1)
            left, right = [v / scale for v in values[0::2]], [v / scale for v in values[1::2]]
            break
        at += 8 + size + size % 2
    return left, right, rate


def rms(values):
    return (sum(v * v for v in values) / max(1, len(values))) ** 0.5


class Listening:
    """A scene in a window whose sound goes into a file."""

    def __init__(self, screen, folder, settings="", conf=""):
        self.file = folder / "heard.wav"
        (folder / "alsoft.conf").write_text(f"drivers = wave\n{conf}\n[wave]\nfile = {self.file}\n")
        config = folder / "config" / "plumbline"
        config.mkdir(parents=True)
        (config / "app.toml").write_text(app_settings("[sound]\n" + settings))
        scene = folder / "stream.toml"
        scene.write_text(SCENE)
        environment = {**settings_in(folder, screen), "ALSOFT_CONF": str(folder / "alsoft.conf")}
        del environment["ALSOFT_DRIVERS"]
        self.game = Program([program_file, "play", str(scene), "--size", "320x180"], environment, folder / "log.txt")

    def latest(self, seconds):
        """What was written in the last seconds."""
        time.sleep(seconds)
        left, right, rate = samples_of(self.file)
        count = int(seconds * 0.8 * rate)
        return left[-count:], right[-count:]

    def until_heard(self):
        self.game.until(lambda: self.file.exists() and rms(samples_of(self.file)[1][-20000:]) > 0.01, "nothing is heard")

    def end(self):
        self.game.process.terminate()
        self.game.wait(30)
        return self.game.log()


def test_play(screen):
    with home() as folder:
        heard = Listening(screen, folder)
        heard.until_heard()
        left, right = heard.latest(1.5)
        expect(rms(right) > 0.01, f"the stream is heard: {rms(right)}")
        expect(rms(right) > 3 * rms(left), f"on the right: {rms(left)}, {rms(right)}")
        heard.game.focus()
        heard.game.press("Escape", 1, 1.5)
        left, right = heard.latest(1)
        expect(rms(right) < 1e-4, f"silent under the menu: {rms(right)}")
        before = len(samples_of(heard.file)[0])
        heard.game.press("Down", 1, 0.8)
        ticked = samples_of(heard.file)[1][before:]
        expect(rms(ticked) > 1e-4, "the menu ticks as its mark moves")
        heard.end()
    with home() as folder:
        heard = Listening(screen, folder, "mono = true\n")
        heard.until_heard()
        left, right = heard.latest(1.5)
        expect(rms(right) > 0.01 and abs(rms(left) / rms(right) - 1) < 0.01, f"mono: {rms(left)}, {rms(right)}")
        config = folder / "config" / "plumbline" / "app.toml"
        config.write_text(app_settings("[sound]\nmute = true\n"))
        time.sleep(2)
        left, right = heard.latest(1)
        expect(rms(right) == 0.0, f"mute: {rms(right)}")
        heard.end()


def main():
    with virtual_screen() as screen:
        test_play(screen)


main()
