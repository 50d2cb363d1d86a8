#!/usr/bin/python3
"""cmake/packages.txt: every line is a package name or `kind: name`, grouped by kind, none twice."""

import re
import shutil
import subprocess

from sources import ROOT, finish

LINE = re.compile(r"^(?:(test|maybe): )?([a-z0-9][a-z0-9.+-]+)$")
KINDS = ["", "maybe", "test"]  # the order of the groups, sorted by name within each


def read(lines):
    """Problems, and the (kind, name) pairs that could be read."""
    problems, packages = [], []
    for number, line in enumerate(lines, start=1):
        if not line or line.startswith("#"):
            continue
        found = LINE.match(line)
        if found:
            packages.append((found.group(1) or "", found.group(2)))
        else:
            problems.append(f"cmake/packages.txt:{number}: not a package line: {line!r}")
    return problems, packages


def unknown_to_apt(names):
    """Names that this machine's apt does not know. Nothing where apt has no lists to ask."""
    if shutil.which("apt-cache") is None:
        return []
    known = subprocess.run(["apt-cache", "pkgnames"], capture_output=True, text=True,
                           check=False).stdout.split()
    return [name for name in names if name not in set(known)] if len(known) > 10_000 else []


if __name__ == "__main__":
    text = (ROOT / "cmake/packages.txt").read_text(encoding="utf-8")
    found, listed = read(text.splitlines())
    if listed != sorted(listed, key=lambda row: (KINDS.index(row[0]), row[1])):
        found.append("cmake/packages.txt: not sorted: plain names, then maybe:, then test:")
    all_names = [name for _, name in listed]
    found += [f"cmake/packages.txt: {name} is there twice"
              for name in sorted(set(all_names)) if all_names.count(name) > 1]
    required = [name for kind, name in listed if kind != "maybe"]
    found += [f"cmake/packages.txt: apt knows no {name}" for name in unknown_to_apt(required)]
    if len(listed) < 10:
        found.append("cmake/packages.txt: hardly anything in it")
    finish(found, f"{len(listed)} packages")
