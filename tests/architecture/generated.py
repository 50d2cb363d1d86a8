#!/usr/bin/python3
"""Fails where a scene that a script writes is not what the script writes.

The scripts run in a folder of their own, so nothing of the repository is touched.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

from sources import ROOT, finish

SOURCE = "assets/source"
SCENES = "assets/scenes"
# Script -> the file that gets what it prints; None: it writes its files itself.
SCRIPTS = {
    "make_bench_scenes.py": None,
    "make_effect_scenes.py": None,
    "make_fairground.py": "fairground.toml",
    "make_garden.py": "garden.toml",
    "make_hard_scenes.py": None,
    "make_museum.py": "museum.toml",
    "make_peer_scenes.py": None,
    "make_playroom.py": None,
    "make_workshop.py": "workshop.toml",
}


def run(script, printed_to, folder):
    """What is wrong with the run of one script, or None."""
    copy = folder / SOURCE / script
    shutil.copy(ROOT / SOURCE / script, copy)
    for parts in ("hard_*.py", "house_plan.py", "card_house.py", "scene_writer.py", "garden_*.py",
                  "fairground_plan.py"):  # read by others
        for part in (ROOT / SOURCE).glob(parts):
            shutil.copy(part, folder / SOURCE)
    (folder / "assets/data").mkdir(exist_ok=True)
    shutil.copy(ROOT / "assets/data/engine_cases.csv", folder / "assets/data")
    done = subprocess.run([sys.executable, "-B", str(copy)], cwd=folder, capture_output=True,
                          text=True, check=False, timeout=60)
    if done.returncode != 0:
        return f"{SOURCE}/{script}: ended with {done.returncode}: {done.stderr.strip()[-200:]}"
    if printed_to:
        (folder / SCENES / printed_to).write_text(done.stdout, encoding="utf-8")
    return None


def differences(folder):
    """How the repository's scenes differ from those in `folder`; their models and pages too."""
    for made in sorted(folder.rglob("*")):
        if made.suffix not in (".toml", ".obj", ".md"):
            continue
        name = made.relative_to(folder)
        if not (ROOT / name).is_file():
            yield f"{name}: a script writes it, but it is not in the repository"
        elif (ROOT / name).read_bytes() != made.read_bytes():
            yield f"{name}: differs from what its script in {SOURCE} writes: run that again"


def leftovers(folder):
    """Scenes that say a script wrote them, and that none wrote."""
    for scene in sorted((ROOT / SCENES).rglob("*.toml")):
        name = scene.relative_to(ROOT)
        head = scene.read_text(encoding="utf-8")[:400]
        if f"ritten by {SOURCE}/" in head and not (folder / name).is_file():
            yield f"{name}: says that a script wrote it, but none did"


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as text:
        made_in = pathlib.Path(text)
        for below in (SOURCE, SCENES):
            (made_in / below).mkdir(parents=True)
        problems = [run(script, target, made_in) for script, target in SCRIPTS.items()]
        found = [problem for problem in problems if problem]
        found += [*differences(made_in), *leftovers(made_in)]
    finish(found, f"scenes of {len(SCRIPTS)} scripts")
