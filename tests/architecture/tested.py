#!/usr/bin/python3
"""Every source that decides something has a test: in the mirrored place, or one that includes its header.

tests/engine/x/y_test.cpp is the mirrored place of engine/x/y.cpp; y_gl_test.cpp is as good. A decision is an if, for,
while, switch or question mark outside comments and texts.
"""

import pathlib
import re
import sys

from sizes import blanked
from sources import ROOT, finish, own_files

DECISIONS = 3  # from so many on

# Sources that need none, and why. An entry that is not needed any more fails, so that it goes.
EXEMPT = {
    "engine/app/frame/apply_requests.cpp": "of a running window: e2e menu.py, replay.py",
    "engine/app/frame/film.cpp": "of a running window: e2e films.py",
    "engine/app/frame/frame.cpp": "of a running window: e2e window.py, window_faults.py",
    "engine/app/frame/input_phase.cpp": "of a running window: e2e menu.py, window.py",
    "engine/app/frame/present_phase.cpp": "of a running window: e2e window.py",
    "engine/app/frame/sound_phase.cpp": "of a running window: e2e sound.py",
    "engine/app/frame/view_phase.cpp": "of a running window: e2e window.py, films.py",
    "engine/app/offscreen_run.cpp": "renders a whole run: e2e image_levels.py, models.py",
    "engine/app/overlay/overlay.cpp": "needs a window; its parts have their tests: e2e window.py, menu.py",
    "engine/render/passes/scene_light.cpp": "binds what others made: occlusion, shaft and focus GL tests",
    "game/commands/study/effects_command.cpp": "renders in turns with the shipped shaders: e2e study_scene.py",
    "game/commands/study/image_study_command.cpp": "renders with the shipped shaders: e2e study_scene.py",
    "game/commands/play_command.cpp": "opens the window: e2e window.py, menu.py, saved.py",
    "game/commands/study/scene_study_command.cpp": "runs and keeps a whole study: e2e study_scene.py",
    "game/commands/shader_worker.cpp": "a process of its own: e2e shaders.py",
    "game/main.cpp": "the program itself: e2e command_line.py, process.py",
    "game/main_f64.cpp": "the program itself: e2e process.py",
    "game/offscreen/offscreen_studio.cpp": "renders with the shipped shaders: e2e films.py, image_levels.py",
}

# Sources that have none yet. This list only gets shorter.
NOT_YET = set()

DECISION = re.compile(r"\b(?:if|for|while|switch)\b|\?")
INCLUDE = re.compile(r'^#include "((?:engine|game)/[^"]+)"', re.MULTILINE)


def decisions_in(text):
    return len(DECISION.findall(blanked(text)))


def untested(root):
    """Sources with too many decisions for having no test, and how many sources there are with so many."""
    tests = set(own_files(root, "tests", suffixes=(".cpp", ".h")))
    included = {header for test in tests for header in INCLUDE.findall((root / test).read_text(encoding="utf-8"))}
    without, deciding = set(), 0
    for source in own_files(root, "engine", "game", suffixes=(".cpp",)):
        if decisions_in((root / source).read_text(encoding="utf-8")) < DECISIONS:
            continue
        deciding += 1
        stem = source[:-len(".cpp")]
        is_mirrored = any(f"tests/{stem}{end}" in tests for end in ("_test.cpp", "_gl_test.cpp"))
        if not is_mirrored and f"{stem}.h" not in included:
            without.add(source)
    return without, deciding


def check(root, exempt, not_yet):
    """Every problem in the tree at `root`, and what was looked at in words."""
    without, deciding = untested(root)
    problems = [f"{source}: decides something and has no test: write tests/{source[:-len('.cpp')]}_test.cpp"
                for source in sorted(without - set(exempt) - not_yet)]
    for name, entries in (("EXEMPT", set(exempt)), ("NOT_YET", not_yet)):
        problems += [f"tests/architecture/tested.py: {source} needs no entry any more: strike it off {name}"
                     for source in sorted(entries - without)]
    return problems, f"{deciding} sources with {DECISIONS} decisions or more"


if __name__ == "__main__":
    checked_root = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    finish(*check(checked_root, EXEMPT, NOT_YET))
