#!/usr/bin/env python3
"""What `preset = "auto"` chooses for a budget, judged by a study that it does not see, on ten scenes with three effects or
more:

    budget_scenes.py BUILD [SCENE...]      # 20 minutes for all

Of each scene: a study measures the grid; the budget is the geometric mean of the least and the most cost on its front; a
copy of the scene asks `auto` for that budget, which makes a study of its own; the copy then runs with what it chose.
Prints a table for docs/ACCURACY.md: CPU time over budget, and error over the least error that the first study saw for
at most the budget."""
import json
import math
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SCENES = HERE.parents[2] / "assets/scenes"
NAMES = ["garden", "cloth", "museum", "pond", "smash", "workshop", "ferry",
         *(f"{HERE.name}/{file.stem}" for file in sorted(HERE.glob("*.toml")))]
SECONDS, RUNS = 3, 5
CHOSEN = re.compile(r'preset "auto" (?:for|found nothing).*?(?:frame: |saw is )(.*): ([\d.e-]+) % off, ([\d.]+) ms')


def cost_ms(point):
    return point["cost"]["ms_per_s_min"] / 60


def error(point):
    return max(abs(each) for each in point["errors"])


def usable(point):
    """Measured, and of the precision that the program has."""
    return (point["status"] == "done" and point["cost"]["repeats"] > 0 and point["setting"]["precision"] == "float32"
            and all(isinstance(each, (int, float)) for each in point["errors"]))


def front(points):
    best = []
    for point in sorted(points, key=lambda each: (cost_ms(each), error(each))):
        if not best or error(point) < error(best[-1]):
            best.append(point)
    return best


def with_budget(text, budget_ms):
    """The scene's text with an [accuracy] that asks for the budget and nothing else."""
    text = re.sub(r"(?m)^\[accuracy\]\n(?:(?!\[).*\n)*", "", text)
    return f'{text}\n[accuracy]\npreset = "auto"\nbudget_ms = {budget_ms:.6g}\n'


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, arguments))}: {done.stderr}")
    return done


def cpu_s(program, file, seconds):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run(program, "simulate", file, "--seconds", seconds)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def judged(program, scenes, name):
    """Budget, setting, ms of a run of it, its error, and the least error that the budget could have bought."""
    file = scenes / f"{name}.toml"
    out = scenes / "study"
    run(program, "study", file, "--seconds", SECONDS, "--out", out)
    points = [each for each in json.loads((out / "findings.json").read_text())["subjects"][0]["points"] if usable(each)]
    best = front(points)
    budget_ms = math.sqrt(cost_ms(best[0]) * cost_ms(best[-1]))
    file.write_text(with_budget(file.read_text(), budget_ms))
    said = run(program, "simulate", file, "--seconds", SECONDS).stderr
    chosen = CHOSEN.search(said)
    if not chosen:
        return budget_ms, said.strip().splitlines()[-1], math.nan, math.nan, math.nan
    # The chosen setting's own CPU time: less what loading takes.
    least_s = [min(cpu_s(program, file, seconds) for _ in range(RUNS)) for seconds in (SECONDS, 1 / 60)]
    took_ms = 1e3 * (least_s[0] - least_s[1]) / (60 * SECONDS)
    least = min((error(each) for each in points if cost_ms(each) <= budget_ms), default=math.nan)
    return budget_ms, chosen[1], took_ms, float(chosen[2]) / 100, least


def main():
    program = pathlib.Path(sys.argv[1]).resolve() / "game/plumbline"
    names = sys.argv[2:] or NAMES
    print("| scene | budget, ms a frame | what auto chose | cost over budget | its error, % | over the least that fits |")
    print("|---|--:|---|--:|--:|--:|")
    within = accurate = 0
    for name in names:
        with tempfile.TemporaryDirectory() as folder:
            os.environ["XDG_CACHE_HOME"] = os.environ["XDG_DATA_HOME"] = folder
            scenes = pathlib.Path(folder) / "scenes"
            shutil.copytree(SCENES, scenes)
            shutil.copytree(HERE, scenes / HERE.name)
            game = (scenes / "games/ferry.toml").read_text()
            (scenes / "ferry.toml").write_text(game.replace('"../', '"'))  # to what it includes
            budget_ms, setting, took_ms, off, least = judged(program, scenes, name)
        within += took_ms <= budget_ms
        accurate += off < 2 * least
        print(f"| {pathlib.Path(name).name} | {budget_ms:.3g} | {setting} | {took_ms / budget_ms:.2f} | {100 * off:.3g} "
              f"| {off / least:.2f} |", flush=True)
    print(f"\nWithin the budget: {within} of {len(names)}. No other choice with less than half the error: "
          f"{accurate} of {len(names)}.")


main()
