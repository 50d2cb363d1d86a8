"""What the end-to-end tests share: a virtual screen, a program on it, keys and mouse."""
import contextlib
import json
import os
import pathlib
import subprocess
import tempfile
import time


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
    with tempfile.TemporaryDirectory() as folder:
        yield pathlib.Path(folder)


def settings_in(folder, environment):
    """The environment with every XDG folder below `folder`, and silent OpenAL."""
    return {**environment, "HOME": str(folder), "XDG_CONFIG_HOME": str(folder / "config"),
            "XDG_DATA_HOME": str(folder / "data"), "ALSOFT_DRIVERS": "null"}


class Program:
    """A running `plumbline play`, and what a person does to it."""

    def __init__(self, command, environment, log):
        self.environment = environment
        self.log_path = log
        self.process = subprocess.Popen(command, env=environment, stdout=open(log, "w"), stderr=subprocess.STDOUT)
        self.window = self._wait_for_window()

    def _wait_for_window(self):
        for _ in range(300):
            if self.process.poll() is not None:
                raise AssertionError("the program ended early:\n" + self.log())
            # A window that does not show yet cannot take the focus.
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Plumbline"], env=self.environment,
                                   capture_output=True, text=True).stdout.split()
            if found:
                return found[-1]
            time.sleep(0.1)
        raise AssertionError("no window within 30 s:\n" + self.log())

    def log(self):
        return pathlib.Path(self.log_path).read_text()

    def do(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True)

    def press(self, key, times=1, pause_s=0.25):
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
        self.press("F12")
        for _ in range(200):
            new = set(shots.glob("*.png")) - before
            if new:
                return new.pop()
            time.sleep(0.1)
        raise AssertionError("no screenshot within 20 s:\n" + self.log())

    def picture(self, path):
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
