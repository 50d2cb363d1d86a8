#!/usr/bin/python3
"""Links of README.md, CONTRIBUTING.md and docs/: the file is there, in the repository, and has the heading that a #part names.

Links to other hosts are not followed.
"""

import pathlib
import re
import sys

from sources import ROOT, finish, own_files

LINK = re.compile(r"(?<!\\)\]\(\s*<?([^)\s>]+)>?[^)]*\)|\b(?:src|href)=\"([^\"]+)\"")
HEADING = re.compile(r"^#{1,6} +(.+?) *#*$", re.MULTILINE)
FENCED = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
ELSEWHERE = re.compile(r"[a-z][a-z0-9+.-]*:")


def anchor_of(heading):
    """As hosts of repositories make it from a heading's text."""
    plain = re.sub(r"[`*_]|\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")


def pages(root):
    return own_files(root, "README.md", "CONTRIBUTING.md", "docs", "assets/CREDITS.md", suffixes=(".md",))


def problems_of(root, page, files):
    text = (root / page).read_text(encoding="utf-8")
    code = FENCED.sub(lambda found: "\n" * found.group(0).count("\n"), text)
    for number, line in enumerate(code.splitlines(), start=1):
        for found in LINK.finditer(re.sub(r"`[^`]*`", "", line)):
            target = found.group(1) or found.group(2)
            if ELSEWHERE.match(target):
                continue
            path, _, part = target.partition("#")
            there = (root / page).parent / path if path else root / page
            name = str(there.resolve().relative_to(root.resolve())) if there.resolve().is_relative_to(root.resolve()) else ""
            if not name or name not in files and not any(file.startswith(name + "/") for file in files):
                yield f"{page}:{number}: {target} is not there"
            elif part and part not in {anchor_of(heading) for heading in HEADING.findall(there.read_text(encoding="utf-8"))}:
                yield f"{page}:{number}: {path or page} has no heading #{part}"


def check(root):
    files = set(own_files(root, "."))
    found = pages(root)
    return [problem for page in found for problem in problems_of(root, page, files)], f"links of {len(found)} pages"


if __name__ == "__main__":
    checked_root = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    finish(*check(checked_root))
