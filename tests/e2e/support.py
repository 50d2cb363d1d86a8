"""What the end-to-end tests share: a virtual screen, a program on it, keys and mouse."""
import contextlib
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import time

# Who runs a test as a script's background job ignores SIGINT, and so would the program.
signal.signal(signal.SIGINT, signal.default_int_handler)


@contextlib.contextmanager
def virtual_screen(size="1280x720"):
    """A fresh Xvfb of its own (a window manager that died there would leave traces); yields the
    environment for programs on it."""
    read_end, write_end = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write_end), "-screen", "0", size + "x24", "-noreset", "-nolisten", "tcp"],
        pass_fds=[write_end], stderr=subprocess.DEVNULL)
    os.close(write_end)
    with os.fdopen(read_end) as pipe:
        display = ":" + pipe.readline().strip()
    try:
        yield {**os.environ, "DISPLAY": display}
    finally:
        server.terminate()
        server.wait()


@contextlib.contextmanager
def home():
    """An empty home: no settings, no saves of the person who runs the test."""
    # A driver that was killed just now may still write its cache while the folder goes.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        yield pathlib.Path(folder)


FRAMES_A_SECOND = 20  # at most: software rendering at full speed leaves no core to others


def app_settings(text=""):
    """What app.toml says: the usual cap of frames, then `text`."""
    return f"format = 1\n[window]\nmax_fps = {FRAMES_A_SECOND}\n{text}"


def settings_in(folder, environment):
    """The environment with every XDG folder below `folder`, the usual settings there, and silent OpenAL."""
    settings = folder / "config/plumbline/app.toml"
    settings.parent.mkdir(parents=True, exist_ok=True)
    if not settings.exists():
        settings.write_text(app_settings())
    return {**environment, "HOME": str(folder), "XDG_CONFIG_HOME": str(folder / "config"),
            "XDG_DATA_HOME": str(folder / "data"), "ALSOFT_DRIVERS": "null"}


class Recording:
    """A file of `play --record` (engine/app/controls/action_tape.h): its scene, the actions that it tells of, those that are
    held at its end, whether there is a pointer in it, and whether its end is there."""
    HEADER, STEP, END = 0, 1, 4

    def __init__(self, path):
        self.scene, self.told, self.held, self.has_pointer, self.whole = "", set(), set(), False, False
        names, data = [], pathlib.Path(path).read_bytes()
        expect(data.startswith(b"PLUMTAPE"), f"{path} is no recording: {data[:20]}")
        at = 12
        while at + 16 <= len(data):
            size = int.from_bytes(data[at:at + 4], "little")
            body = data[at + 16:at + 16 + size]
            at += 16 + size
            if len(body) < size:
                break
            kind, rest = body[0], body[9:]
            if kind == self.HEADER:
                texts = []
                for _ in range(3):
                    length = int.from_bytes(rest[:8], "little")
                    texts.append(rest[8:8 + length].decode())
                    rest = rest[8 + length:]
                self.scene, names = texts[0], rest[24:].decode().split()
            elif kind == self.STEP:
                count = int.from_bytes(rest[:8], "little")
                for i in range(count):
                    action, held = rest[8 + 11 * i], rest[9 + 11 * i]
                    self.told.add(names[action])
                    (self.held.add if held else self.held.discard)(names[action])
                self.has_pointer |= rest[8 + 11 * count + 16] != 0
            self.whole = kind == self.END


class Program:
    """A running `plumbline play`, and what a person does to it."""

    def __init__(self, command, environment, log):
        self.environment = environment
        self.log_path = log
        self.process = subprocess.Popen(command, env=environment, stdout=open(log, "w"), stderr=subprocess.STDOUT)
        self.window = self._wait_for_window()

    def until(self, condition, what, seconds=30):
        """What `condition` gives as soon as it gives something; only a program that runs can reach it."""
        end_s = time.monotonic() + seconds
        while True:
            value = condition()
            if value:
                return value
            expect(self.process.poll() is None, f"{what}: the program ended early:\n{self.log()}")
            expect(time.monotonic() < end_s, f"{what}: not within {seconds} s\n{self.log()}")
            time.sleep(0.05)

    def until_said(self, text, times=1, seconds=30):
        self.until(lambda: self.log().count(text) >= times, f"\"{text}\" was not said {times} times", seconds)

    def window_named(self, words):
        """A window that shows: one that does not cannot take the focus."""
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", words], env=self.environment,
                               capture_output=True, text=True).stdout.split()
        return found[-1] if found else None

    def _wait_for_window(self):
        # While the scene is read the title is the program's name alone, and keys go nowhere.
        return self.until(lambda: self.window_named(" - Plumbline"), "no window")

    def focus(self):
        self.do("windowfocus", self.window)

    def ready(self, shots):
        """Has the focus and draws frames: a key that is pressed before the first of them may be lost."""
        self.focus()
        before, pressed_s = set(shots.glob("*.png")), -10.0

        def is_drawn():
            nonlocal pressed_s
            if time.monotonic() - pressed_s > 2:
                self.do("key", "F12")
                pressed_s = time.monotonic()
            return set(shots.glob("*.png")) - before
        self.until(is_drawn, "no frame is drawn")

    def log(self):
        return pathlib.Path(self.log_path).read_text()

    def do(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True)

    def press(self, key, times=1, pause_s=0.1):
        """Every press counts, in however few frames they are seen."""
        for _ in range(times):
            self.do("key", key)
            time.sleep(pause_s)

    def hold(self, key, seconds):
        self.do("keydown", key)
        time.sleep(seconds)
        self.do("keyup", key)

    def screenshot(self, shots):
        """Presses F12; the file of what the program saved of its own screen in the folder `shots`."""
        before = set(shots.glob("*.png"))
        self.do("key", "F12")
        return self.until(lambda: set(shots.glob("*.png")) - before, "no screenshot").pop()

    def image(self, path):
        subprocess.run(["import", "-window", "root", str(path)], env=self.environment, check=False)

    def wait(self, timeout_s):
        return self.process.wait(timeout=timeout_s)

    def stop(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()


def read_json(path):
    return json.loads(pathlib.Path(path).read_text())


def expect(condition, message):
    if not condition:
        raise AssertionError(message)
