#!/usr/bin/env python3
"""The menu as a person uses it: the start page, Enter, a setting and a key changed by pressing it,
kept over a restart and over a kill, another scene opened from it. EXPERIENCE D16."""
import pathlib
import signal
import subprocess
import sys
import time

from support import Program, Recording, expect, home, read_json, settings_in, virtual_screen

program_file = sys.argv[1]


def start(folder, environment, *words):
    game = Program([program_file, "play", *words, "--size", "640x360"], environment, folder / "log.txt")
    game.focus()
    time.sleep(0.5)
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
    time.sleep(0.4)


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
    """Controls, the first action: forward. I in the place of W."""
    game = start(folder, environment, "falling_cube")
    try:
        press(game, "Escape", "Down", "Down", "Down", "Down", "Return")
        press(game, "Down", "Down", "Return", "i")
        wait_for(folder / "config/plumbline/bindings.ui.toml", 'forward = ["i", "up", "pad.left_y-"]', "bound")
        game.process.send_signal(signal.SIGKILL)
        game.wait(10)
    finally:
        game.stop()
    wait_for(folder / "config/plumbline/app.ui.toml", 'level = "low"', "kept over the next session")
    shown = controls(environment)
    expect("bindings.ui.toml:" in shown.split("forward =")[1].split("\n")[0], shown)
    expect("bindings.ui.toml" not in controls(environment, "--safe"), "--safe reads nobody's files")


def play_with_it(folder, environment):
    report = folder / "report.json"
    game = start(folder, environment, "falling_cube", "--report", str(report))
    try:
        game.press("i", 2)
        game.press("w")
        press(game, "Escape", "Up", *7 * ["Down"], "Return")  # Quit
        expect(game.wait(20) == 0, game.log())
    finally:
        game.stop()
    seen = read_json(report)["actions_seen"]
    expect(seen.get("forward") == 2, f"forward: {seen.get('forward')}, K was pressed twice")


QUIT = ("Escape", *7 * ["Down"], "Return")
OTHER_SCENES = ("Escape", "Down", "Down", "Return")


def start_page_and_other_scenes(folder, environment):
    """The report tells of each scene; the recording is of the first in which time went on."""
    report = folder / "scenes.json"
    tape = folder / "scenes.tape"
    # No scene: the last one behind the start page, where time stands still.
    game = start(folder, environment, "--report", str(report), "--record", str(tape))
    try:
        last = folder / "data/plumbline/last_scene"
        wait_for(last, "falling_cube.toml", "the last scene")
        # The cards stand below the buttons, four in a row: the garden, games, cans, cloth; fairground, falling_cube, joints.
        press(game, "Down", "Down", "Right", "Right", "Return")
        wait_for(last, "joints.toml", "opened from the menu")
        game.until(lambda: game.window_named("^Joints - "), "its title")
        time.sleep(1)
        press(game, *OTHER_SCENES)
        press(game, "Down", "Down", "Right", "Return")
        wait_for(last, "falling_cube.toml", "opened from the menu of a running scene")
        game.until(lambda: game.window_named("^Falling cube - "), "its title")
        time.sleep(1)
        press(game, *QUIT)
        expect(game.wait(20) == 0, game.log())
    finally:
        game.stop()
    of_last = read_json(report)
    of_joints = of_last["before"]
    of_first = of_joints["before"]
    shown = [each["scene"] for each in (of_last, of_joints, of_first)]
    expect(shown == ["falling_cube.toml", "joints.toml", "falling_cube.toml"] and "before" not in of_first, shown)
    steps = [each["physics"]["cpu_ms_total"] > 0 for each in (of_last, of_joints, of_first)]
    expect(steps == [True, True, False], f"scenes in which steps ran: {steps}")
    expect(all(each["frames"] > 1 and each["startup_ms"] > 0 for each in (of_last, of_joints, of_first)), of_last)
    expect(of_joints["startup_ms"] < 10_000, "counted from the start of the program")
    expect(Recording(tape).scene == "joints.toml", "the recording is of another scene")
    expect("a recording is of one scene" in game.log(), game.log())
    again = subprocess.run([program_file, "play", "joints", "--size", "320x180", "--no-sound", "--replay", str(tape)],
                           env=environment, capture_output=True, text=True, timeout=120)
    expect(again.returncode == 0, f"replay: exit {again.returncode}\n{again.stderr}")


CUBE = """[scene]
title = "{}"
[[entity]]
name = "cube"
position_m = [0, 5, 0]
primitive = {{ box = [1, 1, 1] }}
[entity.body]
kind = "{}"
"""


def a_scene_that_is_refused(folder, environment):
    """What runs goes on, and its report is as if nothing had been."""
    data = folder / "own"
    (data / "assets/scenes").mkdir(parents=True)
    for name in ("shaders", "config"):
        (data / name).symlink_to(pathlib.Path(name).absolute())
    (data / "assets/scenes/a.toml").write_text(CUBE.format("a", "dynamic"))
    (data / "assets/scenes/b.toml").write_text(CUBE.format("b", "dynamo"))
    report = folder / "refused.json"
    game = start(folder, {**environment, "PLUMBLINE_DATA": str(data)}, "a", "--report", str(report))
    try:
        press(game, *OTHER_SCENES)
        press(game, "Down", "Right", "Return")
        game.until_said("b.toml")
        press(game, "Escape", "Escape")
        press(game, *QUIT)
        expect(game.wait(20) == 0, game.log())
    finally:
        game.stop()
    told = read_json(report)
    expect(told["scene"] == "a.toml" and "before" not in told and told["bodies"] == 1, told)


def nowhere_to_write(folder, environment):
    """A file stands where the settings' folder would be: not even root can make that."""
    blocked = folder / "blocked"
    blocked.write_text("a file")
    game = start(folder, {**environment, "XDG_CONFIG_HOME": str(blocked)}, "falling_cube")
    try:
        press(game, "Escape", "Down", "Down", "Down", "Return")
        press(game, "Down", "Right", "Return")
        press(game, "Escape", "Escape")
        press(game, *QUIT)
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
        start_page_and_other_scenes(folder, environment)
        a_scene_that_is_refused(folder, environment)
        nowhere_to_write(folder, environment)


main()
