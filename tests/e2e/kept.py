#!/usr/bin/env python3
"""What a person made is kept: a scene that is saved while it runs is read again, and a fault in it
leaves the running one; the recording and the report outlive the X server; a study that cannot run
leaves the results of the one before."""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

from support import Program, expect, home, read_json, settings_in, virtual_screen

program_file = pathlib.Path(sys.argv[1])


def cube(name, x):
    return f"""[[entity]]
name = "{name}"
position_m = [{x}, 5, 0]
primitive = {{ box = [1, 1, 1] }}
[entity.body]
kind = "dynamic"
"""


SCENE = """[scene]
title = "one cube"
[camera]
position_m = [0, 3, 8]
target_m = [0, 1, 0]
""" + cube("cube", 0)
SECOND = SCENE + cube("another", 3)


def wait_for(game, text, times=1):
    for _ in range(100):
        if game.log().count(text) >= times:
            return
        time.sleep(0.1)
    raise AssertionError(f"\"{text}\" was not said {times} times:\n{game.log()}")


def a_scene_is_saved_while_it_runs(folder):
    """EXPERIENCE F21; then the X server goes (EXPERIENCE A6)."""
    scene = folder / "cube.toml"
    scene.write_text(SCENE)
    tape = folder / "session.tape"
    report = folder / "report.json"
    with virtual_screen() as screen:
        game = Program([program_file, "play", str(scene), "--size", "320x180", "--no-sound",
                        "--record", str(tape), "--report", str(report)],
                       settings_in(folder, screen), folder / "log.txt")
        try:
            time.sleep(1)
            scene.write_text(SCENE.replace('kind = "dynamic"', 'kind = "dynamo"'))
            wait_for(game, "cube.toml:11:8: error: entity[0].body.kind")
            expect(game.process.poll() is None, "it ended over a typing error")
            scene.write_text(SECOND)
            time.sleep(3)
        except BaseException:
            game.stop()
            raise
    # The server has gone with its block.
    code = game.wait(20)
    expect(code == 1, f"exit code {code} without a display:\n{game.log()}")
    expect(read_json(report)["bodies"] == 2, "the report is not of the scene that was saved last")
    with virtual_screen() as screen:
        again = subprocess.run([program_file, "play", str(scene), "--size", "320x180", "--no-sound",
                                "--replay", str(tape)], env=settings_in(folder, screen),
                               capture_output=True, text=True, timeout=60)
        expect(again.returncode == 0, f"replay: exit {again.returncode}\n{again.stderr}")


def grid(triangles):
    """An OBJ of so many triangles beside each other."""
    corners = "".join(f"v {i} 0 0\nv {i} 1 0\nv {i + 1} 0 0\n" for i in range(triangles))
    return corners + "".join(f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}\n" for i in range(triangles))


def a_model_is_saved_while_it_is_shown(folder):
    """FAULTS 28: what is shown is the file as it was saved last; garbage leaves what was shown."""
    model, report = folder / "model.obj", folder / "model.json"
    model.write_text(grid(3))
    with virtual_screen() as screen:
        game = Program([program_file, "play", str(model), "--size", "320x180", "--no-sound", "--report", str(report)],
                       settings_in(folder, screen), folder / "model.txt")
        try:
            time.sleep(2)
            model.write_text(grid(40))
            time.sleep(2)
            model.write_text("garbage")
            time.sleep(2)
            game.do("windowfocus", game.window)
            expect(game.process.poll() is None, "it ended over garbage")
            game.process.send_signal(signal.SIGTERM)
            expect(game.wait(20) == 130, game.log())
        finally:
            game.stop()
    triangles = read_json(report)["triangles"]
    # The report is of the last frame: the ground of 2 in up to three parts, and up to four shadow maps.
    expect(40 <= triangles <= 40 + 6 + 4 * 42,
           f"{triangles} triangles drawn: not the 40 that were saved, with the ground; with 3 it is 29 at most")


def a_study_without_its_worker(folder):
    alone = folder / "alone"
    alone.mkdir()
    program = alone / "plumbline"
    shutil.copy(program_file, program)
    out = folder / "results"
    out.mkdir()
    (out / "findings.csv").write_text("of last week\n")
    environment = {**settings_in(folder, os.environ), "PLUMBLINE_DATA": os.getcwd()}
    for words in (["A01"], ["falling_cube"]):
        run = subprocess.run([program, "study", *words, "--out", str(out)], env=environment,
                             capture_output=True, text=True, timeout=60)
        expect(run.returncode == 1, f"exit {run.returncode}: {run.stderr}")
        lines = [line for line in run.stderr.splitlines() if line]
        expect(len(lines) == 1 and "plumbline-f64, which is not there; ./play builds it" in lines[0], run.stderr)
        expect((out / "findings.csv").read_text() == "of last week\n", "the old results are gone")
        expect(sorted(os.listdir(out)) == ["findings.csv"], f"left behind: {os.listdir(out)}")


def a_study_that_is_killed(folder):
    out = folder / "killed"
    out.mkdir()
    (out / "findings.csv").write_text("of last week\n")
    # All scenarios take minutes: the study is in the midst of them when it is killed.
    study = subprocess.Popen([program_file, "study", "--out", str(out)],
                             env=settings_in(folder, os.environ),
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(1)
    study.send_signal(signal.SIGKILL)
    expect(study.wait() == -signal.SIGKILL, "it had ended before")
    expect((out / "findings.csv").read_text() == "of last week\n", "the old results are gone")


with home() as folder:
    a_scene_is_saved_while_it_runs(folder)
    a_model_is_saved_while_it_is_shown(folder)
    a_study_without_its_worker(folder)
    a_study_that_is_killed(folder)
