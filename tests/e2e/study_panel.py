#!/usr/bin/env python3
"""The accuracy panel in a window: a click studies the scene from where it is, in processes beside the game, and what was
measured is kept; another stops it; the image's levels likewise. A saved game is studied the same from the command line."""
import subprocess
import sys

from support import Program, expect, home, read_json, settings_in, virtual_screen

program_file = sys.argv[1]
SCENE = "bench/peers/heavy10"
X = 930  # of the panel's buttons, in a window of 1280 x 720
ROWS = range(216, 260, 8)  # where "Study from here" may be


def main():
    with virtual_screen() as screen, home() as folder:
        environment = settings_in(folder, screen)
        scratch = folder / "scratch"
        scratch.mkdir()
        environment |= {"TMPDIR": str(scratch), "XDG_CACHE_HOME": str(folder / "cache")}
        game = Program([program_file, "--no-sound", "play", SCENE, "--size", "1280x720"], environment,
                       folder / "log.txt")
        try:
            studies = folder / "cache/plumbline/study"
            game.ready(folder / "data/plumbline/shots")
            game.press("Tab", 1, 1.0)
            kept = study(game, scratch, studies)
            study_and_stop(game, scratch)
            game.press("F5", 1, 0.5)
            saved = game.until(lambda: list((folder / "data/plumbline/saves").rglob("*.save")), "no saved game")[0]
            game.press("Escape", 1, 0.7)
        finally:
            game.stop()
        check(kept)
        studied_from(saved, environment, folder)


def click(game, y):
    game.do("mousemove", X, y)
    game.do("click", 1)


def begin(game, scratch):
    for y in ROWS:
        click(game, y)
        try:
            return game.until(lambda: list(scratch.glob("plumbline-study-*/start")), "no study", 1.5) and y
        except AssertionError:
            continue
    raise AssertionError("no click on the panel began a study")


def study(game, scratch, studies):
    begin(game, scratch)
    file = game.until(lambda: list(studies.glob("*.json")), "no study was kept", 90)[0]
    game.until(lambda: not list(scratch.glob("plumbline-study-*")), "its state stays", 5)
    return read_json(file)


def study_and_stop(game, scratch):
    y = begin(game, scratch)
    click(game, y)
    game.until(lambda: not list(scratch.glob("plumbline-study-*")), "it does not stop", 5)


def check(kept):
    expect(kept["from_s"] > 0, f"it began at {kept['from_s']} s")
    points = kept["subject"]["points"]
    expect(len(points) >= 6, f"{len(points)} settings")
    expect(any(point["errors"] for point in points), "no errors")


def studied_from(saved, environment, folder):
    run = subprocess.run([program_file, "study", SCENE, "--load", str(saved), "--seconds", "0.3", "--tolerance", "0.05"],
                         env=environment, capture_output=True, text=True, timeout=200)
    expect(run.returncode == 0, run.stderr)
    expect("solver = " in run.stdout, run.stdout)
    refused = subprocess.run([program_file, "study", "A20", "--load", str(saved)], env=environment, capture_output=True,
                             text=True, timeout=60)
    expect(refused.returncode == 2 and "--load needs one scene" in refused.stderr, refused.stderr)


main()
