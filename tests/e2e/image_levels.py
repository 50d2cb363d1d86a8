#!/usr/bin/env python3
"""Levels of the image that change every second for a minute or more. FAULTS J5."""
import pathlib
import re
import sys
import time

from support import Program, app_settings, expect, home, settings_in, virtual_screen

program_file = sys.argv[1]


def rss_kib(game):
    status = pathlib.Path(f"/proc/{game.process.pid}/status").read_text()
    return int(re.search(r"VmRSS:\s+(\d+)", status)[1])


def levels_that_change_every_second(folder, environment):
    """What the levels need is there after the first rounds, of which a slow machine takes more; then memory stays."""
    settings = folder / "config/plumbline/app.toml"
    game = Program([program_file, "play", "garden", "--size", "320x180", "--no-sound"], environment, folder / "levels.txt")
    held = []

    def grown():
        middle, end = (max(part) for part in (held[-40:-20], held[-20:]))
        return end >= 1.04 * middle

    try:
        while len(held) < 60 or grown() and len(held) < 100:
            level = ("low", "medium", "high", "auto")[len(held) % 4]
            settings.write_text(app_settings(f'[image]\nlevel = "{level}"\n'))
            time.sleep(1)
            expect(game.process.poll() is None, f"it ended at level {level}:\n{game.log()}")
            held.append(rss_kib(game))
        log = game.log()
    finally:
        game.stop()
    expect("error" not in log, log)
    expect(not grown(), f"memory grows: {held} KiB")


with virtual_screen() as screen, home() as folder:
    levels_that_change_every_second(folder, settings_in(folder, screen))
