#!/usr/bin/env python3
"""A recording of a random session plays back bit for bit, at another frame rate; a recording of
another scene is refused."""
import subprocess
import sys

from support import app_settings, expect, home, settings_in, virtual_screen

program_file = sys.argv[1]


def play(environment, *words):
    return subprocess.run([program_file, "play", *words, "--no-sound"], env=environment,
                          capture_output=True, text=True, timeout=120)


def state_of(run):
    lines = [line for line in run.stderr.splitlines() if ", state " in line]
    expect(lines, "no state line:\n" + run.stderr)
    return lines[-1].rsplit(" ", 1)[-1]


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
