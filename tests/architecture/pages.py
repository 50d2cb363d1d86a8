#!/usr/bin/python3
"""docs/ARCHITECTURE.md against the tree: one line for each folder of sources, and walks whose every step is there.

A walk goes from module to module and never comes back to one: what is above is not asked again from below.
"""

import pathlib
import re

from sources import ROOT, finish, own_files

PAGE = "docs/ARCHITECTURE.md"
FOLDER = re.compile(r"^((?:engine|game|tests)/\S*) {1,}(\S.*)$", re.MULTILINE)
WALK = re.compile(r"^### (.+)$", re.MULTILINE)
STEP = re.compile(r"^(\d+)\. `([^`]+)` `([^`]+)`: \S", re.MULTILINE)
WALKS = 4


def section(text, heading):
    """What stands under a heading of the second level, or nothing."""
    found = re.search(rf"^## {re.escape(heading)}$(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    return found.group(1) if found else ""


def folders(root):
    """Folders of sources: all of engine/ and game/, of tests/ those that mirror none of these."""
    files = own_files(root, "engine", "game", suffixes=(".h", ".cpp"))
    found = {str(pathlib.PurePosixPath(path).parent) + "/" for path in files}
    for path in own_files(root, "tests", suffixes=(".h", ".cpp", ".py")):
        parts = pathlib.PurePosixPath(path).parts
        if len(parts) > 2 and parts[1] not in ("engine", "game"):
            found.add(f"tests/{parts[1]}/")
    return found


def problems_with_folders(root, text):
    listed = [match.group(1) for match in FOLDER.finditer(text)]
    for folder in sorted(folders(root) - set(listed)):
        yield f"{PAGE}: no line for {folder}"
    for folder in sorted(set(listed)):
        if listed.count(folder) > 1:
            yield f"{PAGE}: {folder} has {listed.count(folder)} lines"
        if folder not in folders(root):
            yield f"{PAGE}: {folder} is no folder of sources"


def module_of(path):
    parts = pathlib.PurePosixPath(path).parts
    return parts[1] if parts[0] == "engine" else parts[0]


def problems_with_walk(root, name, text):
    steps = STEP.findall(text)
    if [int(number) for number, _, _ in steps] != list(range(1, len(steps) + 1)) or len(steps) < 4:
        yield f"{PAGE}: {name}: its steps are not numbered `file` `function`: …"
    modules = []
    for _, path, function in steps:
        if not (root / path).is_file():
            yield f"{PAGE}: {name}: {path} is not there"
            continue
        if not re.search(rf"(?<!\w){re.escape(function)}\(", (root / path).read_text(encoding="utf-8")):
            yield f"{PAGE}: {name}: {path} has no {function}()"
        if not modules or modules[-1] != module_of(path):
            modules.append(module_of(path))
    for module in sorted({module for module in modules if modules.count(module) > 1}):
        yield f"{PAGE}: {name}: comes back to {module}"


def check(root):
    text = (root / PAGE).read_text(encoding="utf-8")
    problems = list(problems_with_folders(root, section(text, "Folders")))
    walks = WALK.split(section(text, "Four walks"))[1:]
    if len(walks) != 2 * WALKS:
        problems.append(f"{PAGE}: {len(walks) // 2} walks; expected {WALKS}")
    for name, walk in zip(walks[::2], walks[1::2]):
        problems += problems_with_walk(root, name, walk)
    return problems


if __name__ == "__main__":
    finish(check(ROOT), f"folders and walks of {PAGE}")
