#!/usr/bin/env python3
"""The menu as a person uses it: the start page, Enter, a setting and a key changed by pressing it,
kept over a restart and over a kill, another scene opened from it. EXPERIENCE D16."""
import signal
import subprocess
import sys
import time

from support import Program, expect, home, read_json, settings_in, virtual_screen

program_file = sys.argv[1]


def start(folder, environment, *words):
    game = Program([program_file, "play", *words, "--size", "640x360"], environment, folder / "log.txt")
    game.do("windowfocus", game.window)
    time.sleep(2)
    return game


def wait_for(path, text, what):
    for _ in range(100):
        if path.exists() and text in path.read_text():
            return
        time.sleep(0.1)
    raise AssertionError(f"{what}: {path} has no {text!r}: {path.read_text() if path.exists() else 'no file'}")


def press(game, *keys):
    """All of them at once, quicker than frames are drawn."""
    game.do("key", "--delay", 15, *keys)
    time.sleep(0.8)


def change_a_setting_and_be_killed(folder, environment):
    game = start(folder, environment, "falling_cube")
    try:
        # The menu, down to Settings, and Enter; down to the level, right to "low", and Enter.
        press(game, "Escape", "Down", "Down", "Down", "Return")
        press(game, "Down", "Right", "Return")
        wait_for(folder / "config/plumbline/app.ui.toml", 'level = "low"', "stored at once")
        game.process.send_signal(signal.SIGKILL)
        game.wait(10)
    finally:
        game.stop()


def controls(environment, *words):
    return subprocess.run([program_file, "controls", *words], env=environment, capture_output=True, text=True).stdout


def bind_a_key(folder, environment):
    """Controls, the first action: forward. K in the place of W."""
    game = start(folder, environment, "falling_cube")
    try:
        press(game, "Escape", "Down", "Down", "Down", "Down", "Return")
        press(game, "Down", "Down", "Return", "k")
        wait_for(folder / "config/plumbline/bindings.ui.toml", 'forward = ["k", "up", "pad.left_y-"]', "bound")
        game.process.send_signal(signal.SIGKILL)
        game.wait(10)
    finally:
        game.stop()
    wait_for(folder / "config/plumbline/app.ui.toml", 'level = "low"', "kept over the next sitting")
    shown = controls(environment)
    expect("bindings.ui.toml:" in shown.split("forward =")[1].split("\n")[0], shown)
    expect("bindings.ui.toml" not in controls(environment, "--safe"), "--safe reads nobody's files")


def play_with_it(folder, environment):
    report = folder / "report.json"
    game = start(folder, environment, "falling_cube", "--report", str(report))
    try:
        game.press("k", 2)
        game.press("w")
        press(game, "Escape", "Up", "Down", "Down", "Down", "Down", "Down", "Down", "Return")  # Quit
        expect(game.wait(20) == 0, game.log())
    finally:
        game.stop()
    seen = read_json(report)["actions_seen"]
    expect(seen.get("forward") == 2, f"forward: {seen.get('forward')}, K was pressed twice")


def start_page_and_another_scene(folder, environment):
    game = start(folder, environment)  # no scene: the last one behind the start page
    try:
        last = folder / "data/plumbline/last_scene"
        wait_for(last, "falling_cube.toml", "the last scene")
        # The cards stand below the buttons; the first row holds falling_cube, the garden, joints.
        press(game, "Down", "Right", "Right", "Return")
        wait_for(last, "joints.toml", "opened from the menu")
        time.sleep(2)
        game.do("windowfocus", game.window)
        press(game, "Escape", "Down", "Down", "Down", "Down", "Down", "Down", "Return")
        expect(game.wait(20) == 0, game.log())
    finally:
        game.stop()


def nowhere_to_write(folder, environment):
    """A file stands where the settings' folder would be: not even root can make that."""
    blocked = folder / "blocked"
    blocked.write_text("a file")
    game = start(folder, {**environment, "XDG_CONFIG_HOME": str(blocked)}, "falling_cube")
    try:
        press(game, "Escape", "Down", "Down", "Down", "Return")
        press(game, "Down", "Right", "Return")
        press(game, "Escape", "Escape")
        press(game, "Escape", "Down", "Down", "Down", "Down", "Down", "Down", "Return")
        expect(game.wait(20) == 0, game.log())
    finally:
        game.stop()
    expect(blocked.read_text() == "a file", "the file was touched")


def main():
    with virtual_screen() as screen, home() as folder:
        environment = settings_in(folder, screen)
        change_a_setting_and_be_killed(folder, environment)
        bind_a_key(folder, environment)
        play_with_it(folder, environment)
        start_page_and_another_scene(folder, environment)
        nowhere_to_write(folder, environment)


main()
