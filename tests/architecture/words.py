#!/usr/bin/python3
"""Fails on paths of somebody's machine and on notes to finish things later."""

import re

from sources import ROOT, finish, own_files

# Taken apart so that this file passes its own test.
MACHINE_PATH = re.compile(r"(?<![\w.])/(ro" r"ot|wo" r"rk|ho" r"me/[a-z]\w*)/")
LATER = re.compile(r"\b(TO" r"DO|FIX" r"ME|X" r"XX)\b")
TEXT = (".h", ".cpp", ".vert", ".frag", ".geom", ".glsl", ".py", ".sh", ".cmake", ".txt", ".md",
        ".toml", ".json", ".yml", ".js", ".css", ".html")
SCRIPTS = ("play", "test", ".ci/run")
FOLDERS = ("engine", "game", "shaders", "tests", "cmake", "config", "docs", "assets")
# Third parties' own words.
EXCEPT = ("assets/CREDITS.md",)


def problems_in(path):
    lines = (ROOT / path).read_text(encoding="utf-8", errors="replace").splitlines()
    for number, line in enumerate(lines, start=1):
        if MACHINE_PATH.search(line):
            yield f"{path}:{number}: a path of one machine: {line.strip()[:90]}"
        if LATER.search(line):
            yield f"{path}:{number}: finish it or open an issue: {line.strip()[:90]}"


if __name__ == "__main__":
    top = ("README.md", "CONTRIBUTING.md", "CMakeLists.txt", "CMakePresets.json")
    files = [path for path in own_files(ROOT, *FOLDERS, suffixes=TEXT) if path not in EXCEPT]
    files += [path for path in SCRIPTS + top if (ROOT / path).is_file()]
    found = [problem for path in files for problem in problems_in(path)]
    finish(found, f"words of {len(files)} files")
