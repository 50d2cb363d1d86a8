#!/usr/bin/env python3
"""Shaders that a scene may come to need are compiled ahead by a process beside the window: once, and never longer than it."""
import pathlib
import signal
import subprocess
import sys
import time

from support import Program, expect, home, settings_in, virtual_screen

program_file = sys.argv[1]


def is_running(process_id):
    """What has ended, but was not yet waited for, does not run."""
    try:
        state = pathlib.Path(f"/proc/{process_id}/stat").read_text().rpartition(")")[2].split()[0]
    except (FileNotFoundError, ProcessLookupError):
        return False
    return state != "Z"


def finished(folder):
    """Files that say which workers came to their end; those half written have a dot in front."""
    return list((folder / "cache/plumbline/shaders").glob("[!.]*"))


def workers_of(game):
    """Process ids of the children that compile."""
    found = []
    for child in pathlib.Path(f"/proc/{game.process.pid}/task/{game.process.pid}/children").read_text().split():
        words = pathlib.Path(f"/proc/{child}/cmdline")
        if words.exists() and b"shader-worker" in words.read_bytes().split(b"\0"):
            found.append(child)
    return found


def until(condition, what, game, seconds=120):
    end_s = time.monotonic() + seconds
    while time.monotonic() < end_s:
        value = condition()
        if value:
            return value
        expect(game.process.poll() is None, f"it ended:\n{game.log()}")
        time.sleep(0.05)
    raise AssertionError(f"{what}: not within {seconds} s\n{game.log()}")


def play(scene, folder, environment, name):
    return Program([program_file, "play", scene, "--size", "160x90", "--no-sound"], environment, folder / f"{name}.txt")


def a_worker_says_that_it_is_done(folder, environment):
    done = folder / "done"
    for scene, code in (("assets/scenes/falling_cube.toml", 0), ("no_such.toml", 4)):
        ran = subprocess.run([program_file, "shader-worker", scene, done], env=environment, capture_output=True, text=True,
                             timeout=240)
        expect(ran.returncode == code and done.exists() == (code == 0), f"{scene}: exit {ran.returncode}\n{ran.stderr}")
        done.unlink(missing_ok=True)


def it_runs_once_for_a_scene(folder, environment):
    game = play("falling_cube", folder, environment, "first")
    try:
        until(lambda: finished(folder), "no worker ended", game, 240)
    finally:
        game.stop()
    game = play("falling_cube", folder, environment, "second")
    try:
        time.sleep(4)
        expect(not workers_of(game), "a second worker runs")
    finally:
        game.stop()


def it_ends_with_the_window(folder, environment):
    for how in (signal.SIGTERM, signal.SIGKILL):
        game = play("garden", folder, environment, f"ended_by_{how}")
        try:
            worker = until(lambda: workers_of(game), "no worker", game)[0]
            game.process.send_signal(how)
            game.wait(20)
            end_s = time.monotonic() + 10
            while is_running(worker) and time.monotonic() < end_s:
                time.sleep(0.05)
            expect(not is_running(worker), f"after {how} the worker still runs")
        finally:
            game.stop()


def main():
    with virtual_screen() as screen, home() as folder:
        environment = {**settings_in(folder, screen), "XDG_CACHE_HOME": str(folder / "cache")}
        for test in (a_worker_says_that_it_is_done, it_runs_once_for_a_scene, it_ends_with_the_window):
            test(folder, environment)


main()
