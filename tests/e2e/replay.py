#!/usr/bin/env python3
"""A recording of a random session plays back bit for bit, at another frame rate; a recording of
another scene is refused."""
import subprocess
import sys
import time

from support import Recording, app_settings, expect, home, settings_in, virtual_screen

program_file = sys.argv[1]


def play(environment, *words):
    return subprocess.run([program_file, "play", *words, "--no-sound"], env=environment,
                          capture_output=True, text=True, timeout=120)


def state_of(run):
    lines = [line for line in run.stderr.splitlines() if ", state " in line]
    expect(lines, "no state line:\n" + run.stderr)
    return lines[-1].rsplit(" ", 1)[-1]


def a_killed_session_is_replayed_up_to_there(environment, folder):
    """What was recorded was on the disk only once the program ended in order."""
    tape = folder / "killed.tape"
    game = subprocess.Popen([program_file, "play", "falling_cube", "--size", "320x180", "--random-input", "7", "--no-sound",
                             "--record", str(tape)], env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end_s = time.monotonic() + 60
    while not tape.exists() or tape.stat().st_size < 5_000:
        expect(game.poll() is None and time.monotonic() < end_s, "nothing is recorded while it runs")
        time.sleep(0.05)
    game.kill()
    game.wait()
    expect(not Recording(tape).whole, "its end is there, though it was killed")
    again = play(environment, "falling_cube", "--size", "320x180", "--replay", str(tape))
    expect(again.returncode == 0, f"replay: exit {again.returncode}\n{again.stderr}")
    expect("the recording breaks off after " in again.stderr, again.stderr)


with virtual_screen() as screen, home() as folder:
    environment = settings_in(folder, screen)
    tape = str(folder / "session.tape")
    settings = folder / "config/plumbline/app.toml"
    settings.write_text("format = 1\n[window]\nmax_fps = 120\n")
    first = play(environment, "playroom", "--size", "320x180", "--random-input", "7", "--seconds", "8", "--record", tape)
    expect(first.returncode == 0, first.stderr)
    expected = state_of(first)
    settings.write_text(app_settings())
    again = play(environment, "playroom", "--size", "640x360", "--replay", tape, "--expect-hash", expected)
    expect(again.returncode == 0, f"replay: exit {again.returncode}\n{again.stderr}")
    expect(state_of(again) == expected, "another end state")
    brief = str(folder / "brief.tape")
    recorded = play(environment, "playroom", "--size", "320x180", "--random-input", "7", "--seconds", "2", "--record", brief)
    expect(recorded.returncode == 0, recorded.stderr)
    wrong_hash = play(environment, "playroom", "--size", "320x180", "--replay", brief, "--expect-hash", "0123456789abcdef")
    expect(wrong_hash.returncode == 5, f"a wrong hash gives exit {wrong_hash.returncode}")
    other_scene = play(environment, "falling_cube", "--size", "320x180", "--replay", tape)
    expect(other_scene.returncode == 5 and "recorded in the scene playroom.toml, this one is falling_cube.toml" in other_scene.stderr, other_scene.stderr)
    a_killed_session_is_replayed_up_to_there(environment, folder)
