#!/usr/bin/python3
"""Modules that both programs link must not depend on Real, which differs between them.

plumbline_module(NAME ANY_PRECISION ...) builds one library; a source of it that used Real, or a type
made of it, would lay out its data as float in a program that keeps double.
"""

import re

from sources import ROOT, finish, own_files

DEPENDS = re.compile(r"\b(Real|Vec[234]|Mat[34]|Quat|Pose|kPi|kNoRotation|kPrecisionName)\b|\d_r\b")
COMMENT = re.compile(r"//.*")
INCLUDE = re.compile(r'#include "(engine/[^"]+)"')
MAY_SAY_IT = "engine/core/math.h"  # where the words are defined


def modules():
    for path in sorted((ROOT / "engine").glob("*/CMakeLists.txt")):
        found = re.search(r"plumbline_module\((\w+) ANY_PRECISION", path.read_text(encoding="utf-8"))
        if found:
            yield found.group(1)


def reached(name, seen):
    """`name` and all that it includes of ours."""
    if name not in seen and (ROOT / name).is_file():
        seen.add(name)
        for included in INCLUDE.findall((ROOT / name).read_text(encoding="utf-8")):
            reached(included, seen)
    return seen


def problems_of(name):
    for reach in sorted(reached(name, set()) - {MAY_SAY_IT}):
        text = (ROOT / reach).read_text(encoding="utf-8")
        for number, line in enumerate(text.splitlines(), start=1):
            found = DEPENDS.search(COMMENT.sub("", line))
            if found:
                yield (f"{reach}:{number}: {found.group(0)} differs between the programs that link "
                       f"{name}")


if __name__ == "__main__":
    checked = [name for module in modules()
               for name in own_files(ROOT, f"engine/{module}", suffixes=(".cpp",))]
    found_problems = [problem for name in checked for problem in problems_of(name)]
    if len(checked) < 20:
        found_problems.append("hardly a file found: does plumbline_module still say ANY_PRECISION?")
    finish(found_problems, f"{len(checked)} sources for any precision")
